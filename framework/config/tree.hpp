// SPDX-License-Identifier: BSD-3-Clause
// The tree of a configuration: scalars, lists and maps, each with the position where it was set,
// and the problems found in them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

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

}  // namespace tolman::config
