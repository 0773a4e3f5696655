// SPDX-License-Identifier: BSD-3-Clause
// ASCII digits and letters, independent of the locale.
#pragma once

namespace tolman::config {

constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

}  // namespace tolman::config
