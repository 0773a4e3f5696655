// SPDX-License-Identifier: BSD-3-Clause
// Opens files of runs and sweeps, which may come from anyone.
#pragma once

#include <filesystem>
#include <fstream>

namespace tolman::record {

/// For reading bytes. Not open if the path is no regular file: a pipe would block, without end.
inline std::ifstream openRegular(const std::filesystem::path& file) {
  std::ifstream stream;
  std::error_code ignored;
  if (std::filesystem::is_regular_file(file, ignored)) stream.open(file, std::ios::binary);
  return stream;
}

}  // namespace tolman::record
