// SPDX-License-Identifier: BSD-3-Clause
// Merging of trees, on hand-made cases.
#include <catch2/catch.hpp>

#include "config/loader.hpp"
#include "config/tree.hpp"

namespace tolman {
namespace {

config::Node tree(const std::string& yaml, const std::string& file) {
  config::Problems problems;
  auto node = config::readYaml(yaml, config::Origin::ofFile(file), problems);
  REQUIRE(problems.empty());
  return *node;
}

/// Flow YAML of a tree, each scalar with the first letter of its file.
std::string shown(const config::Node& node) {
  if (node.isScalar()) return node.text + node.origin.file;
  std::string inside;
  for (const config::Node& child : node.children) {
    inside += (inside.empty() ? "" : ", ") + (node.isMap() ? child.key + ": " : "") + shown(child);
  }
  return node.isMap() ? "{" + inside + "}" : node.isSequence() ? "[" + inside + "]" : "null";
}

std::string merged(const std::string& base, const std::string& over) {
  config::Node node = tree(base, "b");
  config::merge(node, tree(over, "o"));
  return shown(node);
}

}  // namespace

TEST_CASE("merge: maps by key, scalars and lists as a whole") {
  CHECK(merged("{a: 1, b: 2}", "{b: 3, c: 4}") == "{a: 1b, b: 3o, c: 4o}");
  CHECK(merged("{a: {x: 1, y: 2}}", "{a: {y: 3}}") == "{a: {x: 1b, y: 3o}}");
  CHECK(merged("{a: [1, 2, 3]}", "{a: [4]}") == "{a: [4o]}");
  CHECK(merged("{a: {x: 1}}", "{a: 5}") == "{a: 5o}");
  CHECK(merged("{a: 5}", "{a: {x: 1}}") == "{a: {x: 1o}}");
  CHECK(merged("{a: 5}", "{a: }") == "{a: null}");
  CHECK(merged("{a: 1}", "{}") == "{a: 1b}");
}

TEST_CASE("merge: another plugin replaces the stage, the same one does not") {
  CHECK(merged("{s: {plugin: p, x: 1}}", "{s: {plugin: q, y: 2}}") == "{s: {plugin: qo, y: 2o}}");
  CHECK(merged("{s: {plugin: p, x: 1}}", "{s: {plugin: p, y: 2}}") ==
        "{s: {plugin: po, x: 1b, y: 2o}}");
  CHECK(merged("{s: {x: 1}}", "{s: {plugin: q}}") == "{s: {x: 1b, plugin: qo}}");
}

TEST_CASE("Nodes are found by key or index, and described in words") {
  config::Node node = tree("{list: [x, y], none: , word: w}", "f");
  CHECK(node.find("list")->find("1")->text == "y");
  CHECK(node.find("absent") == nullptr);
  CHECK(config::describe(*node.find("list")) == "a list");
  CHECK(config::describe(*node.find("none")) == "nothing");
  CHECK(config::describe(*node.find("word")) == "'w'");
  CHECK(config::describe(node) == "a map");
  node.erase("list");
  CHECK(node.children.size() == 2);
  CHECK(config::joinPath("a", "b") == "a.b");
  CHECK(config::joinPath("", "b") == "b");
}

}  // namespace tolman
