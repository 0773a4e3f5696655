// SPDX-License-Identifier: BSD-3-Clause
#include "support/data.hpp"

#include <cstdlib>
#include <iostream>
#include <string>

#include "support/paths.hpp"

namespace tolman::test {

std::vector<std::string>& skips() {
  static std::vector<std::string> names;
  return names;
}

std::optional<std::filesystem::path> dataOrSkip(std::string_view name) {
  const char* set = std::getenv("TOLMAN_DATA");
  const std::filesystem::path root = set != nullptr
                                         ? std::filesystem::path(set)
                                         : std::filesystem::path(inSource("../shared/data"));
  const auto path = root / name;
  if (std::filesystem::exists(path)) return std::filesystem::canonical(path);
  std::cerr << "SKIPPED: no data at " << path.string() << " (set TOLMAN_DATA)\n";
  skips().push_back(path.string());
  return std::nullopt;
}

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "tolman-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no temporary folder");
  path_ = pattern;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace tolman::test
