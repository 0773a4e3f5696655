// SPDX-License-Identifier: BSD-3-Clause
// The name of an image without extension, as text with numbers in it.
#pragma once

#include <string>
#include <string_view>

namespace tolman::image_folders {

/// Numbers have a fraction (after a point or a comma), an exponent with sign, and a sign: "-1.5",
/// "t_-1.5e-05s". A sign follows nothing but a separator other than a dash, so "cam-3" and
/// "2024-01-02" have none. Where more than one point joins digits ("12.30.05"), each run of digits
/// is a whole number.
struct ImageName {
  std::string stem;
  std::string text;          ///< with each number as one 0
  std::string key;           ///< compares, byte by byte, as the text with its numbers does
  bool has_version = false;  ///< has digits joined by more than one point, such as 1.2.3
};

/// Upper case counts as lower case, digits of other scripts as 0 to 9, U+2212 and other
/// dashes as '-', and blanks at
/// the ends do not count. If `numeric`, names that are one number as a whole may have an exponent
/// without sign
/// ("1e5").
ImageName parseImageName(std::string_view stem, bool numeric);

/// Whether digits, that is whole numbers, and bytes are less: "image2" < "image10", "1.1" < "1.05".
/// A total order.
bool naturalLess(std::string_view a, std::string_view b);

/// Latin digits, and the apostrophes and blanks that separate thousands in some countries as those
/// of ASCII.
std::string withPlainSeparators(std::string_view stem);

/// As parseImageName() folds a name, with '_' between a letter and the first number with its sign:
/// "t_-1.5" of "t-1.5", where parseImageName() finds a sign.
std::string withSignsApart(std::string_view stem);

/// The text without commas, or another `separator`, that may separate thousands: "1,024" becomes
/// "1024", "1,5" stays.
std::string withoutThousands(std::string_view text, char separator = ',');

}  // namespace tolman::image_folders
