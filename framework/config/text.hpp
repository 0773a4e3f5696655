// SPDX-License-Identifier: BSD-3-Clause
// Names and texts: the nearest known name, names of enumerations, printable text.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/named_value.hpp"

namespace tolman::config {

// ASCII, independent of the locale.
constexpr bool isDigit(char c) { return c >= '0' && c <= '9'; }
constexpr bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

using tolman::valueNamed;

/// Optimal string alignment distance: insertions, deletions, replacements and swaps of neighbours
/// that turn one name into the other. Ignores case; '-' equals '_'.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The candidate with the smallest distance, if that is at most 2 or a third of the length. The
/// first of equal ones.
std::optional<std::string> nearestName(std::string_view name,
                                       std::span<const std::string> candidates);

/// "; did you mean 'x'?", or nothing.
std::string didYouMean(std::string_view name, std::span<const std::string> candidates);

/// "a, b, c".
std::string listed(std::span<const std::string> names);

/// Whether all characters are printable: UTF-8 without control characters, which terminals, XML
/// and JSON can show. True for an empty text.
bool isPrintable(std::string_view text);

/// Replaces each control character and each byte that is not UTF-8 by `instead` (U+FFFD); keeps
/// line feeds and tabulators.
std::string printable(std::string_view text, std::string_view instead = "\xef\xbf\xbd");

}  // namespace tolman::config
