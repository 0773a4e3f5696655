// SPDX-License-Identifier: BSD-3-Clause
// Decimal digits of other scripts than Latin in names of files.
#pragma once

#include <string>
#include <string_view>

namespace tolman::image_folders {

/// The text (UTF-8) with the digits of Arabic, Persian, Indian, Thai, Lao, Tibetan, Burmese and
/// Khmer scripts, and those of full width, as 0 to 9. All other bytes are copied.
std::string withLatinDigits(std::string_view text);

}  // namespace tolman::image_folders
