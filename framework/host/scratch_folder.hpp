// SPDX-License-Identifier: BSD-3-Clause
// A temporary folder for files of plugins, removed by the destructor.
#pragma once

#include <stdlib.h>

#include <filesystem>
#include <string>
#include <system_error>

namespace tolman::host {

inline constexpr const char* kNoScratchFolder =
    "no temporary folder can be made; set TMPDIR to a folder that exists and can be written";

class ScratchFolder {
 public:
  /// `name` is the prefix of the folder's name.
  explicit ScratchFolder(const std::string& name) {
    std::error_code error;
    const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
    std::string pattern = (folder / (name + "-XXXXXX")).string();
    if (!error && ::mkdtemp(pattern.data()) != nullptr) path_ = pattern;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Empty when it could not be created, see kNoScratchFolder.
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace tolman::host
