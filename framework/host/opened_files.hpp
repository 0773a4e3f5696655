// SPDX-License-Identifier: BSD-3-Clause
// Whether the files of a plugin are still those that its first process opened.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "host/manifest.hpp"

namespace tolman::isolation {

/// A file as the system knows it: an edit changes its time, a new file has another number.
struct OpenedFile {
  std::filesystem::path path;
  dev_t device = 0;
  ino_t number = 0;
  off_t bytes = -1;  ///< -1: there is no such file
  std::int64_t changed_ns = 0;

  bool operator==(const OpenedFile&) const = default;
};

/// Library, program, and the other files of a plugin that is open.
std::vector<OpenedFile> openedFiles(const host::Manifest& manifest);

/// The first file that is not the same in both lists, or only in one of them.
std::optional<std::filesystem::path> changedFile(const std::vector<OpenedFile>& before,
                                                 const std::vector<OpenedFile>& now);

}  // namespace tolman::isolation
