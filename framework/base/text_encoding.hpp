// SPDX-License-Identifier: BSD-3-Clause
// Whether a file is text in UTF-8, as all readers of text need it. Editors and PowerShell save
// UTF-16, whose characters have zero bytes between them; a reader would blame a line or a number.
#pragma once

#include <string>
#include <string_view>

namespace tolman::text_encoding {

/// What keeps a text from being read as UTF-8, with the remedy: "is UTF-16; save it as UTF-8",
/// UTF-32 likewise (by the byte order mark, or by where the zero bytes are), or a zero byte and its
/// line. Empty for a sound text. Other bytes that are no UTF-8 are not looked for.
std::string encodingProblem(std::string_view text);

/// Removes the byte order mark that some editors write before UTF-8.
std::string_view withoutMark(std::string_view text);

}  // namespace tolman::text_encoding
