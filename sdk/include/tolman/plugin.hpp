// SPDX-License-Identifier: BSD-3-Clause
// Registration: the macro that makes a class a plugin. Include this header in plugin.cpp only.
//
//   TOLMAN_PLUGIN(view_templates, ViewTemplates, "0.1.0", "Local view cells by template matching.")
//
// The class derives from one role, has a default constructor and a nested `Parameters` struct (see
// parameters.hpp). One library may register several plugins. The macro writes a manifest, JSON in
// the ELF section "tolman_manifest", which the host reads without executing anything, and an entry
// function `tolman_plugin_<id>`, the only symbol that the host looks up.
//
// An interpreter is a library that runs programs in another language as plugins. The key `file` of
// the stage names the program, and the stage always runs in a process of its own:
//
//   TOLMAN_INTERPRETER(lua, ".lua", "0.1.0", "Plugins in Lua.", &openProgram);
//
// A process opens one program. Its parameters, role and summary are known only when it is open.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tolman/extras.hpp"
#include "tolman/parameters.hpp"
#include "tolman/roles.hpp"
#include "tolman/version.hpp"

namespace tolman {

/// One plugin object, by pointers to the interfaces that it implements; the others are null. All
/// pointers are to the same object.
struct PluginObject {
  Plugin* plugin = nullptr;
  ArraySource* arrays = nullptr;
  StateKeeper* state = nullptr;
  ArrayDescriptions* descriptions = nullptr;
  PageServer* page = nullptr;
  RawRigSource* raw_rig = nullptr;
};

/// What the entry function returns: a constant with static storage.
struct PluginDescriptor {
  std::uint32_t sdk_major;
  std::uint32_t sdk_minor;
  const char* id;
  Role role;
  std::uint64_t schema_hash;
  Schema (*schema)();
  PluginObject (*create)();  ///< may throw
  void (*destroy)(Plugin*);  ///< code of the plugin's library, which allocated the object
};

/// An open program.
struct Program {
  /// The role, and functions that create and destroy objects of the program. It has static storage;
  /// `schema` and `schema_hash` are not read.
  const PluginDescriptor* descriptor = nullptr;
  std::string version;
  std::string summary;
  Schema schema;  ///< without `file`
  /// Further files on which its results depend, such as its imports. Absolute paths.
  std::vector<std::string> files;
};

/// Opens the program with this absolute path; called once in a process. The message of a failure
/// names the place of the error in the program.
using OpenProgram = Status (*)(const std::string& file, Program& program);

namespace detail {

template <class C>
constexpr Role roleOf() {
  constexpr int kRoles = std::derived_from<C, Source> + std::derived_from<C, Odometry> +
                         std::derived_from<C, Place> + std::derived_from<C, Cells> +
                         std::derived_from<C, Map> + std::derived_from<C, Observer>;
  static_assert(kRoles == 1, "a plugin class derives from exactly one role of roles.hpp");
  if constexpr (std::derived_from<C, Source>) return Role::Source;
  if constexpr (std::derived_from<C, Odometry>) return Role::Odometry;
  if constexpr (std::derived_from<C, Place>) return Role::Place;
  if constexpr (std::derived_from<C, Cells>) return Role::Cells;
  if constexpr (std::derived_from<C, Map>) return Role::Map;
  if constexpr (std::derived_from<C, Observer>) return Role::Observer;
}

template <class C>
PluginObject createPlugin() {
  auto instance = std::make_unique<C>();
  PluginObject object;
  if constexpr (std::derived_from<C, ArraySource>) object.arrays = instance.get();
  if constexpr (std::derived_from<C, StateKeeper>) object.state = instance.get();
  if constexpr (std::derived_from<C, ArrayDescriptions>) object.descriptions = instance.get();
  if constexpr (std::derived_from<C, PageServer>) object.page = instance.get();
  if constexpr (std::derived_from<C, RawRigSource>) object.raw_rig = instance.get();
  object.plugin = instance.release();
  return object;
}

/// JSON text of fixed size, filled at compile time.
struct ManifestText {
  std::array<char, 1024> text{};
  std::size_t size = 0;

