// SPDX-License-Identifier: BSD-3-Clause
// Reading and applying --set.
#include <algorithm>
#include <array>
#include <optional>
#include <sstream>

#include "config/loader.hpp"
#include "config/text.hpp"

namespace tolman::config {
namespace {

bool isIndex(const std::string& part) {
  return part.size() <= 4 && std::ranges::all_of(part, isDigit);
}

std::vector<std::string> split(const std::string& path) {
  std::vector<std::string> parts;
  std::istringstream stream(path + '.');
  for (std::string part; std::getline(stream, part, '.');) parts.push_back(part);
  return parts;
}

Result<std::vector<std::string>> readPath(const std::string& argument) {
  const std::size_t equals = argument.find('=');
  if (equals == std::string::npos) {
    return Status::invalidParameter("write --set key.path=value");
  }
  std::vector<std::string> path = split(argument.substr(0, equals));
  if (std::ranges::find(path, "") != path.end()) {
    return Status::invalidParameter("the key path has an empty part");
  }
  if (path.front() == "extends") {
    return Status::invalidParameter("'extends' is allowed in files only");
  }
  return path;
}

/// The child `part` of `parent`, created if it does not exist.
Result<Node*> step(Node& parent, const std::string& part, const Origin& origin) {
  if (parent.kind == Node::Kind::Null) {
    parent.kind = isIndex(part) ? Node::Kind::Sequence : Node::Kind::Map;
    parent.origin = origin;
  }
  if (parent.isScalar()) {
    return Status::invalidParameter("'" + part + "' cannot be set: its parent is the scalar " +
                                    describe(parent));
  }
  if (Node* child = parent.find(part)) return child;
  if (parent.isSequence() && part != std::to_string(parent.children.size())) {
    return Status::invalidParameter("no item '" + part + "' in a list of " +
                                    std::to_string(parent.children.size()) +
                                    "; indices start at 0");
  }
  parent.children.push_back({Node::Kind::Null, part, origin, origin});
  return &parent.children.back();
}

Status assign(Node& tree, const std::vector<std::string>& path, Node value, const Origin& origin) {
  Node* node = &tree;
  for (const std::string& part : path) {
    const bool is_plugin = part == "plugin" && &part == &path.back();
    if (is_plugin && namesOtherPlugin(*node, value)) node->children.clear();
    const Result<Node*> child = step(*node, part, origin);
    if (!child.isOk()) return child.status();
    node = child.value();
  }
  value.key = node->key;
  value.key_origin = origin;
  *node = std::move(value);
  return Status::ok();
}

/// The problem if YAML dropped a part of the given text (a comment, outer blanks, a line break), so
/// that a path with such characters does not become another path; empty if there is none.
std::string lostText(const Node& value, const std::string& given) {
  constexpr std::array kNulls = {"", "~", "null", "Null", "NULL"};
  if (value.kind == Node::Kind::Null && std::ranges::find(kNulls, given) == kNulls.end()) {
    return "YAML reads this as nothing; put the value into quotes: --set 'key=\"value\"'";
  }
  const bool has_variables = given.find("${") != std::string::npos;
  if (!value.isScalar() || value.quoted || has_variables || value.text == given) return "";
  return "YAML reads this as '" + value.text +
         "'; put the value into quotes: --set 'key=\"value\"'";
}

}  // namespace

void applyOverrides(Node& tree, const std::vector<std::string>& overrides,
                    const Environment& environment, Problems& problems) {
  std::vector<std::string> ordered = overrides;
  std::stable_partition(ordered.begin(), ordered.end(), [](const std::string& argument) {
    return argument.substr(0, argument.find('=')).ends_with(".plugin");
  });
  for (const std::string& argument : ordered) {
    const Origin origin{Origin::Kind::CommandLine, "--set " + argument, 0, 0, {}};
    const auto path = readPath(argument);
    if (!path.isOk()) {
      problems.push_back({origin, "", path.status().message()});
      continue;
    }
    const std::size_t equals = argument.find('=');
    const std::string given = argument.substr(equals + 1);
    std::optional<Node> value =
        readYaml(given, origin, problems, environment, argument.substr(0, equals));
    if (!value) continue;  // readYaml() has reported the reason
    if (const std::string lost = lostText(*value, given); !lost.empty()) {
      problems.push_back({origin, "", lost});
      continue;
    }
    const Status done = assign(tree, path.value(), std::move(*value), origin);
    if (!done.isOk()) problems.push_back({origin, "", done.message()});
  }
}

Status setValue(Node& tree, const std::string& path, const Node& value) {
  const auto parts = readPath(path + "=");
  if (!parts.isOk()) return parts.status();
  Node merged = value;
  if (value.isMap()) {
    const Node* there = &tree;
    for (const std::string& part : parts.value()) there = there ? there->find(part) : nullptr;
    if (there != nullptr && there->isMap()) {
      merged = *there;
      merge(merged, value);
    }
  }
  return assign(tree, parts.value(), std::move(merged), value.origin);
}

}  // namespace tolman::config
