// SPDX-License-Identifier: BSD-3-Clause
// The manifest of a plugin, read from its library without executing anything. All offsets and sizes
// are checked, so damaged files are refused.
#pragma once

#include <algorithm>
#include <cstdint>
#include <exception>
#include <filesystem>
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

}  // namespace tolman::host