  constexpr void append(std::string_view part) {
    for (const char c : part) text.at(size++) = c;  // too long: a compile-time error
  }
  constexpr void member(std::string_view key, std::string_view value) {
    append(size == 0 ? "{\"" : ",\"");
    append(key);
    append("\":\"");
    for (const char c : value) {
      if (c == '"' || c == '\\') append("\\");
      append(std::string_view(&c, 1));
    }
    append("\"");
  }
  /// A member whose value lists the names of the flags that are true, separated by commas.
  constexpr void flags(std::string_view key,
                       std::initializer_list<std::pair<std::string_view, bool>> flags) {
    member(key, "");
    --size;  // removes the closing quote
    bool first = true;
    for (const auto& [name, set] : flags) {
      if (!set) continue;
      append(first ? "" : ",");
      append(name);
      first = false;
    }
    append("\"");
  }
  constexpr void hexadecimal(std::string_view key, std::uint64_t value) {
    std::array<char, 16> digits{};
    for (std::size_t i = 16; i-- > 0; value >>= 4U) digits[i] = "0123456789abcdef"[value & 15U];
    member(key, std::string_view(digits.data(), digits.size()));
  }
};

template <class C>
consteval std::array<char, 1024> makeManifest(std::string_view id, std::string_view version,
                                              std::string_view summary) {
  ManifestText manifest;
  manifest.member("id", id);
  manifest.member("role", enumName(roleOf<C>()));
  manifest.member("version", version);
  manifest.member("sdk", TOLMAN_SDK_VERSION);
  manifest.member("fingerprint", TOLMAN_FINGERPRINT);
  manifest.member("opencv", TOLMAN_OPENCV_VERSION);
  manifest.hexadecimal("schema", schemaHash<typename C::Parameters>());
  manifest.flags("extras", {{"arrays", std::derived_from<C, ArraySource>},
                            {"state", std::derived_from<C, StateKeeper>},
                            {"descriptions", std::derived_from<C, ArrayDescriptions>},
                            {"page", std::derived_from<C, PageServer>},
                            {"raw_rig", std::derived_from<C, RawRigSource>},
                            {"live", std::derived_from<C, LiveSource>},
                            {"localise", std::derived_from<C, Localiser>}});
  manifest.member("summary", summary);
  manifest.append("}");
  return manifest.text;
}

consteval std::array<char, 1024> makeInterpreterManifest(std::string_view id,
                                                         std::string_view suffix,
                                                         std::string_view version,
                                                         std::string_view summary) {
  ManifestText manifest;
  manifest.member("id", id);
  manifest.member("programs", suffix);
  manifest.member("version", version);
  manifest.member("sdk", TOLMAN_SDK_VERSION);
  manifest.member("fingerprint", TOLMAN_FINGERPRINT);
  manifest.member("opencv", TOLMAN_OPENCV_VERSION);
  manifest.member("extras", "descriptions");  // programs without descriptions return an empty list
  manifest.member("summary", summary);
  manifest.append("}");
  return manifest.text;
}

}  // namespace detail
}  // namespace tolman

#define TOLMAN_PLUGIN(ID, CLASS, VERSION, SUMMARY)                                         \
  namespace {                                                                              \
  [[gnu::used, gnu::section("tolman_manifest")]] constexpr std::array<char, 1024>          \
      tolman_manifest_##ID = ::tolman::detail::makeManifest<CLASS>(#ID, VERSION, SUMMARY); \
  }                                                                                        \
  extern "C" __attribute__((visibility("default")))                                        \
  const ::tolman::PluginDescriptor* tolman_plugin_##ID() {                                 \
    static constexpr ::tolman::PluginDescriptor kDescriptor = {                            \
        TOLMAN_SDK_MAJOR,                                                                  \
        TOLMAN_SDK_MINOR,                                                                  \
        #ID,                                                                               \
        ::tolman::detail::roleOf<CLASS>(),                                                 \
        ::tolman::schemaHash<CLASS::Parameters>(),                                         \
        &::tolman::schemaOf<CLASS::Parameters>,                                            \
        &::tolman::detail::createPlugin<CLASS>,                                            \
        [](::tolman::Plugin* plugin) { delete plugin; }};                                  \
    return &kDescriptor;                                                                   \
  }                                                                                        \
  static_assert(true, "ask for a semicolon")

/// SUFFIX: suffix of the program files that it runs, such as ".lua". OPEN: an OpenProgram.
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
