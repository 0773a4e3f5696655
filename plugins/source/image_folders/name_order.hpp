// SPDX-License-Identifier: BSD-3-Clause
// The order of images by their names.
//
// The natural order, in which digits are whole numbers, is right for all common names. Where the
// names are read as numbers instead (with sign, decimals and exponent, or as hexadecimal ones) and
// this gives another order, it is in doubt, and one of the orders is taken:
// - hexadecimal, if hexadecimalOrder() applies;
// - by the numbers, unless two names are the same number (1.1 and 1.10 are the first and the tenth
//   image of a series), or only some have digits joined by two points (1.2 and 1.2.3);
// - otherwise the natural order.
// It is also in doubt where commas before three digits may separate thousands, or where '_', a
// blank, an apostrophe or a point stands between digits of all names only as thousands are
// separated, and where a dash behind a letter may be a sign that other names lack.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace tolman::image_folders {

struct NameOrder {
  enum class Reading { Natural, Numbers, Hexadecimal };
  using Pair = std::pair<std::size_t, std::size_t>;

  std::vector<std::size_t> indices;  ///< of the names, in the order that is taken
  Reading reading = Reading::Natural;
  /// Two names, in the order that is taken, of which another reading has the second first.
  std::optional<Pair> doubt;
  /// Two different names of the same numbers and text, such as 1.1 and 1.10, 1 and 01, a and A.
  std::optional<Pair> same;
  /// Names of other text than that of more than half of the names, such as a preview among numbers.
  std::vector<std::size_t> strays;
};

/// The order of names without extension. Names that are given twice stay next to each other.
NameOrder orderNames(const std::vector<std::string>& stems);

}  // namespace tolman::image_folders
