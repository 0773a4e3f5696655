// SPDX-License-Identifier: BSD-3-Clause
// The figures show the numbers of the record.
#include "report/figures.hpp"

#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "report/recorded_walk.hpp"
#include "report/sample_pages.hpp"
#include "report/svg.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

struct RecordedRun {
  test::TemporaryFolder folder;
  std::unique_ptr<record::RunReader> reader;
  RunData data;

  RecordedRun() {
    test::recordRichRun(folder.path(), 12, "sample");
    reader = record::RunReader::open(folder.path()).value();
    data = readRun(*reader, {}).value();
  }
};

}  // namespace

TEST_CASE("errors are those of the aligned frames") {
  const RecordedRun sample;
  REQUIRE(sample.data.map_error.metres.size() == 12);
  CHECK(sample.data.map_error.seconds.back() == Approx(1.1));
  // Six frames are 1 cm off: the alignment shares it out.
  for (const double metres : sample.data.map_error.metres)
    CHECK(metres == Approx(0.005).margin(5e-4));
  const std::string svg = errorFigure(sample.data);
  CHECK(test::countOf(svg, "<polyline") == 2);
  CHECK(svg.find("map, rmse 0.005 m") != std::string::npos);
}

TEST_CASE(
    "heights are drawn over the driven distance, in metres of the truth; level ones are not") {
  RecordedRun sample;
  CHECK(elevationFigure(sample.data).empty());
  RunData climbing;
  climbing.metrics.alignment = evaluation::Alignment::Sim3;
  climbing.metres = 2;
  for (int i = 0; i < 11; ++i) {
    evaluation::TrajectoryPose pose;
    pose.frame = i;
    pose.T_world_camera.translation() = Eigen::Vector3d(0, -0.3 * i, 0.4 * i);
    climbing.map.push_back(pose);
    pose.T_world_camera.translation().y() = 0;
    climbing.odometry.push_back(pose);
  }
  const std::string svg = elevationFigure(climbing);
  CHECK(test::countOf(svg, "<polyline") == 2);
  CHECK(svg.find(">6<") != std::string::npos);   // 10 steps of 0.3 units of 2 m
  CHECK(svg.find(">10<") != std::string::npos);  // 10 steps of 0.5 units of 2 m
  CHECK(svg.find("truth") == std::string::npos);
  climbing.has_metres = false;
  CHECK(elevationFigure(climbing).empty());
}

TEST_CASE("each view is a dot, novel and familiar ones in their own colour") {
  const RecordedRun sample;
  const auto places = sample.reader->records<PlaceObservation>().value();
  const std::string svg = templateFigure(places);
  CHECK(test::countOf(svg, "fill=\"" + std::string(kBlue) + "\"") == 6);
  CHECK(test::countOf(svg, "fill=\"" + std::string(kVermilion) + "\"") == 6);
}

TEST_CASE("the activity of every unit is drawn at four moments") {
  const RecordedRun sample;
  const evaluation::CellHistory& cells = sample.data.cells;
  REQUIRE((cells.rings.size() == 1 && cells.sheets.size() == 1));
  const std::string svg = activityFigure(cells, sample.reader->records<Decision>().value());
  CHECK(test::countOf(svg, "stroke-width=\"6\"") == 4 * 4);
  CHECK(test::countOf(svg, "<image") == 4);
  CHECK(svg.find("frame 11, heading 0.0 deg") != std::string::npos);
  CHECK(svg.find("grid.activity, one period of 30 m: x to the right, y up") != std::string::npos);
}

TEST_CASE("arrays that no figure knows are drawn as they are, and one by one") {
  const RecordedRun sample;
  REQUIRE(sample.data.cells.others.size() == 1);
  const std::string svg = arrayFigure(sample.data.cells.others);
  CHECK(svg.find("noise (2)") != std::string::npos);
  CHECK(test::countOf(svg, "<polyline") == 2);
  evaluation::PopulationHistory large = sample.data.cells.others[0];
  large.info = {"place", ArrayKind::Values, "Hz", "rates of places", "", {}};
  large.shape = {2, 6};
  for (auto& values : large.activity) values.assign(12, 1);
  large.activity[3][5] = NAN;
  const std::string heat_map = arrayFigure({large});
  CHECK(heat_map.find("place (2 x 6, Hz): rates of places") != std::string::npos);
  CHECK(test::countOf(heat_map, "<image") == 1);
  CHECK(heat_map.find("nan") == std::string::npos);
}

TEST_CASE("of very many arrays only as many are drawn as a picture can hold") {
  const RecordedRun sample;
  const std::vector<evaluation::PopulationHistory> many(256, sample.data.cells.others[0]);
  CHECK(pngOf(arrayFigure(many)).isOk());
}

TEST_CASE("rates of two opposite head direction units and one grid unit") {
  const RecordedRun sample;
  const std::string svg = firingFigure(drawnUnits(sample.data, {}).value());
  CHECK(svg.find("head direction unit 1 of 4") != std::string::npos);
  CHECK(svg.find("head direction unit 3 of 4") != std::string::npos);
  CHECK(svg.find("1 field, 0.00 bits, too narrow an area for grid scores") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("all units: a dial for each of every ring, a picture for every module") {
  const RunData run = test::readWalk({});
  const std::string svg = unitsFigure(run);
  CHECK(test::countOf(svg, "<polyline") == 24);
  CHECK(test::countOf(svg, "<image") == 2);
  CHECK(svg.find("hd.activity: 24 head direction units") != std::string::npos);
  CHECK(svg.find("grid0.activity: 144 grid units, period 20 m") != std::string::npos);
  CHECK(svg.find("grid1.activity: 144 grid units, period 28.4 m") != std::string::npos);
  CHECK(std::regex_search(svg, std::regex("[1-9]0? m; each map 6")));
  const auto chance = run.metrics.cells->sheets[1].scores.of("grid_score_square")->chance;
  CHECK(svg.find(fmt::format("chance {:.2f}", chance)) != std::string::npos);
}

TEST_CASE("grid unit and chance are those of the metrics") {
  const RunData run = test::readWalk({});
  const std::string svg = firingFigure(drawnUnits(run, {0, 2, 3}).value());
  const auto& sheet = run.metrics.cells->sheets[0].scores;
  const auto& unit = sheet.units[2 * 12 + 3].scores[sheet.indexOf("grid_score_square")];
  CHECK(svg.find(fmt::format("square grid score {:.2f} (chance {:.2f})", unit.value(),
                             sheet.of("grid_score_square")->chance)) != std::string::npos);
}

TEST_CASE("times of stages are those recorded") {
  const RecordedRun sample;
  CHECK(timingFigure(sample.data.metrics).find(">2 / 2<") != std::string::npos);
}

TEST_CASE("a run that has nothing of a kind has no figure of it") {
  CHECK(errorFigure({}).empty());
  CHECK(elevationFigure({}).empty());
  CHECK(templateFigure({}).empty());
  CHECK(activityFigure({}, {}).empty());
  CHECK(arrayFigure({}).empty());
  CHECK(firingFigure({}).empty());
  CHECK(unitsFigure({}).empty());
  CHECK(timingFigure({}).empty());
}
