// SPDX-License-Identifier: BSD-3-Clause
// Suggests a known name for a misspelt one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tolman::config {

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

}  // namespace tolman::config
