// SPDX-License-Identifier: BSD-3-Clause
// The least squares problem of the window, its solution, and the removal of outliers.
#include "window_refinement.hpp"

#include <ceres/ceres.h>

#include <memory>

namespace tolman::feature_stereo {
namespace {

using CeresJacobian = Eigen::Matrix<double, 3, 7, Eigen::RowMajor>;
constexpr double kHuber = 2.0;  // sigmas; chosen, not tuned

/// 1 / sigma; 0 for a disparity that was not measured.
Eigen::Vector3d weightsOf(const Observation& seen, const RefinementSettings& settings) {
  Eigen::Vector3d weights = settings.noise.sigma(seen.pixel.z()).cwiseInverse();
  if (!seen.has_disparity) weights.z() = 0;
  return weights;
}

/// Copies of poses and points in two arrays. Ceres sorts blocks by address within a group, so
/// their order in memory must be the order of keyframes and ids.
struct Blocks {
  std::vector<PoseBlock> poses;
  std::vector<Eigen::Vector3d> points;
  std::vector<Landmark*> landmarks;  ///< of the points
  double offset;                     ///< of the disparities

  explicit Blocks(Window& window) : offset(window.disparityOffset()) {
    for (const Keyframe& keyframe : window.keyframes()) {
      poses.push_back(toBlock(keyframe.T_world_camera));
    }
    for (auto& [id, landmark] : window.landmarks()) {
      if (landmark.observations.size() < 2) continue;  // does not constrain poses
      landmarks.push_back(&landmark);
      points.push_back(landmark.point.coordinates);
    }
  }
};

std::size_t indexOf(const Window& window, std::int64_t keyframe) {
  std::size_t index = 0;
  while (window.keyframes()[index].frame != keyframe) ++index;
  return index;
}

void solve(const CameraRig& rig, const RefinementSettings& settings, const Window& window,
           Blocks& blocks) {
  PoseManifold manifold;
  ceres::HuberLoss loss(kHuber);
  ceres::Problem::Options ownership;
  ownership.manifold_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
  ceres::Problem problem(ownership);
  auto ordering = std::make_shared<ceres::ParameterBlockOrdering>();
  for (PoseBlock& pose : blocks.poses) {
    problem.AddParameterBlock(pose.data(), 7, &manifold);
    ordering->AddElementToGroup(pose.data(), 1);
  }
  problem.SetParameterBlockConstant(blocks.poses.front().data());
  problem.AddParameterBlock(&blocks.offset, 1);
  ordering->AddElementToGroup(&blocks.offset, 2);
  if (settings.offset_sigma > 0) {
    problem.AddResidualBlock(new OffsetPrior(blocks.offset, settings), nullptr, &blocks.offset);
  } else {
    problem.SetParameterBlockConstant(&blocks.offset);
  }
  for (std::size_t i = 0; i < blocks.points.size(); ++i) {
    const Landmark& landmark = *blocks.landmarks[i];
    for (const Observation& seen : landmark.observations) {
      problem.AddResidualBlock(
          new StereoReprojection(rig, landmark.point.T_world_reference, seen, settings), &loss,
          blocks.poses[indexOf(window, seen.keyframe)].data(), blocks.points[i].data(),
          &blocks.offset);
    }
    ordering->AddElementToGroup(blocks.points[i].data(), 0);
  }
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::DENSE_SCHUR;
  options.linear_solver_ordering = ordering;
  options.num_threads = 1;
  options.max_num_iterations = settings.iterations;
  options.function_tolerance = 1e-5;  // relative; chosen, not tuned
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
}

/// Removes outlying observations and computes the covariance from the others.
void removeOutliers(const CameraRig& rig, const RefinementSettings& settings, const Window& window,
                    Landmark& landmark) {
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  std::erase_if(landmark.observations, [&](const Observation& seen) {
    ProjectionJacobians J;
    const Keyframe& keyframe = window.keyframes()[indexOf(window, seen.keyframe)];
    const auto predicted = project(rig, keyframe.T_world_camera, landmark.point, &J);
    if (!predicted) return true;
    const Eigen::Vector3d weights = weightsOf(seen, settings);
    const StereoPixel pixel = seen.pixel - StereoPixel(0, 0, window.disparityOffset());
    if (weights.cwiseProduct(pixel - *predicted).squaredNorm() > kGate) return true;
    const Eigen::Matrix3d whitened = weights.asDiagonal() * J.point;
    information += whitened.transpose() * whitened;
    return false;
  });
  const Eigen::Matrix3d covariance = information.inverse();
  const bool determined = covariance.allFinite() && covariance.diagonal().minCoeff() > 0;
  if (determined) {
    landmark.covariance = covariance;
  } else {
    landmark.observations.clear();
  }
}

}  // namespace

StereoReprojection::StereoReprojection(const CameraRig& rig,
                                       const Eigen::Isometry3d& T_world_reference,
                                       const Observation& observation,
                                       const RefinementSettings& settings)
    : rig_(rig),
      T_world_reference_(T_world_reference),
      pixel_(observation.pixel),
      weights_(weightsOf(observation, settings)) {}

bool StereoReprojection::Evaluate(double const* const* parameters, double* residuals,
                                  double** jacobians) const {
  const InverseDepthPoint point{T_world_reference_,
                                Eigen::Map<const Eigen::Vector3d>(parameters[1])};
  ProjectionJacobians J;
  const auto predicted =
      project(rig_, fromBlock(parameters[0]), point, jacobians == nullptr ? nullptr : &J);
  if (!predicted) return false;  // Ceres takes a smaller step
  const StereoPixel offset(0, 0, parameters[2][0]);
  Eigen::Map<Eigen::Vector3d>(residuals, 3) = weights_.cwiseProduct(*predicted + offset - pixel_);
  if (jacobians == nullptr) return true;
  if (jacobians[0] != nullptr) {
    Eigen::Map<CeresJacobian> by_pose(jacobians[0]);
    by_pose.leftCols<6>() = weights_.asDiagonal() * J.pose;
    by_pose.col(6).setZero();
  }
  if (jacobians[1] != nullptr) {
    Eigen::Map<Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> by_point(jacobians[1]);
    by_point = weights_.asDiagonal() * J.point;
  }
  if (jacobians[2] != nullptr) {
    Eigen::Map<Eigen::Vector3d>(jacobians[2], 3) = Eigen::Vector3d(0, 0, weights_.z());
  }
  return true;
}

bool OffsetPrior::Evaluate(double const* const* parameters, double* residuals,
                           double** jacobians) const {
  residuals[0] = parameters[0][0] / sigma_;
  residuals[1] = (parameters[0][0] - before_) / drift_;
  if (jacobians != nullptr && jacobians[0] != nullptr) {
    jacobians[0][0] = 1 / sigma_;
    jacobians[0][1] = 1 / drift_;
  }
  return true;
}

bool PoseManifold::Plus(const double* x, const double* delta, double* x_plus_delta) const {
  const Vector6d twist = Eigen::Map<const Vector6d>(delta);
  Eigen::Map<PoseBlock>(x_plus_delta, 7) = toBlock(fromBlock(x) * expSe3(twist));
  return true;
}

bool PoseManifold::PlusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 7, 6, Eigen::RowMajor>>(jacobian, 7, 6).setIdentity();
  return true;
}

