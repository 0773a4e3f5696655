// SPDX-License-Identifier: BSD-3-Clause
// Which known name a mistyped one is likely to mean.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace tolman::config {

/// Insertions, deletions, replacements and swaps of neighbours that turn one name into the other
/// (optimal string alignment). Capitals count as small letters, '-' as '_'.
std::size_t editDistance(std::string_view a, std::string_view b);

/// The nearest candidate, if it is near enough to be meant: at most a third of the letters differ,
/// or two. Of equals the first.
std::optional<std::string> nearestName(std::string_view name,
                                       std::span<const std::string> candidates);

/// "; did you mean 'x'?", or nothing.
std::string didYouMean(std::string_view name, std::span<const std::string> candidates);

/// "a, b, c".
std::string listed(std::span<const std::string> names);

}  // namespace tolman::config
