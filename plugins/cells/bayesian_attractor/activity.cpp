// SPDX-License-Identifier: BSD-3-Clause
#include "activity.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace tolman::bayesian_attractor {
namespace {

/// Units of the ring, as drawn in arXiv:2003.03091, and along each side of a module's sheet.
constexpr int kRingUnits = 36;
constexpr int kSheetUnits = 30;  // chosen, not tuned; only recorded rates depend on it
/// Concentration of the von Mises tuning curve of a head direction unit, log 2 / (1 - cos 45
/// degrees): in the rat it fires above half its peak within 45 degrees of its preferred direction
/// (Taube, Muller, Ranck 1990).
constexpr double kRingTuning = 2.3665;
/// Standard deviation of a grid field, in periods. In the rat a field is half as wide as its
/// distance to the next one (Hafting et al. 2005).
constexpr double kFieldWidth = 0.11;
/// Bumps with a smaller share of the energy add nothing to the rates; bounds the time.
constexpr double kMinShare = 1e-3;

struct WeightedBump {
  const Bump* bump;
  double share;
};

/// The integrator, whose energy is 0, and the hypotheses.
std::vector<WeightedBump> weightedBumps(const BumpNetwork& network) {
  const NetworkState& state = network.state();
  std::vector<WeightedBump> bumps = {{&state.integrator, network.share(0)}};
  for (const CalibrationBump& c : state.calibration) {
    bumps.push_back({&c.bump, network.share(c.energy)});
  }
  return bumps;
}

NamedArray ringActivity(const std::vector<WeightedBump>& bumps) {
  NamedArray array{"hd.activity", {kRingUnits}, std::vector<float>(kRingUnits)};
  for (const auto& [bump, share] : bumps) {
    if (share < kMinShare) continue;
    const double concentration = 1 / (1 / kRingTuning + bump->covariance(2, 2));
    for (int unit = 0; unit < kRingUnits; ++unit) {
      const double off = bump->centre.heading - unit * kTurn / kRingUnits;
      array.values[static_cast<std::size_t>(unit)] +=
          static_cast<float>(share * std::exp(concentration * (std::cos(off) - 1)));
    }
  }
  return array;
}

/// Rates along one axis of a module.
std::vector<double> axisActivity(double phase, double variance, double period) {
  const double width = kFieldWidth * period;
  std::vector<double> rates;
  for (int unit = 0; unit < kSheetUnits; ++unit) {
    const double off = std::remainder(phase - unit * period / kSheetUnits, period);
    rates.push_back(std::exp(-0.5 * off * off / (width * width + variance)));
  }
  return rates;
}

std::string moduleName(const std::string& code, int module) {
  return module == 0 ? code : code + std::to_string(module + 1);
}

NamedArray heightActivity(const std::vector<WeightedBump>& bumps, int module, double period) {
  NamedArray array{
      moduleName("height", module) + ".activity", {kSheetUnits}, std::vector<float>(kSheetUnits)};
  for (const auto& [bump, share] : bumps) {
    if (share < kMinShare) continue;
    auto value = array.values.begin();
    for (const double rate :
         axisActivity(bump->centre.heights(module), bump->height_variance, period)) {
      *value++ += static_cast<float>(share * rate);
    }
  }
  return array;
}

NamedArray sheetActivity(const std::vector<WeightedBump>& bumps, int module, double period) {
  NamedArray array{moduleName("grid", module) + ".activity",
                   {kSheetUnits, kSheetUnits},
                   std::vector<float>(kSheetUnits * kSheetUnits)};
  for (const auto& [bump, share] : bumps) {
    if (share < kMinShare) continue;
    const Eigen::Vector2d phase = bump->centre.phases.col(module);
    const auto columns = axisActivity(phase.x(), bump->covariance(0, 0), period);
    const auto rows = axisActivity(phase.y(), bump->covariance(1, 1), period);
    auto value = array.values.begin();
    for (const double row : rows) {
      for (const double column : columns) *value++ += static_cast<float>(share * row * column);
    }
  }
  return array;
}

/// x, y and heading of the bump from the origin, m and rad.
Eigen::Vector3d decoded(const BumpNetwork& network, const Bump& bump) {
  Eigen::Vector3d pose = network.code().difference(network.code().origin(), bump.centre);
  pose.z() = bump.centre.heading;
  return pose;
}

NamedArray hypotheses(const BumpNetwork& network, const std::vector<WeightedBump>& bumps) {
  constexpr std::size_t kColumns = 5;
  NamedArray array{"hypotheses",
                   {static_cast<std::int64_t>(kMaxBumps) + 1, kColumns},
                   std::vector<float>((kMaxBumps + 1) * kColumns)};
  auto value = array.values.begin();
  for (const auto& [bump, share] : bumps) {
    const Eigen::Vector3d pose = decoded(network, *bump);
    const double variance = 0.5 * (bump->covariance(0, 0) + bump->covariance(1, 1));
    const double readout = network.code().grid().sigma();
    for (const double number :
         {pose.z(), pose.x(), pose.y(), 1 / (variance + readout * readout), share}) {
      *value++ = static_cast<float>(number);
    }
  }
  return array;
}

ArrayAxis components(std::vector<std::string> labels) {
  return {"component", "", 0, 1, 0, std::move(labels)};
}

ArrayInfo values(std::string name, std::string unit, std::string doc,
                 std::vector<std::string> labels) {
  return {std::move(name),
          ArrayKind::Values,
          std::move(unit),
          std::move(doc),
          "",
          {components(std::move(labels))}};
}

ArrayInfo rates(std::string name, std::string doc, std::vector<ArrayAxis> axes) {
  return {std::move(name), ArrayKind::Activity, "", std::move(doc), "", std::move(axes)};
}

ArrayAxis unitAxis(const char* name, double period) {
  return {name, "m", 0, period / kSheetUnits, period, {}};
}

}  // namespace

