// SPDX-License-Identifier: BSD-3-Clause
// Names of files that end in hexadecimal numbers: frame_09, frame_0a.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace tolman::image_folders {

/// Indices of the names in the order of these numbers, each after its text; other names come after
/// those without text. A number behind a letter begins with 0 to 9 ("frame0a", not "e0a"), except
/// behind 0x. Empty unless more than half of the names end in hexadecimal numbers of one length of
/// at least two digits, none with the same text in one of another length, and one of them has a
/// letter behind a digit and is no decimal number.
std::vector<std::size_t> hexadecimalOrder(const std::vector<std::string>& stems);

}  // namespace tolman::image_folders
