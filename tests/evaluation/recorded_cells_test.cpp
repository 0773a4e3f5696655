// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/recorded_cells.hpp"

#include <catch2/catch.hpp>
#include <numbers>

using namespace tolman;
using namespace tolman::evaluation;

namespace {

ArrayInfo described(const char* name, std::vector<ArrayAxis> axes) {
  return {name, ArrayKind::Activity, "", "", "", std::move(axes)};
}

const ArrayAxis kHeading{"heading", "deg", 0, 90, 360, {}};
const ArrayAxis kX{"x", "m", 0, 10, 40, {}};

NamedArray arrayOf(const char* name, std::vector<int> shape, std::size_t size, double value = 0) {
  return {name, std::move(shape), std::vector<float>(size, static_cast<float>(value))};
}

Trajectory walkOf(std::int64_t frames) {
  Trajectory walk;
  for (std::int64_t i = 0; i < frames; ++i) {
    walk.push_back({i, i * 1'000'000'000, fromPlanar({static_cast<double>(i), 0, 0})});
  }
  return walk;
}

}  // namespace

TEST_CASE("angles make a ring, two periodic axes a module; what never came is dropped") {
  ArrayAxis open = kX;
  open.period = 0;
  ArrayInfo values = described("values", {kHeading});
  values.kind = ArrayKind::Values;
  CellHistory cells({described("ring", {kHeading}), described("line", {kX}),
                     described("sheet", {kX, kX}), described("open", {kX, open}),
                     described("absent", {kX, kX}), values});
  for (const char* name : {"ring", "line", "values"}) cells.add(0, arrayOf(name, {4}, 4));
  for (const char* name : {"sheet", "open"}) cells.add(0, arrayOf(name, {4, 4}, 16));
  cells.add(0, arrayOf("undescribed.activity", {4}, 4));
  cells.dropEmpty();
  REQUIRE(cells.rings.size() == 1);
  CHECK(cells.rings[0].info.name == "ring");
  REQUIRE(cells.sheets.size() == 1);
  CHECK(cells.sheets[0].info.name == "sheet");
}

TEST_CASE("an array of another shape than described is left out") {
  CellHistory cells({described("ring", {kHeading})});
  cells.add(0, arrayOf("ring", {5}, 5));
  CHECK(cells.rings[0].frames.empty());
  cells.add(1, arrayOf("ring", {4}, 4));
  CHECK(cells.rings[0].frames == std::vector<std::int64_t>{1});
}

TEST_CASE("long runs are kept at evenly spaced frames") {
  CellHistory cells({described("ring", {kHeading})});
  constexpr std::int64_t kFrames = 12000;
  for (std::int64_t i = 0; i < kFrames; ++i) {
    cells.add(i, arrayOf("ring", {4}, 4, static_cast<double>(i)));
  }
  const PopulationHistory& ring = cells.rings[0];
  CHECK((ring.frames.size() >= 2500 && ring.frames.size() <= 5000));
  const std::int64_t stride = ring.frames[1];
  for (std::size_t i = 0; i < ring.frames.size(); ++i) {
    REQUIRE(ring.frames[i] == static_cast<std::int64_t>(i) * stride);
    REQUIRE(ring.activity[i][0] == static_cast<float>(ring.frames[i]));
  }
  CHECK(ring.frames.back() > kFrames - 1 - stride);
}

TEST_CASE("units have the places of their frames; those without a pose, or lost, are left out") {
  CellHistory cells({described("ring", {kHeading})});
  for (std::int64_t i = 0; i < 10; ++i) {
    cells.add(i, {"ring", {4}, {0, 1, 2, static_cast<float>(i)}});
  }
  Trajectory walk = walkOf(9);
  walk[4].T_world_camera.translation().x() = 1e12;
  const RecordedUnits units = unitsAt(cells.rings[0], stampedPosesOf(walk), {3, 1}, true);
  REQUIRE(units.walk.size() == 8);
  CHECK(units.walk[4].position.isApprox(Eigen::Vector2d(0, 5)));
  CHECK(units.rates[0][4] == 5);
  CHECK(units.rates[1][4] == 1);
  CHECK(units.seconds == Approx(8));
}

TEST_CASE("of large populations units are measured evenly") {
  PopulationHistory sheet;
  sheet.shape = {3, 4};
  CHECK(measuredUnits(sheet).size() == 12);
  sheet.shape = {100, 64};
  const auto units = measuredUnits(sheet);
  REQUIRE(units.size() == 32 * 32);
  CHECK(units[1] - units[0] == 2);
  CHECK(units.back() < 6400);
  sheet.shape = {360};
  CHECK(measuredUnits(sheet).size() == 72);
}

TEST_CASE("an index of a periodic axis stands for a value within the period") {
  const ArrayAxis axis{"heading", "deg", 270, 90, 360, {}};
  CHECK(axisValue(axis, 1) == 0);
  CHECK(axisAngle(axis, 2) == Approx(std::numbers::pi / 2));
}
