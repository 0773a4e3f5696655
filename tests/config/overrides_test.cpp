// SPDX-License-Identifier: BSD-3-Clause
// --set: its changes, their order, and its failures.
#include <catch2/catch.hpp>

#include "config/loader.hpp"
#include "config/toy_system.hpp"

namespace tolman {
namespace {

test::CheckedSystem with(const std::vector<std::string>& overrides) {
  return test::checkSystem("whole.yaml", overrides, {{"N", "9"}, {"HOME", "/home/ada"}});
}

}  // namespace

TEST_CASE("--set changes scalars, adds parameters and addresses items of lists") {
  const test::CheckedSystem system =
      with({"seed=11", "odometry.scale=2.5", "odometry.pyramid=[1, 2, 3]", "observers.1.port=${N}",
            "source.path=~/06", "pipeline.mode=realtime"});
  CHECK(system.complaints() == "");
  CHECK(system.config.general.seed == 11);
  CHECK(system.config.pipeline.mode == config::PipelineMode::Realtime);
  CHECK(system.config.pipeline.queue == 4);  // beside it, untouched
  CHECK(std::get<double>(system.of("odometry").at("scale")) == 2.5);
  CHECK(std::get<std::vector<double>>(system.of("odometry").at("pyramid")).size() == 3);
  CHECK(std::get<std::int64_t>(system.of("second").at("port")) == 9);
  CHECK(std::get<std::string>(system.of("source").at("path")) == "/home/ada/06");
}

TEST_CASE("A path on the command line refers to the working directory") {
  const test::CheckedSystem system = with({"source.path=data"});
  CHECK(std::get<std::string>(system.of("source").at("path")) ==
        (std::filesystem::current_path() / "data").string());
}

TEST_CASE("Quotes keep what YAML would leave out") {
  const test::CheckedSystem system = with({"source.path=\"/a #2 \"", "name='x # y'"});
  CHECK(system.complaints() == "");
  CHECK(std::get<std::string>(system.of("source").at("path")) == "/a #2 ");
  CHECK(system.config.general.name == "x # y");
}

TEST_CASE("A name is one that JSON and XML can hold") {
  CHECK(with({"name=\"a\\e[31m\""}).config.general.name == "a\xef\xbf\xbd[31m");
  CHECK(with({"name=\"Übung 3\""}).config.general.name == "Übung 3");
}

TEST_CASE("A later --set overrides an earlier one") {
  CHECK(with({"seed=1", "seed=2"}).config.general.seed == 2);
}

TEST_CASE("A plugin set by --set replaces the stage, whatever the order of the options") {
  const test::CheckedSystem system = with({"odometry.port=81", "odometry.plugin=toy_observer"});
  CHECK(system.complaints() == "");  // toy_odometry's active_points are gone, the port stayed
  CHECK(std::get<std::int64_t>(system.of("odometry").at("port")) == 81);
  CHECK(system.loaded.notes ==
        std::vector<std::string>{"odometry: toy_observer replaces toy_odometry, whose parameters "
                                 "are not used: active_points"});
  CHECK(with({"odometry.plugin=toy_odometry"}).loaded.notes.empty());
  CHECK(with({"odometry.plugin=toy_odometry"}).loaded.tree.find("odometry")->children.size() == 2);
}

TEST_CASE("The index after the last item appends, also to a missing list") {
  const test::CheckedSystem system =
      with({"observers.2.plugin=toy_observer", "observers.2.name=c"});
  CHECK(system.complaints() == "");
  CHECK(system.config.stages.size() == 8);
  CHECK(system.config.stages.back().path == "observers.2");

  config::Node tree;
  config::Problems problems;
  config::applyOverrides(tree, {"observers.0.plugin=a"}, test::environmentOf({}), problems);
  CHECK(problems.empty());
  REQUIRE(tree.find("observers") != nullptr);
  CHECK(tree.find("observers")->isSequence());
}

TEST_CASE("An illegal --set is reported as typed") {
  const auto [argument, expected] = GENERATE(table<const char*, const char*>({
      {"seed", "--set seed: write --set key.path=value\n"},
      {"=1", "--set =1: the key path has an empty part\n"},
      {"source..path=1", "--set source..path=1: the key path has an empty part\n"},
      {"extends=b.yaml", "--set extends=b.yaml: 'extends' is allowed in files only\n"},
      {"odometry.pyramid=[1",
       "--set odometry.pyramid=[1: cannot read this YAML: a '[' has no ']'\n"},
      {"observers.7.port=1",
       "--set observers.7.port=1: no item '7' in a list of 2; indices start at 0\n"},
      {"observers.first.port=1",
       "--set observers.first.port=1: no item 'first' in a list of 2; indices start at 0\n"},
      {"seed.low=1", "--set seed.low=1: 'low' cannot be set: its parent is the scalar '7'\n"},
      {"name=", "--set name=: name: expects a text, not nothing\n"},
      {"name=${NOWHERE}",
       "--set name=${NOWHERE}: name: the environment variable NOWHERE is not set; set it or write "
       "${NOWHERE:-default}\n"},
      {"odometry.plugni=x",
       "--set odometry.plugni=x: odometry.plugni: unknown parameter; did you mean 'plugin'? "
       "(parameters of plugin toy_odometry: active_points, scale, pyramid, solver)\n"},
  }));
  CHECK(with({argument}).complaints() == expected);
}

}  // namespace tolman
