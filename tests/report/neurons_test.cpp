// SPDX-License-Identifier: BSD-3-Clause
// A walk over a town of square blocks with units whose firing is known.
#include "report/neurons.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "report/drawn_units.hpp"
#include "report/sample_pages.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::report;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kSide = 100;  // m
constexpr double kSpacing = 25;

/// Lanes to and fro over a square, 4 m apart: all headings of two streets.
evaluation::Trajectory lanes() {
  evaluation::Trajectory way;
  const auto add = [&way](double x, double z, double theta) {
    way.push_back({static_cast<std::int64_t>(way.size()), 0, fromPlanar({z, -x, theta})});
  };
  for (int lane = 0; lane <= kSide; lane += 8) {
    for (int step = 0; step < kSide; ++step) add(lane, step, 0);
    for (int step = kSide; step > 0; --step) add(lane + 4, step, std::numbers::pi);
  }
  return way;
}

/// Of the four units of the sheet three fire on a square lattice, each with its own phase; the last
/// fires as it likes. Unit i of the ring fires towards i * 90 deg.
struct Town {
  evaluation::Trajectory way = lanes();
  CellHistory cells{
      {test::ringInfo(4), {4}, {}, {}}, {test::sheetInfo(2, kSpacing), {2, 2}, {}, {}}, {}};

  Town() {
    for (const auto& pose : way) {
      const PlanarPose at = toPlanar(pose.T_world_camera);
      std::vector<float> ring;
      for (int i = 0; i < 4; ++i) {
        ring.push_back(static_cast<float>(std::exp(4 * std::cos(at.theta - i * kTurn / 4) - 4)));
      }
      std::vector<float> sheet;
      for (int i = 0; i < 3; ++i) {
        const double x = std::cos(kTurn * (at.x / kSpacing - i / 3.0));
        const double y = std::cos(kTurn * at.y / kSpacing);
        sheet.push_back(static_cast<float>(std::exp(3 * (x + y - 2))));
      }
      const double noise = std::sin(12.9898 * static_cast<double>(pose.frame)) * 43758.5453;
      sheet.push_back(static_cast<float>(noise - std::floor(noise)));
      cells.ring.frames.push_back(pose.frame);
      cells.ring.activity.push_back(ring);
      cells.sheet.frames.push_back(pose.frame);
      cells.sheet.activity.push_back(sheet);
    }
  }
};

}  // namespace

TEST_CASE("each unit of the ring has its tuning, each of the sheet its lattice") {
  const Town town;
  const Neurons neurons = measureNeurons(town.cells, town.way);
  REQUIRE(neurons.ring.size() == 4);
  CHECK(neurons.ring[0].tuning.mean_vector_length > 0.95);
  CHECK(std::remainder(neurons.ring[2].tuning.preferred - kTurn / 2, kTurn) ==
        Approx(0).margin(0.1));
  REQUIRE(neurons.sheet.size() == 4);
  for (std::size_t i = 0; i < 3; ++i) {
    REQUIRE(neurons.sheet[i].periodicity);
    CHECK(neurons.sheet[i].periodicity->spacing == Approx(kSpacing).epsilon(0.03));
    CHECK(neurons.sheet[i].fields >= 9);
    CHECK(neurons.sheet[i].bits > 0.5);
  }
}

TEST_CASE("a lattice is above chance, noise is not") {
  const Town town;
  const Neurons neurons = measureNeurons(town.cells, town.way);
  REQUIRE(neurons.chance);
  CHECK(neurons.sheet[0].periodicity->score > *neurons.chance);
  CHECK(neurons.sheet[3].periodicity->score < *neurons.chance);
  CHECK(neurons.periodicShare() == 0.75);
}

TEST_CASE("the same walk gives the same chance: no random stream is in it") {
  const Town town;
  CHECK(measureNeurons(town.cells, town.way).chance == measureNeurons(town.cells, town.way).chance);
}

