// SPDX-License-Identifier: BSD-3-Clause
#include "activity.hpp"

#include <cmath>
#include <string>

namespace tolman::bayesian_attractor {
namespace {

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

void appendArrays(const SpatialCells& cells, const Readout& readout,
                  std::vector<NamedArray>& arrays) {
  const HeadDirectionRing& ring = cells.ring();
  arrays.push_back({"hd.activity",
                    {readout.ring_units},
                    ringActivity(ring.estimated(), ring.period(), readout.ring_units)});
  appendBumps<1>("hd", ring, arrays);
  const auto append = [&](const std::string& name, const GridTorus& module) {
    arrays.push_back({name + ".activity",
                      {readout.sheet_units, readout.sheet_units},
                      torusActivity(module.estimated(), module.period(), readout.sheet_units,
                                    readout.field_width)});
    appendBumps<2>(name, module, arrays);
  };
  append("grid", cells.torus());
  for (std::size_t i = 0; i < cells.further().size(); ++i) {
    append("grid" + std::to_string(i + 2), cells.further()[i]);
  }
}

}  // namespace tolman::bayesian_attractor
