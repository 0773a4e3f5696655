// SPDX-License-Identifier: BSD-3-Clause
// From a sweep file to named points; errors are reported with their line.
#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>

#include "experiment/sweep_file.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::experiment;

namespace {

struct Read {
  std::vector<SweepPoint> points;
  std::string problems;

  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const SweepPoint& point : points) names.push_back(point.name);
    return names;
  }
};

Read read(const std::string& yaml) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.path() / "study.yaml") << yaml;
  config::Problems problems;
  const SweepFile sweep = readSweep(
      folder.path() / "study.yaml", [](const std::string&) { return std::nullopt; }, problems);
  Read read;
  if (problems.empty()) read.points = pointsOf(sweep, problems);
  for (const config::Problem& problem : problems) read.problems += config::format(problem) + "\n";
  return read;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("the product of grid, lists, sequences and seeds, the last fastest") {
  const Read sweep = read(
      "base: motion\n"
      "grid: {cells.period: [75, 150]}\n"
      "list: {model: {paper: {cells.plugin: a, cells.modules: 1}, full: {cells.plugin: b}}}\n"
      "sequences: {\"00\": data/00}\n"
      "seeds: 2\n");
  INFO(sweep.problems);
  CHECK(
      sweep.names() ==
      Names{"period=75,model=paper,sequence=00,seed=1", "period=75,model=paper,sequence=00,seed=2",
            "period=75,model=full,sequence=00,seed=1", "period=75,model=full,sequence=00,seed=2",
            "period=150,model=paper,sequence=00,seed=1",
            "period=150,model=paper,sequence=00,seed=2", "period=150,model=full,sequence=00,seed=1",
            "period=150,model=full,sequence=00,seed=2"});
  const SweepPoint& first = sweep.points.front();
  REQUIRE(first.settings.size() == 5);
  CHECK(first.settings[3].key == "source.path");
  CHECK(first.settings[4].value->text == "1");
}

TEST_CASE("whole stages, labels, and keys with one last part") {
  const Read sweep = read(
      "base: motion\n"
      "grid:\n  cells: [{plugin: pose_cells}, {plugin: other, cells: 3}]\n"
      "  odometry.noise: {none: 0, much: 0.1}\n  place.noise: [1]\n");
  INFO(sweep.problems);
  CHECK(sweep.names() == Names{"cells=pose_cells,odometry.noise=none,place.noise=1",
                               "cells=pose_cells,odometry.noise=much,place.noise=1",
                               "cells=plugin=other cells=3,odometry.noise=none,place.noise=1",
                               "cells=plugin=other cells=3,odometry.noise=much,place.noise=1"});
}

TEST_CASE("exclusions leave out") {
  const Read sweep = read(
      "base: motion\n"
      "grid: {cells.a: [1, 2], cells.b: [3, 4]}\n"
      "exclude: [{cells.a: 1, cells.b: [3, 4]}]\n"
      "seeds: [7]\n");
  INFO(sweep.problems);
  CHECK(sweep.names() == Names{"a=2,b=3,seed=7", "a=2,b=4,seed=7"});
}

TEST_CASE("random samples lie in their ranges") {
  const Read sweep = read(
      "base: motion\n"
      "random: {count: 64, keys: {cells.p: {min: 1, max: 1000, log: true}, "
      "cells.n: {min: 1, max: 4, integer: true}}}\n");
  INFO(sweep.problems);
  REQUIRE(sweep.points.size() == 64);
  int below = 0;
  std::vector<std::string> counts;
  for (const SweepPoint& point : sweep.points) {
    const double p = std::stod(point.settings[0].value->text);
    CHECK(p >= 1);
    CHECK(p <= 1000);
    below += p < 31.6 ? 1 : 0;  // the middle of the logarithm
    counts.push_back(point.settings[1].value->text);
  }
  CHECK(below == Approx(32).margin(12));
  for (const char* n : {"1", "2", "3", "4"}) {
    CHECK(std::ranges::count(counts, n) == Approx(16).margin(12));
  }
  CHECK(std::ranges::find(counts, "5") == counts.end());
}

TEST_CASE("errors in a sweep file are reported with line and remedy") {
  const auto told = [](const std::string& yaml, const std::string& part) {
    const std::string problems = read(yaml).problems;
    INFO(problems);
    CHECK(problems.find(part) != std::string::npos);
  };
  told("grid: {a: [1]}\n", "base: is missing");
  told(
      "base: motion\nlist: {alignment: {a: {b: 1}}}\n",
      "study.yaml:2:19: alignment: is a column of the table of `sweep collect`; rename the factor");
  told("base: motion\ngird: {a: [1]}\n", "study.yaml:2:1: gird: unknown key; did you mean 'grid'?");
  told("base: motion\ngrid: {a: 1}\n", ":2:11: a: expects a list of values, not one");
  told("base: motion\ngrid: {a: [1, 1]}\n", "has the value '1' twice");
  told("base: motion\ngrid: {a: [1]}\nexclude: [{b: 1}]\n", ":3:11: exclude: no factor 'b'");
  told("base: motion\ngrid: {a: [1]}\nexclude: [{a: 2}]\n", "leaves out no point");
  told("base: motion\ngrid: {a: [1, 2]}\nexclude: [{a: 1}, {a: 2}]\n",
       ":3:19: exclude: leaves out all points");
  told("base: motion\nseeds: none\n", "expects how many, or a list");
  told("base: motion\nrandom: {count: 5, keys: {a: {min: 2, max: 1}}}\n", "is no range");
  told("base: motion\nrandom: {count: 5, keys: {a: 3}}\n", "expects a range such as");
  told("base: motion\nrandom: {count: 2.5, keys: {a: {min: 1, max: 2}}}\n", "count: expects ");
  told("base: motion\nrandom: {count: 2, seed: -1, keys: {a: {min: 1, max: 2}}}\n",
       "random.seed: -1 is out of range");
  told("base: motion\nrandom: {count: 2, keys: {a: {min: 1, max: 2, log: yes}}}\n", "log: ");
  told("base: motion\nrandom: {count: 2, keys: {a: {min: 1.5, max: 2, integer: true}}}\n",
       "expects whole numbers for min and max");
  told("base: motion\nset: {name: x}\n", "points have names of their own");
}

TEST_CASE("a key that varies in two ways is refused, as one would silently override the other") {
  CHECK_THAT(read("base: motion\ngrid: {seed: [7, 8]}\nseeds: 2\n").problems,
             Catch::Contains("study.yaml:3:8: factor seed: is set at ") &&
                 Catch::Contains("for the same"));
  const std::string period = "base: motion\ngrid: {cells.period: [75, 150]}\n";
  CHECK_THAT(read(period + "list: {size: {small: {cells.period: 10}, large: {cells.rings: 3}}}\n")
                 .problems,
             Catch::Contains("study.yaml:3:") && Catch::Contains("cells.period: is set at ") &&
                 Catch::Contains("study.yaml:2:") && Catch::Contains("for the same runs"));
  CHECK_THAT(read(period + "list: {size: {a: {cells: {plugin: x, period: 10}}}}\n").problems,
             Catch::Contains("for the same runs"));
  CHECK_THAT(read(period + "sequences: {a: {source.path: x, cells.period: 3}}\n").problems,
             Catch::Contains("for the same runs"));
  CHECK(read(period + "list: {size: {a: {cells: {plugin: x, rings: 3}}}}\nseeds: 2\n")
            .problems.empty());
}
