// SPDX-License-Identifier: BSD-3-Clause
#include "config/tree.hpp"

#include <algorithm>
#include <map>
#include <tuple>

namespace tolman::config {
namespace {

using Values = std::map<std::string, std::string>;

/// A long message, such as one that quotes a whole file, without its middle.
std::string shortened(const std::string& message) {
  constexpr std::size_t kMax = 2000;  // lists of keys are shorter
  constexpr std::size_t kEnd = 200;
  if (message.size() <= kMax) return message;
  return message.substr(0, kEnd) + " ... " + message.substr(message.size() - kEnd);
}

void addLeaves(const Node& node, const std::string& path, Values& values) {
  if (node.isScalar()) values[path] = node.text;
  for (const Node& child : node.children) addLeaves(child, joinPath(path, child.key), values);
}

}  // namespace

std::string text(const Origin& origin) {
  if (origin.kind == Origin::Kind::Default) return "default";
  if (origin.line == 0) return origin.file;
  return origin.file + ':' + std::to_string(origin.line) + ':' + std::to_string(origin.column);
}

std::string format(const Problem& problem) {
  std::string line = text(problem.where) + ": ";
  if (!problem.key_path.empty()) line += problem.key_path + ": ";
  return line + shortened(problem.message);
}

std::string format(Problems problems) {
  const auto position = [](const Problem& p) {
    return std::tie(p.where.kind, p.where.file, p.where.line, p.where.column);
  };
  std::ranges::stable_sort(problems, {}, position);
  std::string lines;
  for (const Problem& problem : problems) lines += format(problem) + '\n';
  return lines;
}

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
  if (node.isScalar()) return "'" + node.text + "'";
  return node.isMap() ? "a map" : node.isSequence() ? "a list" : "nothing";
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

std::vector<Difference> differencesOf(const std::vector<const Node*>& trees) {
  std::vector<Values> all;
  Values keys;
  for (const Node* tree : trees) {
    addLeaves(*tree, "", all.emplace_back());
    keys.insert(all.back().begin(), all.back().end());
  }
  std::vector<Difference> differences;
  for (const auto& [key, first] : keys) {
    Difference difference{key, {}};
    for (const Values& values : all) {
      const auto own = values.find(key);
      difference.values.push_back(own == values.end() ? "-" : own->second);
    }
    const bool is_same = std::ranges::count(difference.values, difference.values.front()) ==
                         std::ranges::ssize(difference.values);
    if (!is_same) differences.push_back(std::move(difference));
  }
  return differences;
}

}  // namespace tolman::config
