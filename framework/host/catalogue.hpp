// SPDX-License-Identifier: BSD-3-Clause
// The manifests of all plugins on the search path. No library is opened.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "host/manifest.hpp"

namespace tolman::host {

/// The folders and library files to search, in order of precedence: those of the command line,
/// those of TOLMAN_PLUGIN_PATH (`environment`: colon-separated; null when unset), then the build or
/// install tree that contains `executable`.
std::vector<std::filesystem::path> searchPath(const std::vector<std::string>& command_line,
                                              const char* environment,
                                              const std::filesystem::path& executable);

/// A library on the search path without a readable manifest. It does not affect other plugins.
struct BrokenLibrary {
  std::filesystem::path file;
  Refusal refusal;
};

class Catalogue {
 public:
  /// Reads the manifests of all *.so files along the path.
  explicit Catalogue(std::vector<std::filesystem::path> search_path);

  /// The manifest of `id` in `role`. Refusals: plugin/not-found (with the nearest known name and
  /// the folders searched), plugin/wrong-role, plugin/ambiguous (twice in one folder).
  Manifest find(const std::string& id, Role role) const;

  /// The manifest of `id` in any role. `id` may be the file of a program.
  Manifest find(const std::string& id) const;

  /// The interpreter with this id; null for other or unknown plugins.
  const Manifest* interpreter(const std::string& id) const;
  /// A program as a plugin, by the interpreter that runs files of its suffix. Refusals:
  /// plugin/not-found.
  Manifest program(const std::filesystem::path& file) const;

  /// The manifests of all plugins that are libraries.
  const std::vector<Manifest>& manifests() const { return manifests_; }
  const std::vector<Manifest>& interpreters() const { return interpreters_; }
  const std::vector<BrokenLibrary>& broken() const { return broken_; }

 private:
  void addLibrary(const std::filesystem::path& file);
  Manifest findLibrary(const std::string& id, std::optional<Role> role) const;
  Refusal notFound(const std::string& id, std::optional<Role> role) const;

  std::vector<std::filesystem::path> search_path_;
  std::vector<Manifest> manifests_;
  std::vector<Manifest> interpreters_;
  std::vector<BrokenLibrary> broken_;
};

}  // namespace tolman::host
