// SPDX-License-Identifier: BSD-3-Clause
// Looking up and merging.
#include "config/node.hpp"

#include <algorithm>

namespace tolman::config {

const Node* Node::find(std::string_view name) const {
  const auto found = std::ranges::find(children, name, &Node::key);
  return found == children.end() ? nullptr : &*found;
}

Node* Node::find(std::string_view name) {
  const auto found = std::ranges::find(children, name, &Node::key);
  return found == children.end() ? nullptr : &*found;
}

void Node::erase(std::string_view name) {
  std::erase_if(children, [&](const Node& child) { return child.key == name; });
}

std::string describe(const Node& node) {
  switch (node.kind) {
    case Node::Kind::Null:
      return "nothing";
    case Node::Kind::Scalar:
      return "'" + node.text + "'";
    case Node::Kind::Sequence:
      return "a list";
    case Node::Kind::Map:
      return "a map";
  }
  return {};
}

std::string joinPath(std::string_view path, std::string_view key) {
  std::string joined(path);
  if (!path.empty() && !key.empty()) joined += '.';
  return joined.append(key);
}

bool namesOtherPlugin(const Node& stage, const Node& plugin) {
  const Node* current = stage.find("plugin");
  return current != nullptr && (current->kind != plugin.kind || current->text != plugin.text);
}

void merge(Node& base, const Node& over) {
  const Node* plugin = over.find("plugin");
  const bool other_plugin = plugin != nullptr && namesOtherPlugin(base, *plugin);
  if (!base.isMap() || !over.isMap() || other_plugin) {
    base = over;
    return;
  }
  base.origin = over.origin;
  base.key_origin = over.key_origin;
  for (const Node& child : over.children) {
    if (Node* below = base.find(child.key)) {
      merge(*below, child);
    } else {
      base.children.push_back(child);
    }
  }
}

}  // namespace tolman::config
