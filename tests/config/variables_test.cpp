// SPDX-License-Identifier: BSD-3-Clause
// Environment variables in values.
#include <catch2/catch.hpp>
#include <cstdlib>

#include "config/loader.hpp"
#include "config/toy_system.hpp"

namespace tolman {
namespace {

/// The text after expansion, or the complaint.
std::string expanded(const std::string& text) {
  const auto environment =
      test::environmentOf({{"A", "one"}, {"EMPTY", ""}, {"TRICK", "${A} [x]"}, {"_x9", "9"}});
  std::string used;
  const auto result = config::expandVariables(text, environment, used);
  return result.isOk() ? result.value() : result.status().message();
}

}  // namespace

TEST_CASE("Variables and defaults are substituted") {
  CHECK(expanded("plain $A $ text") == "plain $A $ text");
  CHECK(expanded("${A}") == "one");
  CHECK(expanded("x${A}y${_x9}z") == "xoney9z");
  CHECK(expanded("${A:-two}") == "one");
  CHECK(expanded("${B:-two}") == "two");
  CHECK(expanded("${B:-}") == "");
  CHECK(expanded("${B:-a:-b}") == "a:-b");
  CHECK(expanded("${EMPTY}") == "");
  CHECK(expanded("${EMPTY:-two}") == "two");  // as in a shell
}

TEST_CASE("$${ stands for ${, and the value of a variable is not expanded again") {
  CHECK(expanded("$${A}") == "${A}");
  CHECK(expanded("$${A} ${A}") == "${A} one");
  CHECK(expanded("$$${A}") == "$${A}");
  CHECK(expanded("${TRICK}") == "${A} [x]");
  CHECK(expanded("${A}${A}") == "oneone");
}

TEST_CASE("Illegal uses are refused with a remedy") {
  CHECK(expanded("${B}") == "the environment variable B is not set; set it or write ${B:-default}");
  CHECK(expanded("${A") == "'${' without '}'");
  CHECK(expanded("${A:-${B}}") == "${A:-...} cannot contain another ${...}");
  CHECK(expanded("${}").starts_with("'${}' is not a variable"));
  CHECK(expanded("${a b}").starts_with("'${a b}' is not a variable"));
  CHECK(expanded("${A-x}").starts_with("'${A-x}' is not a variable"));
}

TEST_CASE("A quoted variable may be a number, and its origin has the name of the variable") {
  const auto read = [](const std::string& yaml, const config::Environment& environment) {
    config::Problems problems;
    return config::readYaml(yaml, config::Origin::ofFile("f"), problems, environment).value();
  };
  const config::Node defaults = read("'${A:-1}${B:-2}'", test::environmentOf({}));
  CHECK(defaults.text == "12");
  CHECK_FALSE(defaults.quoted);
  CHECK(defaults.origin.variables == "A (not set), B (not set)");
  const auto environment = test::environmentOf({{"A", ""}, {"C", "3"}});
  const config::Node map = read("{'${C}': ['${A:-1}${B:-2}${C}']}", environment);
  REQUIRE(map.find("${C}") != nullptr);  // keys are not expanded
  CHECK(map.children[0].children[0].text == "123");
  CHECK(map.children[0].children[0].origin.variables == "A (empty), B (not set), C");
}

TEST_CASE("processEnvironment() reads the environment of this process") {
  REQUIRE(setenv("TOLMAN_TEST_VARIABLE", "here", 1) == 0);
  CHECK(config::processEnvironment()("TOLMAN_TEST_VARIABLE") == "here");
  REQUIRE(unsetenv("TOLMAN_TEST_VARIABLE") == 0);
  CHECK_FALSE(config::processEnvironment()("TOLMAN_TEST_VARIABLE"));
}

}  // namespace tolman
