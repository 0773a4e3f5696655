// SPDX-License-Identifier: BSD-3-Clause
// The figures show the numbers of the record.
#include "report/figures.hpp"

#include <cmath>
#include <regex>

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

int count(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("errors are those of the aligned frames") {
  const RecordedRun sample;
  REQUIRE(sample.data.map_error.metres.size() == 12);
  CHECK(sample.data.map_error.seconds.back() == Approx(1.1));
  // Six frames are 1 cm off: the alignment shares it out.
  for (const double metres : sample.data.map_error.metres)
    CHECK(metres == Approx(0.005).margin(5e-4));
  const std::string svg = errorFigure(sample.data);
  CHECK(count(svg, "<polyline") == 2);
  CHECK(svg.find("map, rmse 0.005 m") != std::string::npos);
}

TEST_CASE("each view is a dot, novel and familiar ones in their own colour") {
  const RecordedRun sample;
  const auto places = sample.reader->records<PlaceObservation>().value();
  const std::string svg = templateFigure(places);
  CHECK(count(svg, "fill=\"" + std::string(kBlue) + "\"") == 6);
  CHECK(count(svg, "fill=\"" + std::string(kVermilion) + "\"") == 6);
}

TEST_CASE("the activity of every unit is drawn at four moments") {
  const RecordedRun sample;
  const CellHistory cells =
      readCells(*sample.reader, sample.reader->records<Decision>().value()).value();
  REQUIRE(cells.ring.frames.size() == 12);
  REQUIRE(cells.sheet.shape == std::vector<int>{2, 2});
  const std::string svg = activityFigure(cells, sample.reader->records<Decision>().value());
  CHECK(count(svg, "stroke-width=\"6\"") == 4 * 4);
  CHECK(count(svg, "<rect x") == 4 * 4 + 24);  // and the colour bar
  CHECK(svg.find("frame 11, heading 0.0 deg") != std::string::npos);
}

TEST_CASE("records without descriptions keep the convention of their names") {
  const test::TemporaryFolder folder;
  auto recorder = record::Recorder::open(folder.path()).value();
  REQUIRE(test::recordFrame(*recorder, 0).isOk());
  REQUIRE(recorder->close().isOk());
  Decision decision;
  decision.frame = 0;
  const auto reader = record::RunReader::open(folder.path()).value();
  const CellHistory cells = readCells(*reader, {decision}).value();
  REQUIRE(cells.ring.info.axes.size() == 1);
  CHECK(axisAngle(cells.ring.info.axes[0], 1) == Approx(2 * M_PI / 3));
  CHECK(cells.sheet.empty());
  CHECK(cells.others.empty());
}

TEST_CASE("arrays that no figure knows are drawn as they are, and one by one") {
  const RecordedRun sample;
  const CellHistory cells =
      readCells(*sample.reader, sample.reader->records<Decision>().value()).value();
  REQUIRE(cells.others.size() == 1);
  const std::string svg = arrayFigure(cells.others);
  CHECK(svg.find("noise (2)") != std::string::npos);
  CHECK(count(svg, "<polyline") == 2);
  PopulationHistory large = cells.others[0];
  large.info = {"place", ArrayKind::Values, "Hz", "rates of places", "", {}};
  large.shape = {2, 6};
  for (auto& values : large.activity) values.assign(12, 1);
  large.activity[3][5] = NAN;
  const std::string heat_map = arrayFigure({large});
  CHECK(heat_map.find("place (2 x 6, Hz): rates of places") != std::string::npos);
  CHECK(count(heat_map, "<rect x") > 12 * 12 - 1);
  CHECK(heat_map.find("nan") == std::string::npos);
}

TEST_CASE("rates of two opposite head direction units and one grid unit") {
  const RecordedRun sample;
  const CellHistory cells =
      readCells(*sample.reader, sample.reader->records<Decision>().value()).value();
  const std::string svg = firingFigure(measureNeurons(cells, sample.data.map),
                                       drawnUnits(cells, sample.data.map, {}).value());
  CHECK(svg.find("head direction unit 1 of 4") != std::string::npos);
  CHECK(svg.find("head direction unit 3 of 4") != std::string::npos);
  CHECK(svg.find("grid unit (1, 1), phase (0, 0) m: 1 field, 0.00 bits") != std::string::npos);
  CHECK(svg.find("the path is too narrow to measure a square lattice") != std::string::npos);
  CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("times of stages are those recorded") {
  const RecordedRun sample;
  CHECK(timingFigure(sample.data.metrics).find(">2 / 2<") != std::string::npos);
}

TEST_CASE("a run that has nothing of a kind has no figure of it") {
  CHECK(errorFigure({}).empty());
  CHECK(templateFigure({}).empty());
  CHECK(activityFigure({}, {}).empty());
  CHECK(arrayFigure({}).empty());
  CHECK(firingFigure({}, {}).empty());
  CHECK(timingFigure({}).empty());
}
