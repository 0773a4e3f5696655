// SPDX-License-Identifier: BSD-3-Clause
// config.resolved.yaml: complete, and the same system when loaded again.
#include <catch2/catch.hpp>
#include <fstream>

#include "config/system_config.hpp"
#include "config/toy_system.hpp"
#include "support/data.hpp"

namespace tolman {
namespace {

std::string resolved(const test::CheckedSystem& system) {
  return config::resolvedYaml(system.config, system.values);
}

/// The system that the resolved text gives when read at another place.
test::CheckedSystem reloaded(const test::CheckedSystem& system) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "config.resolved.yaml").string();
  std::ofstream(file) << resolved(system);
  return test::checkSystem(file);
}

}  // namespace

TEST_CASE("The resolved configuration has every value, defaults included") {
  const test::CheckedSystem system =
      test::checkSystem("whole.yaml", {"source.path=/data/06", "evaluation.segments=[5, 10.5]"});
  REQUIRE(system.complaints() == "");
  CHECK(resolved(system) == R"(continue: ""
localise: ""
name: whole
on_findings: stop
seed: 7
threads: 0
pipeline:
  input_policy: drop_oldest
  mode: lossless
  queue: 4
  speed: 1
evaluation:
  alignment: se3
  body: ""
  loop_height: 0
  segment_lengths: [5, 10.5]
  segments: auto
  sessions: own
  truth: ""
  truth_match: interpolate
  truth_offset: 0
record:
  arrays_every: -1
  replay: false
  report: true
  state_every: 30
isolation:
  deadline: 60
  memory_limit: 4096
checks:
  images: true
  max_acceleration: 50
  max_speed: 100
  max_turn_rate: 10
rectification:
  field_of_view: 90
  mode: auto
  scale: 1
images:
  crop: []
  mask: []
  scale: 1
source:
  plugin: toy_source
  name: source
  on_failure: stop
  isolation: none
  first: 0
  loop: false
  order: forward
  path: /data/06
odometry:
  plugin: toy_odometry
  name: odometry
  on_failure: stop
  isolation: none
  active_points: 1500
  pyramid: [1, 0.5]
  scale: 1.25
  solver: dense
place:
  plugin: toy_place
  name: place
  on_failure: stop
  isolation: none
cells:
  plugin: toy_cells
  name: cells
  on_failure: stop
  isolation: none
map:
  plugin: toy_map
  name: map
  on_failure: skip
  isolation: none
observers:
  - plugin: toy_observer
    name: toy_observer
    on_failure: stop
    isolation: none
    port: 8080
  - plugin: toy_observer
    name: second
    on_failure: stop
    isolation: none
    port: 8080
)");
}

TEST_CASE("Loaded again, the resolved configuration gives the same values and the same text") {
  const test::CheckedSystem system = test::checkSystem(
      "whole.yaml", {"source.path=/a b/ü", "odometry.scale=2.3000000000000003",
                     "odometry.pyramid=[0.1, 1e-300, 16]", "evaluation.segments=[1.5]"});
  REQUIRE(system.complaints() == "");
  const test::CheckedSystem again = reloaded(system);
  CHECK(again.complaints() == "");
  CHECK(again.values == system.values);
  CHECK(resolved(again) == resolved(system));
  CHECK(again.config.evaluation.segment_lengths == std::vector{1.5});
}

TEST_CASE("Texts with special characters are written and read back") {
  const std::string text =
      GENERATE(as<std::string>(), "", "~", "null", "true", "010", "a: b", "# c", " spaces ",
               "say \"no\" \\ yes", "$${HOME} $5 $$", "a\nb\tc", "[1, 2]", "*x", "&x", "!x", "-",
               "ünïcödé", "\x01\x7f");
  CAPTURE(text);
  test::CheckedSystem system = test::checkSystem("whole.yaml");
  system.values["odometry"]["solver"] = text;
  // control characters are written as escapes, which YAML turns back
  const test::CheckedSystem again = reloaded(system);
  CHECK(again.complaints() == "");
  CHECK(std::get<std::string>(again.of("odometry").at("solver")) == text);
}

TEST_CASE("explain shows the origin of each value") {
  const test::CheckedSystem system =
      test::checkSystem("layers/top.yaml", {"odometry.scale=${SCALE:-4}"}, {});
  const std::string text = test::withoutFolder(config::explain(system.config, system.values));
  const auto has = [&](const std::string& line) {
    CAPTURE(text, line);
    CHECK(text.find(line + "\n") != std::string::npos);
  };
  has("name: top                                   # layers/top.yaml:2:7");
  has("seed: 2                                     # layers/night.yaml:1:7");
  has("threads: 0                                  # default");
  has("  active_points: 1000                       # layers/base.yaml:4:49");
  has("  scale: 4                                  # --set odometry.scale=${SCALE:-4} with SCALE "
      "(not "
      "set) of the environment");
  has("    name: b                                 # layers/night.yaml:4:75");
}

}  // namespace tolman
