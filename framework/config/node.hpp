// SPDX-License-Identifier: BSD-3-Clause
// The value tree of a configuration: scalars, lists and maps with the position of each value.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "config/problem.hpp"

namespace tolman::config {

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

}  // namespace tolman::config
