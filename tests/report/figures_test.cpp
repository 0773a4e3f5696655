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

TEST_CASE("each view is a dot, novel and familiar ones in their own colour") {
  const RecordedRun sample;
  const auto places = sample.reader->records<PlaceObservation>().value();
  const std::string svg = templateFigure(places);
  CHECK(test::countOf(svg, "fill=\"" + std::string(kBlue) + "\"") == 6);
  CHECK(test::countOf(svg, "fill=\"" + std::string(kVermilion) + "\"") == 6);
}

TEST_CASE("rates of two opposite head direction units and one grid unit") {
  const RecordedRun sample;
  const std::string svg = firingFigure(drawnUnits(sample.data));
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
  const std::string svg = firingFigure(drawnUnits(run));
  const auto& sheet = run.metrics.cells->sheets[0].scores;
  const auto& unit = sheet.units[0].scores[sheet.indexOf("grid_score_square")];
  CHECK(svg.find(fmt::format("square grid score {:.2f} (chance {:.2f})", unit.value(),
                             sheet.of("grid_score_square")->chance)) != std::string::npos);
}

TEST_CASE("times of stages are those recorded") {
  const RecordedRun sample;
  CHECK(timingFigure(sample.data.metrics).find(">2 / 2<") != std::string::npos);
}

TEST_CASE("a run that has nothing of a kind has no figure of it") {
  CHECK(errorFigure({}).empty());
  CHECK(templateFigure({}).empty());
  CHECK(firingFigure({}).empty());
  CHECK(unitsFigure({}).empty());
  CHECK(timingFigure({}).empty());
}
