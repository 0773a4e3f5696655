// SPDX-License-Identifier: BSD-3-Clause
// The refinement of a window against Ceres, and its normal equations against sums over single
// observations.
#include <ceres/ceres.h>

#include <Eigen/Cholesky>

#include "plugins/feature_stereo/known_window.hpp"
#include "window.hpp"
#include "window_lanes.hpp"
// After Ceres.
#include "plugins/feature_stereo/catch_check.hpp"

namespace tolman::feature_stereo {
namespace {

const RefinementSettings kSettings;
constexpr double kHuberLimit = 2;

Eigen::Vector3d weightsOf(const Observation& seen) {
  Eigen::Vector3d weights = kSettings.noise.sigma(seen.pixel.z()).cwiseInverse();
  if (!seen.has_disparity) weights.z() = 0;
  return weights;
}

/// A pose as rotation vector and translation; Ceres takes its derivatives by differences.
Eigen::Isometry3d poseOf(const double* six) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = expSo3(Eigen::Map<const Eigen::Vector3d>(six + 3));
  T.translation() = Eigen::Map<const Eigen::Vector3d>(six);
  return T;
}

struct Reprojection {
  Eigen::Isometry3d T_world_reference;
  Observation seen;

  bool operator()(const double* pose, const double* point, const double* offset,
                  double* residuals) const {
    const InverseDepthPoint there{T_world_reference, Eigen::Map<const Eigen::Vector3d>(point)};
    const auto predicted = project(test::streetRig(), poseOf(pose), there);
    if (!predicted) return false;
    Eigen::Map<Eigen::Vector3d>(residuals, 3) =
        weightsOf(seen).cwiseProduct(*predicted + StereoPixel(0, 0, *offset) - seen.pixel);
    return true;
  }
};

struct Prior {
  bool operator()(const double* offset, double* residuals) const {
    residuals[0] = *offset / kSettings.offset_sigma;
    residuals[1] = *offset / kSettings.offset_drift;  // the last one is 0
    return true;
  }
};

struct Solution {
  std::vector<Eigen::Isometry3d> poses;
  double offset = 0;
};

Solution solvedByCeres(Window window) {
  std::vector<std::array<double, 6>> poses;
  for (const Keyframe& keyframe : window.keyframes()) {
    const Eigen::Vector3d turn = logSo3(keyframe.T_world_camera.linear());
    const Eigen::Vector3d t = keyframe.T_world_camera.translation();
    poses.push_back({t.x(), t.y(), t.z(), turn.x(), turn.y(), turn.z()});
  }
  Solution solution;
  ceres::Problem problem;
  for (auto& [id, landmark] : window.landmarks()) {
    for (const Observation& seen : landmark.observations) {
      auto* cost = new ceres::NumericDiffCostFunction<Reprojection, ceres::CENTRAL, 3, 6, 3, 1>(
          new Reprojection{landmark.point.T_world_reference, seen});
      problem.AddResidualBlock(cost, new ceres::HuberLoss(kHuberLimit),
                               poses[window.indexOf(seen.keyframe)].data(),
                               landmark.point.coordinates.data(), &solution.offset);
    }
  }
  problem.SetParameterBlockConstant(poses.front().data());
  problem.AddResidualBlock(
      new ceres::NumericDiffCostFunction<Prior, ceres::CENTRAL, 2, 1>(new Prior), nullptr,
      &solution.offset);
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 100;
  options.function_tolerance = 1e-12;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  for (const auto& pose : poses) solution.poses.push_back(poseOf(pose.data()));
  return solution;
}

/// Observations as tracks have them: beginning and ending at different keyframes, with gaps.
void thin(Window& window) {
  for (auto& [id, landmark] : window.landmarks()) {
    std::erase_if(landmark.observations, [&, n = id](const Observation& seen) {
      const std::int64_t keyframe = seen.keyframe / 10;
      return keyframe < n % 3 || (n % 5 == 0 && keyframe == 4) || (n % 7 == 0 && keyframe == 3);
    });
  }
}

std::vector<Landmark*> landmarksOf(Window& window) {
  std::vector<Landmark*> landmarks;
  for (auto& [id, landmark] : window.landmarks()) landmarks.push_back(&landmark);
  return landmarks;
}

WindowState stateOf(const Window& window, double offset) {
  WindowState state;
  for (const Keyframe& keyframe : window.keyframes())
    state.poses.push_back(keyframe.T_world_camera);
  state.offset = offset;
  return state;
}

/// The whole system, with three unknowns for each landmark after those of poses and offset.
struct WholeSystem {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
  double cost = 0;
};

WholeSystem wholeSystem(Window& window, double offset) {
  const std::vector<Landmark*> landmarks = landmarksOf(window);
  const auto poses = static_cast<Eigen::Index>(6 * (window.keyframes().size() - 1));
  const Eigen::Index size = poses + 1 + 3 * static_cast<Eigen::Index>(landmarks.size());
  WholeSystem whole{Eigen::MatrixXd::Zero(size, size), Eigen::VectorXd::Zero(size)};
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    for (const Observation& seen : landmarks[i]->observations) {
      ProjectionJacobians J;
      const std::size_t keyframe = window.indexOf(seen.keyframe);
      const auto predicted = project(test::streetRig(), window.keyframes()[keyframe].T_world_camera,
                                     landmarks[i]->point, &J);
      REQUIRE(predicted);
      const Eigen::Vector3d weights = weightsOf(seen);
      const Eigen::Vector3d error =
          weights.cwiseProduct(*predicted + StereoPixel(0, 0, offset) - seen.pixel);
      const double length = error.norm();
      whole.cost += length <= kHuberLimit ? length * length
                                          : 2 * kHuberLimit * length - kHuberLimit * kHuberLimit;
      const double robust = length <= kHuberLimit ? 1 : kHuberLimit / length;
      Eigen::MatrixXd row = Eigen::MatrixXd::Zero(3, size);
      if (keyframe > 0) row.middleCols(6 * (static_cast<Eigen::Index>(keyframe) - 1), 6) = J.pose;
      row(2, poses) = 1;
      row.middleCols(poses + 1 + 3 * static_cast<Eigen::Index>(i), 3) = J.point;
      row = weights.asDiagonal() * row;
      whole.information += robust * row.transpose() * row;
      whole.gradient += robust * row.transpose() * error;
    }
  }
  return whole;
}

}  // namespace

