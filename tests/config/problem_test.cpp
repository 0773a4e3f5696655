// SPDX-License-Identifier: BSD-3-Clause
// Text and order of problems.
#include <catch2/catch.hpp>

#include "config/tree.hpp"

namespace tolman {

using config::Origin;

TEST_CASE("Origins are written as file:line:column or as the option") {
  CHECK(config::text(Origin{}) == "default");
  CHECK(config::text(Origin::ofFile("a.yaml")) == "a.yaml");
  CHECK(config::text(Origin{Origin::Kind::File, "a.yaml", 4, 13, {}}) == "a.yaml:4:13");
  CHECK(config::text(Origin{Origin::Kind::CommandLine, "--set a=1", 0, 0, {}}) == "--set a=1");
}

TEST_CASE("Problems are sorted by file and numeric position, the command line last") {
  const auto at = [](int line, int column) {
    return Origin{Origin::Kind::File, "a.yaml", line, column, {}};
  };
  const Origin typed{Origin::Kind::CommandLine, "--set a=1", 0, 0, {}};
  CHECK(config::format(config::Problems{{typed, "a", "m1"},
                                        {at(10, 1), "b", "m2"},
                                        {at(9, 7), "c", "m3"},
                                        {at(9, 2), "", "m4"},
                                        {Origin::ofFile("a.yaml"), "d", "m5"},
                                        {at(9, 2), "e", "m6"}}) ==
        "a.yaml: d: m5\n"
        "a.yaml:9:2: m4\n"
        "a.yaml:9:2: e: m6\n"
        "a.yaml:9:7: c: m3\n"
        "a.yaml:10:1: b: m2\n"
        "--set a=1: a: m1\n");
  CHECK(config::format(config::Problems{}).empty());
}

}  // namespace tolman
