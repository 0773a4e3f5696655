// SPDX-License-Identifier: BSD-3-Clause
// `tolman plugins new` for each role: with the commands of its README the new plugin builds, passes
// its test and runs in a chain.
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <catch2/catch.hpp>

#include "author/markdown_script.hpp"
#include "author/workshop.hpp"
#include "support/paths.hpp"
#include "tolman/roles.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr int kFrames = 9;

/// The README's commands, with a run that is short.
std::string commandsOf(const fs::path& readme, const std::string& role) {
  std::string script = scriptOf(readText(readme));
  const std::string run = "tolman run chain.yaml";
  const auto at = script.find(run);
  REQUIRE(at != std::string::npos);
  const std::string small = role == "source" ? "" : " --set source.scale=0.15";
  return script.insert(at + run.size(),
                       " --set source.last=" + std::to_string(kFrames - 1) + small);
}

/// Each step of the CI file does something, and builds and tests are among them.
void checkCi(const fs::path& file) {
  const YAML::Node steps = YAML::LoadFile(file.string())["jobs"]["test"]["steps"];
  std::string commands;
  for (const YAML::Node& step : steps) {
    CHECK((step["run"] || step["uses"]));
    if (step["run"]) commands += step["run"].as<std::string>() + "\n";
  }
  CHECK(contains(commands, "cmake --build build"));
  CHECK(contains(commands, "ctest --test-dir build"));
}

void checkRun(const fs::path& run, const std::string& role, const std::string& name) {
  CHECK(readJson(run / "metrics.json")["frames"] == kFrames);
  CHECK(contains(readText(run / "config.resolved.yaml"), name));
  if (role != "observer") return;
  const std::string table = readText(run / "artefacts" / name / "frames.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == kFrames + 1);
}

}  // namespace

TEST_CASE("a new plugin of each role builds, passes and runs") {
  const Workshop workshop;
  for (const std::string_view role_name : tolman::kRoleNames) {
    const std::string role(role_name);
    const std::string name = "my_" + role;
    const fs::path repository = workshop.folder() / name;
    const Finished made = workshop.shell("tolman plugins new " + role + " " + name);
    INFO(role << "\n" << made.out << made.err);
    REQUIRE(made.exit_code == 0);
    CHECK(contains(made.out,
                   "cmake -S . -B build -DCMAKE_PREFIX_PATH=" + workshop.prefix().string() + "\n"));
    checkCi(repository / ".github/workflows/ci.yml");

    const Finished used =
        workshop.shell("cd " + name + "\n" + commandsOf(repository / "README.md", role));
    INFO(used.out << used.err);
    REQUIRE(used.exit_code == 0);
    CHECK(contains(used.out, "100% tests passed, 0 tests failed out of 3"));
    CHECK(contains(used.out, name));  // described
    CHECK_FALSE(contains(used.out + used.err, "warning:"));
    checkRun(repository / "runs/latest", role, name);
  }
}

TEST_CASE("the test of a new plugin prints why a call failed") {
  const Workshop workshop;
  const Finished finished = workshop.shell(
      "tolman plugins new place p && cd p\n"
      "sed -i '0,/::configure(.*{/s//&\\n  return tolman::Status::failed(\"no \" \"film\");/' "
      "p.cpp\n"
      "cmake -S . -B build && cmake --build build && build/p_test");
  INFO(finished.out << finished.err);
  CHECK(finished.exit_code != 0);
  CHECK(contains(finished.out, "no film"));
  for (const std::string_view role : tolman::kRoleNames) {
    INFO(role);
    const auto tests = inSource("sdk/template/" + std::string(role) + "/tests/@NAME@_test.cpp.in");
    CHECK(contains(readText(tests), "REQUIRE_OK("));
    CHECK_FALSE(contains(readText(tests), ".isOk()"));
  }
}

TEST_CASE("a plugin names the modules of OpenCV that it uses") {
  const Workshop workshop;
  const std::string use =
      "tolman plugins new place p && cd p\n"
      "sed -i 's/plugin.cpp)/plugin.cpp rotation.cpp OPENCV COMPONENTS calib3d)/' CMakeLists.txt\n"
      "echo '#include <opencv2/calib3d.hpp>' >rotation.cpp\n"
      "echo 'void turn(cv::Mat& a, cv::Mat& R) { cv::Rodrigues(a, R); }' >>rotation.cpp\n"
      "cmake -S . -B build -DBUILD_TESTING=OFF && cmake --build build\n"
      "tolman plugins doctor build/tolman_place_p.so\n";
  const Finished used = workshop.shell(use);
  INFO(used.out << used.err);
  CHECK(used.exit_code == 0);
  const Finished refused = workshop.shell(
      "cd p && sed -i 's/OPENCV COMPONENTS/COMPONENTS/' CMakeLists.txt && cmake -S . -B build");
  CHECK(refused.exit_code != 0);
  CHECK(contains(refused.err, "COMPONENTS are those of OPENCV"));
}

TEST_CASE("a folder that holds something is refused and left as it is") {
  const Workshop workshop;
  const Finished finished =
      workshop.shell("mkdir -p mine && echo precious >mine/file && tolman plugins new map m mine");
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "mine: is there already and not an empty folder"));
  CHECK(readText(workshop.folder() / "mine/file") == "precious\n");
  CHECK_FALSE(fs::exists(workshop.folder() / "mine/CMakeLists.txt"));
}

TEST_CASE("wrong roles and names are refused with what would be right") {
  const Finished role = tolman::test::tolman({"plugins", "new", "plase", "x"});
  CHECK(role.exit_code == 2);
  CHECK(contains(role.err, "did you mean 'place'?"));
  const Finished name = tolman::test::tolman({"plugins", "new", "place", "My-Places"});
  CHECK(name.exit_code == 2);
  CHECK(contains(name.err, "as my_places"));
}

TEST_CASE("the id of an installed plugin is refused, in its own role and in others") {
  const Workshop workshop;
  for (const char* role : {"place", "cells"}) {
    const Finished taken = tolman::test::tolman(
        {"plugins", "new", role, "bayesian_attractor", (workshop.folder() / "mine").string()});
    INFO(taken.err);
    CHECK(taken.exit_code == 2);
    CHECK(contains(taken.err,
                   "'bayesian_attractor' is the id of a plugin that is installed (cells, "));
    CHECK(contains(taken.err, "choose another, such as my_bayesian_attractor\n"));
    CHECK_FALSE(fs::exists(workshop.folder() / "mine"));
  }
}

TEST_CASE("without the templates the remedy is named") {
  const Workshop workshop;
  fs::remove_all(workshop.prefix() / "share/tolman/template");
  const Finished finished = workshop.shell("tolman plugins new map m");
  CHECK(finished.exit_code == 8);
  CHECK(contains(finished.err, "libtolman-sdk-dev"));
}
