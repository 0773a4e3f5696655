// SPDX-License-Identifier: BSD-3-Clause
#include "spatial_cells.hpp"

#include <algorithm>

namespace tolman::bayesian_attractor {

void SpatialCells::integrate(const PlanarPose& motion) {
  const double heading = ring_.integratedHeading();
  torus_.move(motion.x, motion.y, heading);
  for (GridTorus& torus : further_) torus.move(motion.x, motion.y, heading);
  ring_.turn(motion.theta);
}

bool SpatialCells::contradictsCalibration(const CellPose& pose) const {
  const double turn = distance<1>(ring_.calibration().mean, Phase<1>(pose.heading), ring_.period());
  const double step = distance<2>(torus_.calibration().mean, pose.position, torus_.period());
  if (turn > settings_.gate_heading || step > settings_.gate_position) return true;
  for (std::size_t i = 0; i < further_.size(); ++i) {
    const GridTorus& torus = further_[i];
    const double apart = distance<2>(torus.calibration().mean, pose.further.at(i), torus.period());
    if (apart > settings_.gate_position) return true;
  }
  return false;
}

void SpatialCells::inject(const CellPose& pose, double strength) {
  if (settings_.consistency_gate && contradictsCalibration(pose)) {
    restartCalibrations();
    support_.views = 0;
  }
  ring_.inject(Phase<1>(pose.heading), strength);
  torus_.inject(pose.position, strength);
  for (std::size_t i = 0; i < further_.size(); ++i) {
    further_[i].inject(pose.further.at(i), strength);
  }
  ++support_.views;
  support_.unsupported = 0;
}

void SpatialCells::settle() {
  ring_.settle();
  torus_.settle();
  for (GridTorus& torus : further_) torus.settle();
}

void SpatialCells::weakenIntegrators(double factor) {
  ring_.weakenIntegrator(factor);
  torus_.weakenIntegrator(factor);
  for (GridTorus& torus : further_) torus.weakenIntegrator(factor);
}

bool SpatialCells::familiar() const {
  return calibrationShare() > settings_.decision_share &&
         ring_.disagreement() < settings_.decision_heading &&
         torus_.disagreement() < settings_.decision_position &&
         std::ranges::all_of(further_, [&](const GridTorus& torus) {
           return torus.disagreement() < settings_.decision_position;
         });
}

void SpatialCells::adoptEstimate() {
  ring_.adoptEstimate();
  torus_.adoptEstimate();
  for (GridTorus& torus : further_) torus.adoptEstimate();
  support_ = {};
}

void SpatialCells::noteUnsupportedView() {
  // With symmetric inhibition a calibration above half wins for good, right or wrong.
  if (++support_.unsupported > settings_.patience) forgetCalibration();
}

void SpatialCells::restartCalibrations() {
  ring_.restartCalibration();
  torus_.restartCalibration();
  for (GridTorus& torus : further_) torus.restartCalibration();
}

void SpatialCells::forgetCalibration() {
  restartCalibrations();
  support_ = {};
}

CellPose SpatialCells::estimate() const {
  CellPose pose{ring_.estimated().mean(0), torus_.estimated().mean, {}};
  for (const GridTorus& torus : further_) pose.further.push_back(torus.estimated().mean);
  return pose;
}

CellPose SpatialCells::displaced(const CellPose& pose, const PlanarPose& step) const {
  const auto moved = [&](const GridTorus& torus, const Phase<2>& from) {
    const Phase<2> position = from + torus.toCells(step.x, step.y, pose.heading);
    return wrapped<2>(position, torus.period());
  };
  CellPose there{
      wrapPeriod(pose.heading + step.theta, ring_.period()), moved(torus_, pose.position), {}};
  for (std::size_t i = 0; i < further_.size(); ++i) {
    there.further.push_back(moved(further_[i], pose.further.at(i)));
  }
  return there;
}

double SpatialCells::calibrationShare() const {
  double share = std::min(ring_.calibrationShare(), torus_.calibrationShare());
  for (const GridTorus& torus : further_) share = std::min(share, torus.calibrationShare());
  return share;
}

}  // namespace tolman::bayesian_attractor
