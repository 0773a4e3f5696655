// SPDX-License-Identifier: BSD-3-Clause
// Making paths absolute.
#include "config/paths.hpp"

#include <unistd.h>

#include <cerrno>

#include "base/open_files.hpp"

namespace tolman::config {

Result<std::string> resolvePath(const std::string& path, const Origin& origin,
                                const BaseFolders& folders) {
  if (path.empty()) return path;
  std::filesystem::path absolute = path;
  if (path == "~" || path.starts_with("~/")) {
    if (folders.home.empty()) return Status::invalidParameter("'~' needs HOME, which is not set");
    absolute = folders.home + path.substr(1);
  } else if (path.starts_with('~')) {
    return Status::invalidParameter("'" + path +
                                    "': only '~/' is supported, not the home of another user");
  }
  std::filesystem::path base = folders.working_directory;
  if (origin.kind == Origin::Kind::File) {
    base /= std::filesystem::path(origin.file).parent_path();
  }
  std::string normal = (base / absolute).lexically_normal().string();
  while (normal.size() > 1 && normal.ends_with('/')) normal.pop_back();
  return normal;
}

std::string absence(const std::filesystem::path& path, const std::string& missing) {
  std::error_code ignored;
  const int reading = R_OK | (std::filesystem::is_directory(path, ignored) ? X_OK : 0);
  if (::access(path.c_str(), reading) == 0) return file_opening::notOpened(missing);
  if (errno != EACCES) return missing;
  return "permission denied; let this user read it, and enter the folders above it (`chmod u+rX`)";
}

}  // namespace tolman::config
