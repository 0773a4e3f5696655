// SPDX-License-Identifier: BSD-3-Clause
#include "name_series.hpp"

#include <algorithm>
#include <map>
#include <string>

#include "exact_decimal.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
namespace {

/// Images of a series by their numbers, as texts.
using Series = std::map<std::string, fs::path>;

/// The images by their names without the last run of digits, which is the number of the frame.
std::map<std::string, Series> seriesOf(const std::vector<fs::path>& images, std::size_t most) {
  std::map<std::string, Series> all;
  for (const fs::path& image : images) {
    const std::string name = image.stem().string();
    const auto last = std::find_if(name.rbegin(), name.rend(), isDigit).base();
    const auto first = std::find_if_not(std::reverse_iterator(last), name.rend(), isDigit).base();
    all[std::string(name.begin(), first) + "#" + std::string(last, name.end())].emplace(
        std::string(first, last), image);
    if (all.size() > most) break;
  }
  return all;
}

}  // namespace

std::optional<std::pair<fs::path, fs::path>> twoOfOneNumber(const std::vector<fs::path>& images) {
  constexpr std::size_t kMost = 8;  // cameras; names with times have many more. Chosen, not fitted
  const auto all = seriesOf(images, kMost);
  if (all.size() < 2 || all.size() > kMost) return std::nullopt;
  const Series& first = all.begin()->second;
  std::optional<std::pair<fs::path, fs::path>> found;
  for (auto other = std::next(all.begin()); other != all.end(); ++other) {
    std::size_t shared = 0;
    for (const auto& [number, image] : other->second) {
      const auto same = first.find(number);
      if (same == first.end()) continue;
      ++shared;
      if (!found) found.emplace(same->second, image);
    }
    if (shared < 2 || 2 * shared < std::max(first.size(), other->second.size())) {
      return std::nullopt;
    }
  }
  return found;
}

}  // namespace tolman::image_folders