TEST_CASE("the system without landmarks, and their step, are those of the whole system") {
  Window window = makeWindow(0.3, 0.1);
  disturb(window);
  thin(window);
  std::erase_if(window.landmarks(), [](const auto& entry) { return entry.first >= 30; });
  window.find(7)->observations.front().pixel.x() += 20;  // for Huber's weights
  constexpr double kOffset = 0.05;
  const WholeSystem whole = wholeSystem(window, kOffset);
  const std::vector<Landmark*> landmarks = landmarksOf(window);
  WindowLanes lanes(test::streetRig(), kSettings.noise, window, landmarks);
  const WindowState state = stateOf(window, kOffset);
  WindowSystem system;
  const double cost = lanes.linearise(state, 0, system);
  CHECK(cost == Approx(whole.cost).epsilon(1e-9));
  CHECK(lanes.cost(state) == Approx(whole.cost).epsilon(1e-9));

  const Eigen::Index kept = system.gradient.size();
  const Eigen::VectorXd all = -whole.information.ldlt().solve(whole.gradient);
  const Eigen::VectorXd step = -system.information.ldlt().solve(system.gradient);
  CHECK((step - all.head(kept)).norm() < 1e-6 * all.head(kept).norm());
  lanes.move(step);
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    const Eigen::Vector3d moved = lanes.coordinatesOf(i) - landmarks[i]->point.coordinates;
    const Eigen::Vector3d expected = all.segment<3>(kept + 3 * static_cast<Eigen::Index>(i));
    CHECK((moved - expected).norm() < 1e-6 * (1e-3 + expected.norm()));
  }
  lanes.moveBack();
  CHECK(lanes.coordinatesOf(5) == landmarks[5]->point.coordinates);
}

TEST_CASE("a refined window is the one that Ceres finds") {
  Window window = makeWindow(0.3, 0.1);
  disturb(window);
  thin(window);
  window.find(7)->observations.front().pixel.x() += 20;
  const Solution truth = solvedByCeres(window);
  RefinementSettings settings;
  settings.iterations = 50;
  refineWindow(test::streetRig(), settings, window);
  CHECK(window.disparityOffset() == Approx(truth.offset).margin(1e-4));
  for (std::size_t k = 0; k < truth.poses.size(); ++k) {
    const Vector6d error = logSe3(truth.poses[k].inverse() * window.keyframes()[k].T_world_camera);
    CHECK(error.head<3>().norm() < 1e-3);
    CHECK(error.tail<3>().norm() < 2e-5);
  }
}

TEST_CASE("fits() agrees with the errors and information of single observations") {
  Window window = makeWindow(0.6, 0);
  thin(window);
  const std::vector<Landmark*> landmarks = landmarksOf(window);
  WindowLanes lanes(test::streetRig(), kSettings.noise, window, landmarks);
  constexpr double kLimit = 4;
  const auto fits = lanes.fits(stateOf(window, 0), kLimit);
  int outside = 0;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    std::uint32_t keyframes = 0;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
    for (const Observation& seen : landmarks[i]->observations) {
      const std::size_t keyframe = window.indexOf(seen.keyframe);
      ProjectionJacobians J;
      const auto predicted = project(test::streetRig(), window.keyframes()[keyframe].T_world_camera,
                                     landmarks[i]->point, &J);
      const Eigen::Vector3d weights = weightsOf(seen);
      if (weights.cwiseProduct(seen.pixel - *predicted).squaredNorm() > kLimit) {
        ++outside;
        continue;
      }
      keyframes |= 1U << keyframe;
      const Eigen::Matrix3d whitened = weights.asDiagonal() * J.point;
      information += whitened.transpose() * whitened;
    }
    CHECK(fits[i].keyframes == keyframes);
    CHECK((fits[i].information - information).norm() <= 1e-9 * information.norm());
  }
  CHECK(outside > 20);
}

}  // namespace tolman::feature_stereo
