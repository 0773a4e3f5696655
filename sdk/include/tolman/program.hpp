// SPDX-License-Identifier: BSD-3-Clause
// Interpreters: a library that runs programs in another language as plugins. A stage names the
// program by the key `file`, and always runs in a process of its own.
//
//   TOLMAN_INTERPRETER(lua, ".lua", "0.1.0", "Plugins in Lua.", &openProgram);
//
// A process opens one program. Its parameters, its role and its summary are known when it is open.
#pragma once

#include <string>
#include <vector>

#include "tolman/plugin.hpp"

namespace tolman {

/// An open program.
struct Program {
  /// With static storage: the role, and how to make and destroy objects of the program; `schema`
  /// and `schema_hash` are not read.
  const PluginDescriptor* descriptor = nullptr;
  std::string version;
  std::string summary;
  Schema schema;  ///< without `file`
  /// Files beside the program that decide what it does, such as its imports. Absolute paths.
  std::vector<std::string> files;
};

/// Opens the program of this absolute path, once in a process. A failure says where in the program
/// the error is.
using OpenProgram = Status (*)(const std::string& file, Program& program);

namespace detail {

consteval std::array<char, 1024> makeInterpreterManifest(std::string_view id,
                                                         std::string_view suffix,
                                                         std::string_view version,
                                                         std::string_view summary) {
  Manifest manifest;
  manifest.member("id", id);
  manifest.member("programs", suffix);
  manifest.member("version", version);
  manifest.member("sdk", TOLMAN_SDK_VERSION);
  manifest.member("fingerprint", TOLMAN_FINGERPRINT);
  manifest.member("opencv", TOLMAN_OPENCV_VERSION);
  manifest.member("extras", "descriptions");  // objects without any give none
  manifest.member("summary", summary);
  manifest.append("}");
  return manifest.text;
}

}  // namespace detail
}  // namespace tolman

/// SUFFIX: of the files that it runs. OPEN: an OpenProgram.
#define TOLMAN_INTERPRETER(ID, SUFFIX, VERSION, SUMMARY, OPEN)                                    \
  namespace {                                                                                     \
  [[gnu::used, gnu::section("tolman_manifest")]] constexpr std::array<char, 1024>                 \
      tolman_manifest_##ID =                                                                      \
          ::tolman::detail::makeInterpreterManifest(#ID, SUFFIX, VERSION, SUMMARY);               \
  }                                                                                               \
  extern "C" __attribute__((visibility("default"))) ::tolman::OpenProgram tolman_program_##ID() { \
    return OPEN;                                                                                  \
  }                                                                                               \
  static_assert(true, "ask for a semicolon")