bool PoseManifold::Minus(const double* y, const double* x, double* y_minus_x) const {
  Eigen::Map<Vector6d>(y_minus_x, 6) = logSe3(fromBlock(x).inverse() * fromBlock(y));
  return true;
}

bool PoseManifold::MinusJacobian(const double* /*x*/, double* jacobian) const {
  Eigen::Map<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>>(jacobian, 6, 7).setIdentity();
  return true;
}

PoseBlock toBlock(const Eigen::Isometry3d& T) {
  PoseBlock block;
  block << T.translation(), Eigen::Quaterniond(T.linear()).normalized().coeffs();
  return block;
}

Eigen::Isometry3d fromBlock(const double* block) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation() = Eigen::Map<const Eigen::Vector3d>(block);
  T.linear() = Eigen::Map<const Eigen::Quaterniond>(block + 3).normalized().toRotationMatrix();
  return T;
}

void refineWindow(const CameraRig& rig, const RefinementSettings& settings, Window& window) {
  if (window.keyframes().size() < 2 || settings.iterations == 0) return;
  Blocks blocks(window);
  if (blocks.points.empty()) return;
  solve(rig, settings, window, blocks);
  window.setDisparityOffset(blocks.offset);
  for (std::size_t i = 0; i < blocks.poses.size(); ++i) {
    window.keyframes()[i].T_world_camera = fromBlock(blocks.poses[i].data());
  }
  for (std::size_t i = 0; i < blocks.points.size(); ++i) {
    blocks.landmarks[i]->point.coordinates = blocks.points[i];
    removeOutliers(rig, settings, window, *blocks.landmarks[i]);
  }
  window.dropUnseen();
}

}  // namespace tolman::feature_stereo
