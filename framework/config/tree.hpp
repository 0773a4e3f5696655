// SPDX-License-Identifier: BSD-3-Clause
// The tree of a configuration: scalars, lists and maps, each with the position where it was set,
// the problems found in them, and their reading from YAML. Only this room uses yaml-cpp.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/status.hpp"

namespace tolman::config {

/// Where a value was set.
struct Origin {
  enum class Kind : std::uint8_t { Default, File, CommandLine };
  Kind kind = Kind::Default;
  std::string file;       ///< path of the file, or "--set a.b=c" as typed; empty for a default
  int line = 0;           ///< from 1; 0 for the whole file
  int column = 0;         ///< from 1
  std::string variables;  ///< expanded in the value, e.g. "KITTI_ROOT (not set), HOME"

  static Origin ofFile(std::string path) { return {Kind::File, std::move(path), 0, 0, {}}; }
};

/// "configs/a.yaml:4:13", "--set a.b=c" or "default".
std::string text(const Origin& origin);

struct Problem {
  enum class Kind : std::uint8_t {
    Value,   ///< a file, a key or a value
    Plugin,  ///< a plugin that is named cannot be used
  };
  Origin where;
  std::string key_path;  ///< e.g. "odometry.active_points"; empty for a whole file
  std::string message;
  Kind kind = Kind::Value;
};
using Problems = std::vector<Problem>;

/// "configs/a.yaml:4:13: odometry.activ_points: unknown parameter; did you mean 'active_points'?"
std::string format(const Problem& problem);
/// One line each, sorted by file and position; the command line last.
std::string format(Problems problems);

/// A value with its key. Copies are deep.
struct Node {
  enum class Kind : std::uint8_t { Null, Scalar, Sequence, Map };
  Kind kind = Kind::Null;
  std::string key{};  ///< in its parent; the index in a sequence, empty for the root
  Origin key_origin{};
  Origin origin{};
  std::string text{};            ///< of a scalar, unquoted
  bool quoted = false;           ///< the scalar was quoted, so it is text
  std::vector<Node> children{};  ///< in the order of the file

  bool isMap() const { return kind == Kind::Map; }
  bool isScalar() const { return kind == Kind::Scalar; }
  bool isSequence() const { return kind == Kind::Sequence; }
  /// The child of that key (or index), or null.
  const Node* find(std::string_view name) const;
  Node* find(std::string_view name);
  /// Removes the child of that key, if there.
  void erase(std::string_view name);
};

/// "'text'", "a list", "a map" or "nothing".
std::string describe(const Node& node);

/// "a.b" or "b".
std::string joinPath(std::string_view path, std::string_view key);

/// Whether `stage` has another plugin than `plugin`. Its parameters then do not apply.
bool namesOtherPlugin(const Node& stage, const Node& plugin);

/// Overrides `base` by `over`: maps are merged key by key, scalars and lists are replaced. A map
/// with another `plugin` replaces the whole stage, parameters included.
void merge(Node& base, const Node& over);

struct Difference {
  std::string key;                  ///< "cells.period"
  std::vector<std::string> values;  ///< of each tree; "-" where it has no such key
};

/// Scalars that are not the same in all trees, by key.
std::vector<Difference> differencesOf(const std::vector<const Node*>& trees);

/// Looks up an environment variable.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The environment of this process.
Environment processEnvironment();

/// Replaces ${NAME} by the variable, and ${NAME:-default} by the default if the variable is unset
/// or empty. $${ stands for ${. Adds the names to `used`, "A, B (not set)".
Result<std::string> expandVariables(const std::string& text, const Environment& environment,
                                    std::string& used);

/// Reads one YAML document; an empty one gives a Null node. `source` is the origin of all values;
/// line and column are filled in where it is a file. `path` is the key of the document in messages.
/// With an environment its variables are expanded in all values. The result is not parsed as YAML
/// again and counts as unquoted: {port: "${PORT:-8080}"} is a number.
///
/// Stricter than yaml-cpp: of duplicate keys the first is kept and the others are problems. Merge
/// keys, aliases, tags, keys that are not scalars, unclosed quotes and several documents are
/// problems and give no tree. Does not throw for any input.
std::optional<Node> readYaml(const std::string& text, const Origin& source, Problems& problems,
                             const Environment& environment = {}, const std::string& path = {});

}  // namespace tolman::config
