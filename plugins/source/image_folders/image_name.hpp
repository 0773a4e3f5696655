// SPDX-License-Identifier: BSD-3-Clause
// The name of an image without extension, as text with numbers in it.
#pragma once

#include <compare>
#include <string>
#include <string_view>
#include <vector>

#include "exact_decimal.hpp"

namespace tolman::image_folders {

/// A character that belongs to no number, or a number.
struct NamePart {
  static constexpr char kNumber = '0';  ///< so numbers have the place of digits among characters
  char text = kNumber;
  ExactDecimal number;

  std::weak_ordering operator<=>(const NamePart& other) const;
  bool operator==(const NamePart& other) const { return (*this <=> other) == 0; }
};

/// Numbers have a fraction (after a point or a comma), an exponent with sign, and a sign: "-1.5",
/// "t_-1.5e-05s". A sign follows nothing but a separator other than a dash, so "cam-3" and
/// "2024-01-02" have none. Where more than one point joins digits ("12.30.05"), each run of digits
/// is a whole number.
struct ImageName {
  std::string stem;
  std::vector<NamePart> parts;
  bool has_version = false;  ///< has digits joined by more than one point, such as 1.2.3
};

/// Upper case counts as lower case, digits of other scripts as 0 to 9, and blanks at the ends do
/// not count. If `numeric`, names that are one number as a whole may have an exponent without sign
/// ("1e5").
ImageName parseImageName(std::string_view stem, bool numeric);

/// The order of names by their parts; equivalent: the same but for the way of writing.
std::weak_ordering compareParts(const ImageName& a, const ImageName& b);

/// Whether digits, that is whole numbers, and bytes are less: "image2" < "image10", "1.1" < "1.05".
/// A total order.
bool naturalLess(std::string_view a, std::string_view b);

/// The text without commas that may separate thousands: "1,024" becomes "1024", "1,5" stays.
std::string withoutThousands(std::string_view text);

/// Whether two names differ in leading zeros of their digits only.
bool sameButForZeros(std::string_view a, std::string_view b);

}  // namespace tolman::image_folders