TEST_CASE("a straight street tells nothing of a lattice") {
  Town town;
  town.way.resize(kSide);
  const Neurons neurons = measureNeurons(town.cells, town.way);
  CHECK_FALSE(neurons.chance);
  CHECK_FALSE(neurons.sheet[0].periodicity);
  CHECK(neurons.periodicShare() == 0);
  CHECK(toJson(neurons)["grid_chance"].is_null());
}

TEST_CASE("in the file units count from one and angles are degrees") {
  const Town town;
  const auto json = toJson(measureNeurons(town.cells, town.way));
  REQUIRE(json["head_direction"].size() == 4);
  CHECK(json["head_direction"][3]["unit"] == 4);
  CHECK(json["head_direction"][3]["nominal_deg"] == 270);
  CHECK(json["head_direction"][3]["tuning"].size() == 36);
  CHECK(json["head_direction"][2]["preferred_deg"].get<double>() == Approx(180).margin(6));
  CHECK(json["grid"][2]["unit"] == nlohmann::json({2, 1}));
  CHECK(json["grid"][2]["nominal"] == nlohmann::json({12.5, 0.0}));
  CHECK(json["grid"][2]["periodicity"]["spacing_m"].get<double>() ==
        Approx(kSpacing).epsilon(0.03));
  CHECK(toJson(Neurons{}).is_null());
}

TEST_CASE("a rate map has null where nobody was") {
  const RateMap map = rateMap({{{0, 0}, 0, 2}, {{10, 0}, 0, 4}}, 10);
  const auto json = toJson(map);
  CHECK(json["rate"].size() == 11);
  CHECK(json["rate"][0][0] == 2);
  CHECK(json["rate"][5][0].is_null());
  CHECK(json["rate"][10][0] == 4);
  CHECK(json["bin_m"] == 1);
}

TEST_CASE("frames without a pose, or with one that has run away, are not walked") {
  Town town;
  town.way.erase(town.way.begin());
  town.way[5].T_world_camera.translation().x() = 1e12;
  const ActivityPath walk(town.cells.ring, town.way);
  CHECK(walk.samples(0).size() == town.cells.ring.frames.size() - 2);
  CHECK(walk.samples(99).empty());
}

TEST_CASE("a shift takes later rates to the same places") {
  const Town town;
  const ActivityPath walk(town.cells.sheet, town.way);
  const auto now = walk.samples(0);
  const auto shifted = walk.samples(0, 0.25);
  const std::size_t later = now.size() / 4;
  CHECK(shifted[3].position == now[3].position);
  CHECK(shifted[3].rate == now[3 + later].rate);
  CHECK(shifted.back().rate == now[later - 1].rate);
}

TEST_CASE("a chosen unit is drawn, of the ring with its opposite") {
  const Town town;
  const auto units = drawnUnits(town.cells, town.way, {3, 1, 0});
  REQUIRE(units.isOk());
  REQUIRE(units.value().size() == 3);
  CHECK(units.value()[0].name == "head direction unit 4 of 4, 270 deg");
  CHECK(units.value()[1].name == "head direction unit 2 of 4, 90 deg");
  CHECK(units.value()[2].name == "grid unit (2, 1)");
  CHECK(units.value()[2].phase == "(12.5, 0) m");
  CHECK(units.value()[2].unit == 2);
}

TEST_CASE("a unit that the run does not have is refused") {
  const Town town;
  CHECK(drawnUnits(town.cells, town.way, {4, 0, 0}).status().message() ==
        "there is no head direction unit 5: this run has 4");
  CHECK(drawnUnits(town.cells, town.way, {0, 0, 2}).status().message() ==
        "there is no grid unit 1,3: this run has 2 by 2");
  CHECK(drawnUnits({}, town.way, {0, 1, 0}).status().code() == StatusCode::InvalidParameter);
  CHECK(drawnUnits({}, town.way, {}).value().empty());
}
