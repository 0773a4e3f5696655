// SPDX-License-Identifier: BSD-3-Clause
// Decoding of populations whose state is known: von Mises rings, Gaussian bumps on tori.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "evaluation/recorded_cells.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr double kTurn = 2 * std::numbers::pi;

ArrayInfo sheetOf(double period, int units, const char* row = "y", const char* column = "x",
                  const char* unit = "m") {
  const ArrayAxis axis{"", unit, 0, period / units, period, {}};
  ArrayInfo info{"grid.activity", ArrayKind::Activity, "", "", "", {axis, axis}};
  info.axes[0].name = row;
  info.axes[1].name = column;
  return info;
}

std::vector<float> bump(const ArrayInfo& sheet, double row, double column) {
  const double period = sheet.axes[0].period;
  const int units = static_cast<int>(std::lround(period / sheet.axes[0].step));
  const auto rate = [&](double at, int unit) {
    const double off = std::remainder(at - unit * period / units, period) / (0.11 * period);
    return std::exp(-0.5 * off * off);
  };
  std::vector<float> rates;
  for (int r = 0; r < units; ++r) {
    for (int c = 0; c < units; ++c)
      rates.push_back(static_cast<float>(rate(row, r) * rate(column, c)));
  }
  return rates;
}

std::vector<ModulePhase> phasesAt(const Eigen::Vector2d& place,
                                  const std::vector<double>& periods) {
  std::vector<ModulePhase> modules;
  for (const double period : periods) {
    const ArrayInfo sheet = sheetOf(period, 20);
    modules.push_back(*modulePhase(bump(sheet, place.y(), place.x()), sheet));
  }
  return modules;
}

}  // namespace

TEST_CASE("the population vector of a von Mises ring is its centre, in the unit of the axis") {
  for (const double centre : {0.0, 1.234, 3.1, 6.2}) {
    std::vector<double> rates;
    for (int i = 0; i < 36; ++i) rates.push_back(std::exp(2.4 * std::cos(centre - i * kTurn / 36)));
    const ArrayAxis radians{"heading", "rad", 0, kTurn / 36, kTurn, {}};
    CHECK(populationVector(rates, radians) == Approx(centre).margin(1e-9));
    const ArrayAxis degrees{"heading", "deg", 90, 10, 360, {}};  // unit 0 stands for 90 degrees
    CHECK(std::remainder(*populationVector(rates, degrees) - centre * 360 / kTurn - 90, 360) ==
          Approx(0).margin(1e-7));
  }
}

TEST_CASE("a ring without activity, or with equal activity everywhere, has no direction") {
  const ArrayAxis axis{"heading", "rad", 0, kTurn / 12, kTurn, {}};
  CHECK_FALSE(populationVector(std::vector<double>(12, 0), axis));
  CHECK_FALSE(populationVector(std::vector<double>(12, 3.7), axis));
}

TEST_CASE("a sheet gives x and y, whichever axis is first") {
  const ArrayInfo rows_first = sheetOf(30, 20);
  const auto phase = modulePhase(bump(rows_first, 7, 22.5), rows_first);
  REQUIRE(phase);
  CHECK(phase->phase.x() == Approx(22.5).margin(1e-3));
  CHECK(phase->phase.y() == Approx(7).margin(1e-3));
  CHECK(phase->period == 30);
  const ArrayInfo columns_first = sheetOf(30, 20, "x", "y");
  CHECK(modulePhase(bump(columns_first, 7, 22.5), columns_first)->phase.x() ==
        Approx(7).margin(1e-3));
  CHECK_FALSE(modulePhase(std::vector<float>(400, 1), rows_first));
  CHECK_FALSE(modulePhase(std::vector<float>(7, 1), rows_first));
}

TEST_CASE("a sheet without a position has a reason") {
  CHECK(noPositionReason(sheetOf(30, 20)).empty());
  CHECK(noPositionReason(sheetOf(30, 20, "y", "x", "cells")) ==
        "the axes of grid.activity are in cells, not in m");
  CHECK(noPositionReason(sheetOf(30, 20, "row", "column")) ==
        "an axis of grid.activity is not x or y");
}

TEST_CASE("several modules decode positions far beyond the largest period") {
  const std::vector<double> periods = {30, 42.6, 60.5};
  const Eigen::Vector2d start(3, -4);
  const PositionDecoder decoder(phasesAt({8, 2}, periods), start, {-300, -300}, {300, 300});
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(3, -4), {150, 20}, {-211, 280}, {299, -299}}) {
    // The code's own origin is (5, 6) away from that of the places.
    const auto phases = phasesAt(place + Eigen::Vector2d(5, 6), periods);
    CHECK((decoder.decode(phases) - place).norm() < 0.01);
    CHECK(decoder.error(phases, place + Eigen::Vector2d(3, 4)) == Approx(5).margin(0.01));
  }
}

TEST_CASE("one module decodes positions modulo its period") {
  const PositionDecoder decoder(phasesAt({0, 0}, {60}), {0, 0}, {-300, -300}, {300, 300});
  CHECK(decoder.error(phasesAt({130, -7}, {60}), {10, -7}) < 0.01);
  CHECK(decoder.error(phasesAt({130, -7}, {60}), {130, 13}) == Approx(20).margin(0.01));
}
