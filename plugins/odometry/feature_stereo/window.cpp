// SPDX-License-Identifier: BSD-3-Clause
// Book-keeping of the active window.
#include "window.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "window_lanes.hpp"

namespace tolman::feature_stereo {

void Window::clear() {
  keyframes_.clear();
  landmarks_.clear();
}

void Window::dropOldest() {
  const std::int64_t oldest = keyframes_.front().frame;
  keyframes_.pop_front();
  for (auto& [id, landmark] : landmarks_) {
    std::erase_if(landmark.observations,
                  [oldest](const Observation& seen) { return seen.keyframe == oldest; });
  }
  dropUnseen();
}

void Window::dropUnseen() {
  std::erase_if(landmarks_, [](const auto& entry) { return entry.second.observations.empty(); });
}

std::int64_t Window::addLandmark(const Landmark& landmark) {
  landmarks_.emplace(next_id_, landmark);
  return next_id_++;
}

Landmark* Window::find(std::int64_t id) {
  const auto found = landmarks_.find(id);
  return found == landmarks_.end() ? nullptr : &found->second;
}

std::size_t Window::indexOf(std::int64_t frame) const {
  std::size_t index = 0;
  while (keyframes_[index].frame != frame) ++index;
  return index;
}

// Levenberg-Marquardt over the window, and the removal of outliers.

namespace {

/// Prior of the disparity offset: near zero and near its last value. While the camera stands, no
/// observation distinguishes the offset from a change of scale.
class OffsetPrior {
 public:
  OffsetPrior(double before, const RefinementSettings& settings)
      : before_(before), sigma_(settings.offset_sigma), drift_(settings.offset_drift) {}

  bool isFixed() const { return sigma_ <= 0; }
  double cost(double offset) const {
    if (isFixed()) return 0;
    return offset * offset / (sigma_ * sigma_) +
           (offset - before_) * (offset - before_) / (drift_ * drift_);
  }
  /// Adds the prior to the last unknown of the system, or holds it.
  void addTo(WindowSystem& system, double offset) const {
    const Eigen::Index last = system.gradient.size() - 1;
    if (isFixed()) {
      system.information.row(last).setZero();
      system.information.col(last).setZero();
      system.information(last, last) = 1;
      system.gradient[last] = 0;
      return;
    }
    system.information(last, last) += 1 / (sigma_ * sigma_) + 1 / (drift_ * drift_);
    system.gradient[last] += offset / (sigma_ * sigma_) + (offset - before_) / (drift_ * drift_);
  }

 private:
  double before_;
  double sigma_;
  double drift_;
};

WindowState moved(const WindowState& state, const Eigen::VectorXd& step) {
  WindowState next = state;
  for (std::size_t k = 1; k < state.poses.size(); ++k) {
    const Vector6d twist = step.segment<6>(static_cast<Eigen::Index>(6 * (k - 1)));
    next.poses[k] = normalised(state.poses[k] * expSe3(twist));
  }
  next.offset += step[step.size() - 1];
  return next;
}

/// The damped step; not finite when the system is singular.
Eigen::VectorXd solved(WindowSystem& system, double damping) {
  constexpr double kRegular = 1e-6;  // for a keyframe that nothing was seen from
  system.information.diagonal() *= 1 + damping;
  system.information.diagonal().array() += kRegular;
  return -system.information.llt().solve(system.gradient);
}

void minimise(const RefinementSettings& settings, WindowLanes& problem, WindowState& state) {
  constexpr double kCostTolerance = 1e-5;  // relative, of the cost; chosen, not tuned
  const OffsetPrior prior(state.offset, settings);
  double damping = 1e-4;
  WindowSystem system;
  double cost = problem.linearise(state, damping, system) + prior.cost(state.offset);
  for (int k = 0; k < settings.iterations; ++k) {
    prior.addTo(system, state.offset);
    const Eigen::VectorXd step = solved(system, damping);
    if (!step.allFinite()) return;
    const WindowState next = moved(state, step);
    problem.move(step);
    const bool last = k + 1 == settings.iterations;
    const double next_damping = damping / 3;
    const double next_cost =
        (last ? problem.cost(next) : problem.linearise(next, next_damping, system)) +
        prior.cost(next.offset);
    if (!(next_cost <= cost)) {  // also where it is not a number
      problem.moveBack();
      damping *= 10;
      if (!last) problem.linearise(state, damping, system);
      continue;
    }
    state = next;
    const bool converged = cost - next_cost < kCostTolerance * cost;
    cost = next_cost;
    damping = next_damping;
    if (converged) return;
  }
}

/// Removes outlying observations and takes the covariance from the others.
void removeOutliers(const Window& window, const WindowLanes::Fit& fit, Landmark& landmark) {
  std::erase_if(landmark.observations, [&](const Observation& seen) {
    return (fit.keyframes >> window.indexOf(seen.keyframe) & 1U) == 0;
  });
  const Eigen::Matrix3d covariance = fit.information.inverse();
  const bool determined = covariance.allFinite() && covariance.diagonal().minCoeff() > 0;
  if (determined) {
    landmark.covariance = covariance;
  } else {
    landmark.observations.clear();
  }
}

}  // namespace

void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window) {
  if (window.keyframes().size() < 2 || settings.iterations == 0) return;
  std::vector<Landmark*> landmarks;
  for (auto& [id, landmark] : window.landmarks()) {
    // One observation does not constrain poses.
    if (landmark.observations.size() >= 2) landmarks.push_back(&landmark);
  }
  if (landmarks.empty()) return;
  WindowState state;
  for (const Keyframe& keyframe : window.keyframes()) {
    state.poses.push_back(keyframe.T_world_camera);
  }
  state.offset = window.disparityOffset();
  WindowLanes problem(rig, settings.noise, window, landmarks);
  minimise(settings, problem, state);
  window.setDisparityOffset(state.offset);
  for (std::size_t k = 1; k < state.poses.size(); ++k) {
    window.keyframes()[k].T_world_camera = state.poses[k];
  }
  const std::vector<WindowLanes::Fit> fits = problem.fits(state, kGate);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    landmarks[i]->point.coordinates = problem.coordinatesOf(i);
    removeOutliers(window, fits[i], *landmarks[i]);
  }
  window.dropUnseen();
}

}  // namespace tolman::feature_stereo
