// SPDX-License-Identifier: BSD-3-Clause
// The town in the whole system: the shipped configurations, the drive of the demo, rendering to
// KITTI.
#include <algorithm>
#include <catch2/catch.hpp>
#include <sstream>
#include <string>

#include "process.hpp"
#include "support/data.hpp"
#include "support/paths.hpp"

namespace fs = std::filesystem;
using namespace tolman::test;

namespace {

const std::string kConfigs = inSource("configs/");

}  // namespace

TEST_CASE("every shipped configuration is valid") {
  int count = 0;
  for (const auto& entry : fs::recursive_directory_iterator(kConfigs)) {
    if (entry.path().extension() != ".yaml") continue;
    const fs::path folder = entry.path().parent_path().filename();
    if (folder == "experiments" || folder == "init" || folder == "try") continue;  // no whole ones
    const Finished check = tolman::test::tolman({"check", entry.path().string()});
    INFO(entry.path() << "\n" << check.err);
    CHECK(check.exit_code == 0);
    ++count;
  }
  CHECK(count >= 6);
}

TEST_CASE("scripts/demo builds all plugins that its configuration names") {
  const TemporaryFolder folder;
  const fs::path plugins = tolmanProgram().parent_path().parent_path() / "plugins";
  const fs::path program = folder.path() / "tolman";  // beside no plugins
  fs::copy_file(tolmanProgram(), program);
  std::istringstream names(TOLMAN_DEMO_PLUGINS);
  for (std::string name; names >> name;) {
    fs::copy_file(plugins / (name + ".so"), folder.path() / (name + ".so"));
  }
  const auto check = [&](const char* file) {
    return run(
        {program.string(), "check", kConfigs + file, "--plugin-path", folder.path().string()});
  };
  const Finished demo = check("demo.yaml");
  INFO(demo.err);
  CHECK(demo.exit_code == 0);
  CHECK(check("kitti.yaml").exit_code != 0);  // its source is not among them
}

TEST_CASE("the demo drives its block and closes the loop") {
  const TemporaryFolder folder;
  const std::string out = folder.path() / "run";
  const Finished done = tolman::test::tolman(
      {"run", kConfigs + "demo.yaml", "--set", "source.scale=0.35", "--out", out, "--quiet"});
  INFO(done.err);
  REQUIRE(done.exit_code == 0);
  const auto metrics = readJson(fs::path(out) / "metrics.json");
  CHECK(metrics.at("loop_links").get<int>() >= 1);
  CHECK(metrics.at("map").at("ate").at("rmse_m").get<double>() < 1.5);
  CHECK(fs::exists(fs::path(out) / "map.svg"));
}

TEST_CASE("a rendered town is a KITTI sequence with truth, loops and depth") {
  const TemporaryFolder folder;
  const std::string data = folder.path() / "sequence";
  const Finished render = tolman::test::tolman(
      {"dataset", "render", kConfigs + "town/district.yaml", "--set", "source.scale=0.15", "--set",
       "source.step=30", "--out", data, "--depth", "--quiet"});
  INFO(render.err);
  REQUIRE(render.exit_code == 0);
  CHECK(fs::exists(fs::path(data) / "depth_0" / "000000.png"));
  const std::string loops = readText(fs::path(data) / "loops.txt");
  CHECK(contains(loops, " same "));
  CHECK(contains(loops, " opposite "));
  const std::string poses = readText(fs::path(data) / "poses.txt");
  const auto lines = std::count(poses.begin(), poses.end(), '\n');
  CHECK(lines == 64);  // 1902 frames, every 30th
  const Finished check = tolman::test::tolman({"dataset", "check", data});
  INFO(check.out << check.err);
  CHECK(check.exit_code == 0);
  CHECK(contains(check.out, "64 stereo pairs of 186x56"));
}

TEST_CASE("a route that cannot be driven ends with the data's exit code and a remedy") {
  const Finished done = tolman::test::tolman(
      {"run", kConfigs + "town/route.yaml", "--set", "source.route=/no/such/poses.txt", "--quiet"});
  CHECK(done.exit_code == 5);
  CHECK(contains(done.err, "/no/such/poses.txt"));
}
