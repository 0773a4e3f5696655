// SPDX-License-Identifier: BSD-3-Clause
// YAML text to nodes; no input crashes the reader.
#include <catch2/catch.hpp>
#include <fstream>
#include <iterator>

#include "config/loader.hpp"
#include "config/toy_system.hpp"
#include "tolman/context.hpp"

namespace tolman {
namespace {

using config::Node;

struct Reading {
  std::optional<Node> tree;
  config::Problems problems;
};

Reading read(const std::string& text) {
  Reading reading;
  reading.tree = config::readYaml(text, config::Origin::ofFile("f"), reading.problems);
  return reading;
}

/// The tree in one line with positions: {a@1:1: 'x'@1:4}.
std::string shown(const Node& node) {
  const auto place = [](const config::Origin& origin) { return config::text(origin).substr(1); };
  std::string text = node.isScalar() ? "'" + node.text + "'" : "";
  if (node.kind == Node::Kind::Null) text = "null";
  for (const Node& child : node.children) {
    text += (text.empty() ? "" : ", ");
    if (node.isMap()) text += child.key + "@" + place(child.key_origin).substr(1) + ": ";
    text += shown(child);
  }
  if (node.isMap()) text = "{" + text + "}";
  if (node.isSequence()) text = "[" + text + "]";
  return text + "@" + place(node.origin).substr(1);
}

}  // namespace

TEST_CASE("Values and keys have their position") {
  CHECK(shown(*read("a: x\nb:\n  c: [1, {d: \"2\"}]\n").tree) ==
        "{a@1:1: 'x'@1:4, b@2:1: {c@3:3: ['1'@3:7, {d@3:11: '2'@3:14}@3:10]@3:6}@3:3}@1:1");
}

TEST_CASE("An absent value has the position of its key") {
  CHECK(shown(*read("a:\nb: ~\n").tree) == "{a@1:1: null@1:1, b@2:1: null@2:1}@1:1");
}

TEST_CASE("Quoted scalars are text") {
  const Reading reading = read("[1, \"1\", '1', |\n]");
  const Reading good = read("- 1\n- \"1\"\n- '1'\n- |\n  1\n");
  REQUIRE(good.tree->children.size() == 4);
  CHECK_FALSE(good.tree->children[0].quoted);
  CHECK(good.tree->children[1].quoted);
  CHECK(good.tree->children[2].quoted);
  CHECK(good.tree->children[3].quoted);
  CHECK_FALSE(reading.tree);
}

TEST_CASE("Aliases are refused") {
  CHECK(config::format(read("a: &x {k: 1}\nb: *x\n").problems) ==
        "f:2:4: cannot read this YAML: aliases are not supported; write the value again, or use "
        "'extends'\n");
}

TEST_CASE("Duplicate keys are reported at every level; the first is kept") {
  const Reading reading = read("a: [{k: 1, k: 2}, {k: 1}]\nb: 1\n'b': 2\n");
  REQUIRE(reading.tree);
  CHECK(reading.tree->find("b")->text == "1");
  CHECK(config::format(reading.problems) ==
        "f:1:12: a.0.k: given twice; first at f:1:6\n"
        "f:3:1: b: given twice; first at f:2:1\n");
}

TEST_CASE("Keys must be scalars") {
  CHECK(config::format(read("? [1]\n: 2\n").problems) ==
        "f:1:3: cannot read this YAML: a key must be a scalar, not a list\n");
  CHECK(config::format(read(": 1\n").problems) ==
        "f:1:1: cannot read this YAML: a key must be a scalar, not nothing\n");
}

TEST_CASE("An unclosed quote is an error, although yaml-cpp accepts it") {
  for (const char* text :
       {"a: 1\nb: 'x", "a: 1\nb: 'x\n", "a: 1\nb: \"x\n\n", "a: 1\nb: 'x\nc: 1\n"}) {
    CAPTURE(text);
    CHECK(config::format(read(text).problems) ==
          "f:2:1: cannot read this YAML: a quote after this is never closed\n");
  }
}

TEST_CASE("The depth is limited") {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  CHECK(read(nested(32)).tree);
  CHECK_FALSE(read(nested(100000)).tree);
  CHECK_FALSE(read(std::string(100000, '[')).tree);
  CHECK_FALSE(read(std::string(100000, '{')).tree);
}

TEST_CASE("Not text") {
  CHECK(config::format(read(std::string("a: 1\nb: \0", 9)).problems) ==
        "f: has a zero byte in line 2: it is UTF-16, damaged or no text; save it as UTF-8\n");
  CHECK_FALSE(read(std::string("\xff\xfe\x61\x00", 4)).tree);  // UTF-16
  CHECK(config::format(read(std::string("\xff\xfen\0:\0 \0a\0", 10)).problems) ==
        "f: is UTF-16; save it as UTF-8\n");
  CHECK(read("\xef\xbb\xbfname: a\r\nseed: 1\r\n").tree->children.size() == 2);
}

TEST_CASE("Escapes of characters beyond \\uFFFF") {
  CHECK(read("a: \"\\U0001F600\"\n").tree->children[0].text == "\xf0\x9f\x98\x80");
  CHECK(config::format(read("a: \"\\ud83d\\ude00\"\n").problems)
            .find("write one beyond \\uFFFF as \"\\U0001F600\"") != std::string::npos);
}

TEST_CASE("Random bytes give at most a problem") {
  RandomStream random(5);
  const std::string syntax = "[]{}:,-?&*!|>'\"%@`#~ \t\n\r<=\\0ax.$";
  for (int i = 0; i < 3000; ++i) {
    std::string text;
    for (std::uint64_t n = random.below(60); n > 0; --n) {
      const bool any = random.below(20) == 0;
      text += any ? static_cast<char>(random.below(256)) : syntax[random.below(syntax.size())];
    }
    const Reading reading = read(text);
    CHECK((reading.tree || !reading.problems.empty()));
  }
}

TEST_CASE("A configuration that is cut or damaged anywhere gives at most a problem") {
  std::ifstream stream(test::fixtures() + "whole.yaml");
  const std::string whole(std::istreambuf_iterator<char>(stream), {});
  REQUIRE(whole.size() > 100);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    const Reading reading = read(whole.substr(0, size));
    CHECK((reading.tree || !reading.problems.empty()));
  }
  RandomStream random(6);
  for (int i = 0; i < 1000; ++i) {
    std::string text = whole;
    for (int n = 0; n < 3; ++n)
      text[random.below(text.size())] = static_cast<char>(random.below(256));
    const Reading reading = read(text);
    CHECK((reading.tree || !reading.problems.empty()));
  }
}

}  // namespace tolman