void appendArrays(const BumpNetwork& network, std::vector<NamedArray>& arrays) {
  const std::vector<WeightedBump> bumps = weightedBumps(network);
  const GridCode& grid = network.code().grid();
  arrays.push_back(ringActivity(bumps));
  for (int module = 0; module < grid.modules(); ++module) {
    arrays.push_back(sheetActivity(bumps, module, grid.period(module)));
  }
  const HeightCode& height = network.code().height();
  for (int module = 0; module < height.modules(); ++module) {
    arrays.push_back(heightActivity(bumps, module, height.period(module)));
  }
  arrays.push_back(hypotheses(network, bumps));
  const Bump& integrator = network.state().integrator;
  const Eigen::Vector3f pose = decoded(network, integrator).cast<float>();
  const Eigen::Vector3f sigma = integrator.covariance.diagonal().cwiseSqrt().cast<float>();
  arrays.push_back({"position.decoded", {3}, {pose.x(), pose.y(), pose.z()}});
  arrays.push_back({"position.sigma", {3}, {sigma.x(), sigma.y(), sigma.z()}});
  const RunningCalibration& path = network.state().path;
  NamedArray& calibration = arrays.emplace_back(NamedArray{"calibration", {7}, {}});
  for (int k = 0; k < kPlanarErrors; ++k) {
    calibration.values.push_back(static_cast<float>(path.mixed.mean[k]));
  }
  for (int k = 0; k < kPlanarErrors; ++k) {
    calibration.values.push_back(static_cast<float>(std::sqrt(path.mixed.covariance(k, k))));
  }
  calibration.values.push_back(static_cast<float>(path.noise));
  if (height.modules() == 0) return;
  const double metres = network.code().climb(network.code().origin(), integrator.centre);
  const double height_sigma = std::sqrt(integrator.height_variance);
  arrays.push_back(
      {"height.decoded", {2}, {static_cast<float>(metres), static_cast<float>(height_sigma)}});
}

void describeArrays(const BumpNetwork& network, std::vector<ArrayInfo>& arrays) {
  arrays.push_back(rates("hd.activity", "rates of head direction units, 1 at the most",
                         {{"heading", "rad", 0, kTurn / kRingUnits, kTurn, {}}}));
  const GridCode& grid = network.code().grid();
  for (int module = 0; module < grid.modules(); ++module) {
    const double period = grid.period(module);
    arrays.push_back(rates(moduleName("grid", module) + ".activity",
                           "rates of the grid units of one module, 1 at the most",
                           {unitAxis("y", period), unitAxis("x", period)}));
  }
  const HeightCode& height = network.code().height();
  for (int module = 0; module < height.modules(); ++module) {
    arrays.push_back(rates(moduleName("height", module) + ".activity",
                           "rates of the vertical units of one module, 1 at the most",
                           {unitAxis("height", height.period(module))}));
  }
  arrays.push_back({"hypotheses",
                    ArrayKind::Bump,
                    "",
                    "the integrator, then the calibration bumps; energy: posterior probability",
                    "",
                    {{"hypothesis", "", 0, 1, 0, {}},
                     components({"heading", "x", "y", "precision", "energy"})}});
  arrays.push_back(
      values("position.decoded", "m, rad",
             "position of the integrator from the origin, read from all modules, and heading",
             {"x", "y", "heading"}));
  arrays.push_back(values("position.sigma", "m, rad",
                          "standard deviations of the integrator since the last calibration",
                          {"x", "y", "heading"}));
  arrays.push_back(
      values("calibration", "",
             "steady errors of path integration (rad/rad, rad/s, rad/m), their standard "
             "deviations, and the factor on the noise of odometry",
             {"turns", "turn_per_second", "turn_per_metre", "sigma_turns", "sigma_turn_per_second",
              "sigma_turn_per_metre", "noise"}));
  if (height.modules() == 0) return;
  arrays.push_back(values("height.decoded", "m",
                          "height of the integrator above the origin, and its standard deviation "
                          "since the last calibration",
                          {"height", "sigma"}));
}

}  // namespace tolman::bayesian_attractor
