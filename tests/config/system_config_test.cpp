// SPDX-License-Identifier: BSD-3-Clause
// From the tree to settings and stages.
#include "config/system_config.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "config/toy_system.hpp"
#include "support/data.hpp"

namespace tolman {
namespace {

const char* const kChain =
    "source: {plugin: toy_source, path: x}\nodometry: {plugin: toy_odometry}\n"
    "place: {plugin: toy_place}\ncells: {plugin: toy_cells}\nmap: {plugin: toy_map}\n";

test::CheckedSystem checkText(const std::string& name, const std::string& text) {
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / name).string();
  std::ofstream(file) << text;
  return test::checkSystem(file);
}

}  // namespace

TEST_CASE("Stages are in processing order, with instance, policy and origin") {
  const test::CheckedSystem system = test::checkSystem("whole.yaml");
  std::string shown;
  for (const config::StageConfig& stage : system.config.stages) {
    shown += stage.path + " = " + stage.plugin + " as " + stage.instance + ", " +
             std::string(enumName(stage.role)) + ", " + std::string(enumName(stage.on_failure)) +
             "\n";
  }
  CHECK(shown ==
        "source = toy_source as source, source, stop\n"
        "odometry = toy_odometry as odometry, odometry, stop\n"
        "place = toy_place as place, place, stop\n"
        "cells = toy_cells as cells, cells, stop\n"
        "map = toy_map as map, map, skip\n"
        "observers.0 = toy_observer as toy_observer, observer, stop\n"
        "observers.1 = toy_observer as second, observer, stop\n");
  CHECK(test::withoutFolder(config::text(system.config.stages[0].pluginOrigin())) ==
        "whole.yaml:6:11");
}

TEST_CASE("A minimal configuration has the host's defaults and the name of the file") {
  const test::CheckedSystem system = checkText("my-run.yaml", kChain);
  CHECK(system.complaints() == "");
  CHECK(system.config.general.name == "my-run");
  CHECK(system.config.general.seed == 1);
  CHECK(system.config.pipeline.mode == config::PipelineMode::Lossless);
  CHECK(system.config.evaluation.alignment == config::AlignmentChoice::Auto);
  CHECK(system.config.record.arrays_every == -1);
  CHECK(system.config.stages.size() == 5);
}

TEST_CASE("Segments are named, or a list of lengths") {
  const auto named = checkText("a.yaml", std::string(kChain) + "evaluation: {segments: short}\n");
  CHECK(named.config.evaluation.segments == config::Segments::Short);
  CHECK(named.config.evaluation.segment_lengths.empty());
  const auto listed =
      checkText("a.yaml", std::string(kChain) + "evaluation: {segments: [5, 10]}\n");
  CHECK(listed.complaints() == "");
  CHECK(listed.config.evaluation.segment_lengths == std::vector{5.0, 10.0});
  const auto wrong = checkText("a.yaml", std::string(kChain) + "evaluation: {segments: [0]}\n");
  REQUIRE(wrong.problems.size() == 1);
  CHECK(wrong.problems[0].message == "0 is out of range: 0.1 ... 1000000 m");
}

TEST_CASE("Groups and lists of the wrong kind are refused, also when left empty") {
  const auto system =
      checkText("a.yaml", std::string(kChain) + "pipeline:\nrecord: 5\nobservers:\n");
  REQUIRE(system.problems.size() == 3);
  CHECK(system.problems[0].message == "expects a map of keys, not nothing");
  CHECK(system.problems[1].message == "expects a map of keys, not '5'");
  CHECK(system.problems[2].message == "expects a list such as [{plugin: progress}], not nothing");
}

TEST_CASE("An empty plugin name is refused") {
  const auto system = checkText("a.yaml", std::string(kChain) + "observers: [{plugin: \"\"}]\n");
  REQUIRE(system.problems.size() == 1);
  CHECK(system.problems[0].message == "is empty");
}

}  // namespace tolman
