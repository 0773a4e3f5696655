// SPDX-License-Identifier: BSD-3-Clause
#include "engine/run_names.hpp"

#include <algorithm>
#include <set>

namespace tolman::run {
namespace {

namespace fs = std::filesystem;
using Parts = std::vector<std::string>;

/// The parts of the absolute path, without an empty last part as of "runs/demo/"; none for "".
Parts partsOf(const fs::path& run) {
  Parts parts;
  std::error_code error;
  const fs::path whole = fs::absolute(run, error);
  if (error) return parts;
  for (const fs::path& part : whole.lexically_normal().relative_path()) {
    if (!part.empty()) parts.push_back(part.string());
  }
  return parts;
}

bool haveSameEnd(const std::vector<Parts>& paths) {
  return std::ranges::all_of(paths, [&](const Parts& parts) {
    return parts.size() > 1 && parts.back() == paths.front().back();
  });
}

std::string lastParts(const Parts& parts, std::size_t count) {
  std::string name;
  for (std::size_t i = parts.size() - std::min(count, parts.size()); i < parts.size(); ++i) {
    name += (name.empty() ? "" : "-") + parts[i];
  }
  return name;
}

}  // namespace

std::vector<std::string> distinctNames(const std::vector<fs::path>& runs) {
  std::vector<Parts> paths;
  std::size_t longest = 0;
  for (const fs::path& run : runs) {
    paths.push_back(partsOf(run));
    longest = std::max(longest, paths.back().size());
  }
  const std::size_t different = std::set<Parts>(paths.begin(), paths.end()).size();
  while (different > 1 && haveSameEnd(paths)) {
    for (Parts& parts : paths) parts.pop_back();
  }
  std::vector<std::string> names(runs.size());
  for (std::size_t count = 1; count <= std::max<std::size_t>(longest, 1); ++count) {
    std::ranges::transform(paths, names.begin(),
                           [&](const Parts& parts) { return lastParts(parts, count); });
    if (std::set<std::string>(names.begin(), names.end()).size() == different) break;
  }
  std::set<std::string> taken;
  for (std::string& name : names) {
    const std::string first = name;
    for (int i = 2; !taken.insert(name).second; ++i) name = first + "-" + std::to_string(i);
  }
  return names;
}

}  // namespace tolman::run
