// SPDX-License-Identifier: BSD-3-Clause
// The order of files whose names contain numbers.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tolman::image_folders {

inline bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// Runs of digits compare as whole numbers: "image2" < "image10". A total order.
bool naturalLess(std::string_view a, std::string_view b);

/// Whether two names differ in leading zeros of their numbers only.
bool sameButForZeros(std::string_view a, std::string_view b);

/// Whether the names are decimal numbers after a common prefix, some with a decimal point
/// ("cam_1.05", "cam_1.1"). False if two of them are equal as numbers: 1.1 and 1.10 are then the
/// first and the tenth image of a series.
bool areDecimals(const std::vector<std::string>& names);

/// Compares names for which areDecimals() holds, by value: "1.05" < "1.1".
bool decimalLess(std::string_view a, std::string_view b);

}  // namespace tolman::image_folders
