// SPDX-License-Identifier: BSD-3-Clause
// The SDK's examples, built against the installed package: on a drive forwards, backwards and
// forwards again they recognise places and close loops.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "author/workshop.hpp"
#include "support/paths.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

constexpr int kFrames = 3 * 20 + 1;

int linesOf(const fs::path& file) {
  const std::string text = readText(file);
  return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
}

/// Lines of code, without blank ones and comments.
int codeLinesOf(const fs::path& file) {
  std::ifstream stream(file);
  int count = 0;
  for (std::string line; std::getline(stream, line);) {
    const auto start = line.find_first_not_of(' ');
    if (start != std::string::npos && line.compare(start, 2, "//") != 0) ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("the examples are short") {
  for (const char* name : {"hog_places", "hexagonal_grid_cells", "trajectory_writer"}) {
    INFO(name);
    const int lines = codeLinesOf(inSource("sdk/examples/" + std::string(name) + ".cpp"));
    CHECK(lines > 50);
    CHECK(lines < 150);
  }
}

TEST_CASE("the examples build from the installed package and work together") {
  const Workshop workshop;
  fs::copy(workshop.prefix() / "share/tolman/examples", workshop.folder() / "examples");
  const Finished built =
      workshop.shell("cd examples && cmake -S . -B build && cmake --build build");
  INFO(built.out << built.err);
  REQUIRE(built.exit_code == 0);

  const Finished ran = workshop.shell(
      "cd examples && tolman run town.yaml --plugin-path build --out run"
      " --set source.last=20 --set source.order=pingpong --set source.passes=3"
      " --set cells.loop_minimum_travel=8");
  INFO(ran.out << ran.err);
  REQUIRE(ran.exit_code == 0);
  const fs::path run = workshop.folder() / "examples/run";
  const auto metrics = readJson(run / "metrics.json");
  CHECK(metrics["frames"] == kFrames);
  CHECK(metrics["templates"] > 1);
  CHECK(metrics["templates"] < 20);  // most views came back
  CHECK(metrics["loop_links"] > 0);
  CHECK(metrics["map"]["ate"]["rmse_m"] < 0.5);

  const fs::path online = run / "artefacts/trajectory_writer/online.tum";
  CHECK(linesOf(online) == kFrames + 1);  // and a comment
  const Finished compared =
      workshop.shell("tolman eval examples/run/trajectory.tum " + online.string() + " --json");
  INFO(compared.out << compared.err);
  CHECK(compared.exit_code == 0);  // a file that others can read
}
