// SPDX-License-Identifier: BSD-3-Clause
#include "host/opened_files.hpp"

#include <sys/stat.h>

#include <algorithm>

namespace tolman::isolation {
namespace {

OpenedFile openedFile(std::filesystem::path path) {
  OpenedFile file{std::move(path)};
  struct stat found {};
  if (::stat(file.path.c_str(), &found) != 0) return file;
  file.device = found.st_dev;
  file.number = found.st_ino;
  file.bytes = found.st_size;
  file.changed_ns = found.st_mtim.tv_sec * std::int64_t{1'000'000'000} + found.st_mtim.tv_nsec;
  return file;
}

}  // namespace

std::vector<OpenedFile> openedFiles(const host::Manifest& manifest) {
  std::vector<OpenedFile> files = {openedFile(manifest.file)};
  if (!manifest.program.empty()) files.push_back(openedFile(manifest.program));
  for (const std::string& file : manifest.program_files) files.push_back(openedFile(file));
  return files;
}

std::optional<std::filesystem::path> changedFile(const std::vector<OpenedFile>& before,
                                                 const std::vector<OpenedFile>& now) {
  const auto firstNotIn = [](const std::vector<OpenedFile>& others,
                             const std::vector<OpenedFile>& files) {
    const auto found = std::ranges::find_if(files, [&](const OpenedFile& file) {
      return std::ranges::find(others, file) == others.end();
    });
    return found == files.end() ? std::nullopt : std::optional(found->path);
  };
  const auto changed = firstNotIn(before, now);
  return changed ? changed : firstNotIn(now, before);
}

}  // namespace tolman::isolation
