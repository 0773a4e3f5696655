// SPDX-License-Identifier: BSD-3-Clause
// Paths of the real data; without them a test is reported as skipped.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::test {

/// What tests of this program have asked for and is absent: paths of data, names of programs.
std::vector<std::string>& skips();

/// The folder or file `name` below $TOLMAN_DATA or ../shared/data. When it is absent the skip is
/// printed and noted; a test case that asks has the tag [data].
std::optional<std::filesystem::path> dataOrSkip(std::string_view name);

/// A fresh empty folder below the system's temporary one, removed with the object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tolman::test
