// SPDX-License-Identifier: BSD-3-Clause
#include "activity.hpp"

#include <cmath>
#include <string>

namespace tolman::paper_attractor {
namespace {

/// Units of the ring, as drawn in the paper, and along each side of the sheet (chosen, not tuned).
/// Only recorded rates depend on them.
constexpr int kRingUnits = 36;
constexpr int kSheetUnits = 30;
/// Standard deviation of a grid field in periods, as in the rat (Hafting et al. 2005).
constexpr double kFieldWidth = 0.11;

/// Equation (1) along one axis at evenly spaced units, with its peak at 1.
std::vector<float> axisActivity(double mean, double precision, double period, int units) {
  std::vector<float> rates;
  for (int unit = 0; unit < units; ++unit) {
    const Phase<1> preferred(unit * period / units);
    const double off = distance<1>(preferred, Phase<1>(mean), period);
    rates.push_back(static_cast<float>(std::exp(-0.5 * precision * off * off)));
  }
  return rates;
}

template <int Axes>
NamedArray bumpArray(std::string name, const PeriodicBump<Axes>& bump) {
  NamedArray array{std::move(name), {Axes + 1}, {}};
  for (int axis = 0; axis < Axes; ++axis) {
    array.values.push_back(static_cast<float>(bump.mean(axis)));
  }
  array.values.push_back(static_cast<float>(bump.precision));
  return array;
}

template <int Axes>
void appendBumps(const std::string& prefix, const AttractorNetwork<Axes>& network,
                 std::vector<NamedArray>& arrays) {
  arrays.push_back(bumpArray<Axes>(prefix + ".integrator", network.integrator()));
  arrays.push_back(bumpArray<Axes>(prefix + ".calibration", network.calibration()));
  arrays.push_back(bumpArray<Axes>(prefix + ".estimate", network.estimated()));
  arrays.push_back(bumpArray<Axes>(prefix + ".injected", network.injected()));
}

ArrayInfo activityInfo(std::string name, std::vector<ArrayAxis> axes) {
  return {std::move(name), ArrayKind::Activity, "", "rates of the units, 1 at the most", "",
          std::move(axes)};
}

void describeBumps(const std::string& prefix, const std::vector<std::string>& components,
                   std::vector<ArrayInfo>& arrays) {
  for (const char* bump : {"integrator", "calibration", "estimate", "injected"}) {
    arrays.push_back({prefix + "." + bump,
                      ArrayKind::Bump,
                      "",
                      "mean and precision of a bump",
                      prefix + ".activity",
                      {{"component", "", 0, 1, 0, components}}});
  }
}

}  // namespace

std::vector<float> ringActivity(const PeriodicBump<1>& bump, double period, int units) {
  return axisActivity(bump.mean(0), bump.precision, period, units);
}

std::vector<float> torusActivity(const PeriodicBump<2>& bump, double period, int units,
                                 double width) {
  const double variance = width * width * period * period;
  const double precision = bump.precision / (1 + bump.precision * variance);
  // Equation (7) is a product of its axes.
  const std::vector<float> columns = axisActivity(bump.mean.x(), precision, period, units);
  const std::vector<float> rows = axisActivity(bump.mean.y(), precision, period, units);
  std::vector<float> rates;
  rates.reserve(columns.size() * rows.size());
  for (const float row : rows) {
    for (const float column : columns) rates.push_back(row * column);
  }
  return rates;
}

void appendArrays(const SpatialCells& cells, std::vector<NamedArray>& arrays) {
  const HeadDirectionRing& ring = cells.ring();
  arrays.push_back(
      {"hd.activity", {kRingUnits}, ringActivity(ring.estimated(), ring.period(), kRingUnits)});
  appendBumps<1>("hd", ring, arrays);
  const GridTorus& torus = cells.torus();
  arrays.push_back({"grid.activity",
                    {kSheetUnits, kSheetUnits},
                    torusActivity(torus.estimated(), torus.period(), kSheetUnits, kFieldWidth)});
  appendBumps<2>("grid", torus, arrays);
}

void describeArrays(const SpatialCells& cells, std::vector<ArrayInfo>& arrays) {
  const double turn = cells.ring().period();
  const double period = cells.torus().period();
  const auto axis = [&](const char* name) {
    return ArrayAxis{name, "cells", 0, period / kSheetUnits, period, {}};
  };
  arrays.push_back(
      activityInfo("hd.activity", {{"heading", "rad", 0, turn / kRingUnits, turn, {}}}));
  describeBumps("hd", {"heading", "precision"}, arrays);
  arrays.push_back(activityInfo("grid.activity", {axis("y"), axis("x")}));
  describeBumps("grid", {"x", "y", "precision"}, arrays);
}

}  // namespace tolman::paper_attractor
