// SPDX-License-Identifier: BSD-3-Clause
// Where the real data lie, and a visible skip where they do not.
#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace tolman::test {

/// The folder or file `name` below $TOLMAN_DATA or ../shared/data; prints a skip when absent.
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
