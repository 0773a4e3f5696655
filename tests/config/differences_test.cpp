// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>

#include "config/tree.hpp"

using namespace tolman::config;

namespace {

Node scalar(std::string key, std::string text) {
  Node node{Node::Kind::Scalar};
  node.key = std::move(key);
  node.text = std::move(text);
  return node;
}

Node map(std::string key, std::vector<Node> children) {
  Node node{Node::Kind::Map};
  node.key = std::move(key);
  node.children = std::move(children);
  return node;
}

}  // namespace

TEST_CASE("only keys whose values differ are named, with a dash where one has no such key") {
  const Node one =
      map("", {scalar("seed", "1"), map("cells", {scalar("plugin", "a"), scalar("period", "75")})});
  const Node two = map("", {scalar("seed", "1"), map("cells", {scalar("plugin", "b")})});
  const auto differences = differencesOf({&one, &two});
  REQUIRE(differences.size() == 2);
  CHECK(differences[0].key == "cells.period");
  CHECK(differences[0].values == std::vector<std::string>{"75", "-"});
  CHECK(differences[1].key == "cells.plugin");
  CHECK(differences[1].values == std::vector<std::string>{"a", "b"});
  CHECK(differencesOf({&one, &one}).empty());
  CHECK(differencesOf({}).empty());
}
