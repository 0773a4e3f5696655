// SPDX-License-Identifier: BSD-3-Clause
// The manifest of a plugin, read from its library without executing anything. All offsets and sizes
// are checked, so damaged files are refused.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::host {

/// Id of a refusal for want of processes or threads, which says nothing about the plugin.
inline constexpr const char* kNoProcess = "plugin/no-process";

/// Why a plugin was not opened; thrown. The ids are listed with their remedies in docs/errors.md.
struct Refusal : std::exception {
  Refusal() = default;
  Refusal(std::string i, std::string found, std::string what_to_do)
      : id(std::move(i)), message(std::move(found)), remedy(std::move(what_to_do)) {}
  const char* what() const noexcept override { return message.c_str(); }

  std::string id;       ///< e.g. "plugin/fingerprint"
  std::string message;  ///< what was expected, where, and what was found
  std::string remedy;   ///< what to do

  std::string text() const { return "[" + id + "] " + message + "\n  remedy: " + remedy; }
};

/// The bytes of section `name` of a 64-bit little-endian x86-64 shared object. Refusals:
/// plugin/unreadable, plugin/not-elf, plugin/truncated, plugin/wrong-machine, plugin/no-manifest.
std::string readElfSection(const std::filesystem::path& file, std::string_view name);

struct Manifest {
  std::filesystem::path file;
  std::string id;
  Role role = Role::Source;
  std::string version;
  int sdk_major = 0;
  int sdk_minor = 0;
  std::string fingerprint;
  std::string opencv;  ///< empty when the plugin does not use OpenCV
  std::uint64_t schema_hash = 0;
  std::string summary;
  std::vector<std::string> extras;  ///< interfaces beside the role: arrays, state, page, ...
  /// Of an interpreter (tolman/plugin.hpp), else empty: the suffix of the programs that it runs.
  std::string programs;
  std::filesystem::path program;  ///< absolute path of the program; its role is known when open
  /// Other files that it consists of, known when open: modules of a program, and shared libraries
  /// that a library brings along.
  std::vector<std::string> program_files;

  bool hasExtra(std::string_view name) const {
    return std::find(extras.begin(), extras.end(), name) != extras.end();
  }
};

/// All manifests of one library. Besides the refusals of readElfSection(): plugin/bad-manifest.
std::vector<Manifest> readManifests(const std::filesystem::path& file);

/// The manifest of plugin `id`. Besides the refusals of readManifests(): plugin/not-found.
Manifest readManifest(const std::filesystem::path& file, const std::string& id);

/// Parses one JSON manifest; `file` is for messages.
Manifest parseManifest(const std::string& text, const std::filesystem::path& file);

// The manifests of all plugins on the search path. No library is opened.

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
