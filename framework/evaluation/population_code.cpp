// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/population_code.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <cstddef>

#include "evaluation/firing_rate.hpp"
#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

/// A population vector shorter than this share of all activity is a rounding error.
constexpr double kMinLength = 1e-6;

/// Position along one axis modulo a period.
struct Residue {
  double value = 0;
  double period = 1;
};

/// A place, and the sum of its squared distances to all residues, weighted by their precision
/// (1 / period^2).
struct Fit {
  double place = 0;
  double misfit = 0;
};

/// The best fit near `place`.
Fit fitNear(double place, const std::vector<Residue>& modules) {
  double sum = 0;
  double weights = 0;
  double squares = 0;
  for (const Residue& module : modules) {
    const double off = std::remainder(module.value - place, module.period);
    const double weight = 1 / (module.period * module.period);
    sum += weight * off;
    squares += weight * off * off;
    weights += weight;
  }
  const double shift = sum / weights;
  return {place + shift, squares - shift * sum};
}

/// The place from `low` to `high` that fits all residues best; the lowest of equal ones.
double bestPlace(const std::vector<Residue>& modules, double low, double high) {
  const Residue& coarse = *std::ranges::max_element(modules, {}, &Residue::period);
  const double first = low + wrapPeriod(coarse.value - low, coarse.period);
  Fit best = fitNear(first, modules);
  for (double place = first + coarse.period; place <= high; place += coarse.period) {
    const Fit fit = fitNear(place, modules);
    if (fit.misfit < best.misfit - 1e-12) best = fit;
  }
  return best.place;
}

}  // namespace

std::size_t unitsAlong(const ArrayAxis& axis) {
  return axis.step > 0 ? static_cast<std::size_t>(std::lround(axis.period / axis.step)) : 0;
}

std::optional<double> populationVector(std::span<const double> rates, const ArrayAxis& axis) {
  std::complex<double> sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    const double value = axis.first + axis.step * static_cast<double>(i);
    sum += std::polar(1.0, kRadiansOfTurn * value / axis.period) * rates[i];
    total += std::abs(rates[i]);
  }
  if (!(std::abs(sum) > kMinLength * total)) return std::nullopt;
  return wrapPeriod(std::arg(sum) / kRadiansOfTurn * axis.period, axis.period);
}

std::string noPositionReason(const ArrayInfo& sheet) {
  if (sheet.axes.size() != 2) return sheet.name + " has not two axes";
  for (const ArrayAxis& axis : sheet.axes) {
    if (axis.name != "x" && axis.name != "y") return "an axis of " + sheet.name + " is not x or y";
    if (axis.unit != "m") {
      return "the axes of " + sheet.name + " are in " +
             (axis.unit.empty() ? "no unit" : axis.unit) + ", not in m";
    }
  }
  const bool square = sheet.axes[0].period == sheet.axes[1].period;
  return square ? "" : "the axes of " + sheet.name + " differ in period";
}

std::optional<ModulePhase> modulePhase(std::span<const float> rates, const ArrayInfo& sheet) {
  const ArrayAxis& rows = sheet.axes[0];
  const ArrayAxis& columns = sheet.axes[1];
  const std::size_t width = unitsAlong(columns);
  if (rates.size() != unitsAlong(rows) * width) return std::nullopt;
  std::vector<double> by_row(unitsAlong(rows), 0);
  std::vector<double> by_column(width, 0);
  for (std::size_t i = 0; i < rates.size(); ++i) {
    by_row[i / width] += static_cast<double>(rates[i]);
    by_column[i % width] += static_cast<double>(rates[i]);
  }
  const auto row = populationVector(by_row, rows);
  const auto column = populationVector(by_column, columns);
  if (!row || !column) return std::nullopt;
  if (rows.name == "x") return ModulePhase{{*row, *column}, rows.period};
  return ModulePhase{{*column, *row}, rows.period};
}

PositionDecoder::PositionDecoder(const std::vector<ModulePhase>& modules,
                                 const Eigen::Vector2d& position, const Eigen::Vector2d& low,
                                 const Eigen::Vector2d& high)
    : origin_(modules), low_(low), high_(high) {
  for (ModulePhase& module : origin_) module.phase -= position;
}

Eigen::Vector2d PositionDecoder::decode(const std::vector<ModulePhase>& modules) const {
  Eigen::Vector2d place;
  for (Eigen::Index axis = 0; axis < 2; ++axis) {
    std::vector<Residue> residues;
    for (std::size_t i = 0; i < modules.size(); ++i) {
      residues.push_back({modules[i].phase(axis) - origin_[i].phase(axis), modules[i].period});
    }
    place(axis) = bestPlace(residues, low_(axis), high_(axis));
  }
  return place;
}

double PositionDecoder::error(const std::vector<ModulePhase>& modules,
                              const Eigen::Vector2d& position) const {
  const Eigen::Vector2d off = decode(modules) - position;
  if (modules.size() > 1) return off.norm();
  return std::hypot(std::remainder(off.x(), modules[0].period),
                    std::remainder(off.y(), modules[0].period));
}

}  // namespace tolman::evaluation
