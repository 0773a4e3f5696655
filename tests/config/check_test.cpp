// SPDX-License-Identifier: BSD-3-Clause
// Checks a map against a schema: values, defaults and problems.
#include <catch2/catch.hpp>
#include <cmath>

#include "config/loader.hpp"
#include "config/toy_system.hpp"
#include "config/values.hpp"

namespace tolman {
namespace {

struct Checked {
  ParameterValues values;
  std::string problems_text;
};

Checked checkText(const std::string& yaml, const std::string& plugin) {
  config::Problems problems;
  const auto map = config::readYaml(yaml, config::Origin::ofFile("conf/a.yaml"), problems);
  REQUIRE(map);
  const config::Subject subject{"stage", "plugin " + plugin, {"plugin"}};
  Checked checked;
  checked.values =
      config::check(*map, test::toySchema(plugin), subject, {"/work", "/home/ada"}, problems);
  checked.problems_text = config::format(problems);
  return checked;
}

template <class T>
T valueOf(const Checked& checked, const std::string& name) {
  return std::get<T>(checked.values.at(name));
}

struct IntegerAndReal {
  std::int64_t large = 0;
  double below = 0;
  double above = 0;
  static constexpr auto declaration() {
    using P = IntegerAndReal;
    return parameters(parameter("large", &P::large),
                      parameter("below", &P::below).range(-INFINITY, 2).unit("m"),
                      parameter("above", &P::above).range(-1, INFINITY));
  }
};

}  // namespace

TEST_CASE("Values of each type, with defaults for the rest") {
  const Checked source =
      checkText("{plugin: x, path: ~/kitti, loop: true, order: pingpong}", "toy_source");
  CHECK(source.problems_text == "");
  CHECK(valueOf<std::string>(source, "path") == "/home/ada/kitti");
  CHECK(valueOf<bool>(source, "loop"));
  CHECK(valueOf<std::string>(source, "order") == "pingpong");
  CHECK(valueOf<std::int64_t>(source, "first") == 0);
  CHECK(source.values.count("plugin") == 0);

  const Checked odometry =
      checkText("{scale: 2, pyramid: [1, 2.5e-1], solver: 007}", "toy_odometry");
  CHECK(odometry.problems_text == "");
  CHECK(valueOf<double>(odometry, "scale") == 2.0);
  CHECK(valueOf<std::vector<double>>(odometry, "pyramid") == std::vector{1.0, 0.25});
  CHECK(valueOf<std::string>(odometry, "solver") == "007");  // a number is fine as text
  CHECK(valueOf<std::int64_t>(odometry, "active_points") == 2000);
}

TEST_CASE("Limits are inclusive") {
  CHECK(checkText("{scale: 0.5}", "toy_odometry").problems_text == "");
  CHECK(checkText("{scale: 8}", "toy_odometry").problems_text == "");
  CHECK(checkText("{scale: 8.000001}", "toy_odometry").problems_text ==
        "conf/a.yaml:1:9: stage.scale: 8.000001 is out of range: 0.5 ... 8 pixels\n");
}

TEST_CASE("One-sided ranges and 64-bit integers") {
  config::Problems problems;
  const auto map = config::readYaml("{large: 9007199254740993, below: 3, above: -2}",
                                    config::Origin::ofFile("a.yaml"), problems);
  const auto values = config::check(*map, schemaOf<IntegerAndReal>(), {"x", "", {}}, {}, problems);
  CHECK(std::get<std::int64_t>(values.at("large")) == 9007199254740993);  // not through a double
  CHECK(config::format(problems) ==
        "a.yaml:1:34: x.below: 3 is out of range: at most 2 m\n"
        "a.yaml:1:44: x.above: -2 is out of range: at least -1\n");
}

TEST_CASE("A parameter with an illegal value keeps its default") {
  const Checked checked = checkText("{active_points: many, pyramid: [1, x, y]}", "toy_odometry");
  CHECK(valueOf<std::int64_t>(checked, "active_points") == 2000);
  CHECK(valueOf<std::vector<double>>(checked, "pyramid") == std::vector{1.0, 0.5});
  CHECK(checked.problems_text ==
        "conf/a.yaml:1:17: stage.active_points: expects an integer, not 'many'\n"
        "conf/a.yaml:1:36: stage.pyramid.1: expects a number, not 'x'\n"
        "conf/a.yaml:1:39: stage.pyramid.2: expects a number, not 'y'\n");
}

TEST_CASE("A missing required parameter is reported with its doc") {
  CHECK(checkText("{plugin: toy_source}", "toy_source").problems_text ==
        "conf/a.yaml:1:1: stage.path: is missing for plugin toy_source: Folder of the data.\n");
}

TEST_CASE("Unknown parameter of a plugin without parameters") {
  CHECK(checkText("{radius: 3}", "toy_map").problems_text ==
        "conf/a.yaml:1:2: stage.radius: unknown parameter (plugin toy_map has no parameters)\n");
}

TEST_CASE("Quoted scalars are texts or choices, not numbers or booleans") {
  CHECK(checkText("{solver: \"5\"}", "toy_odometry").problems_text == "");
  CHECK(checkText("{path: x, order: \"forward\"}", "toy_source").problems_text == "");
  CHECK(checkText("{path: x, loop: \"true\"}", "toy_source").problems_text ==
        "conf/a.yaml:1:17: stage.loop: expects true or false, not a text; remove the quotes\n");
}

}  // namespace tolman
