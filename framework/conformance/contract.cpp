// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/contract.hpp"

#include <cmath>

#include "plugins/stages.hpp"

namespace tolman::conformance {
namespace {

Status checkPose(const Eigen::Isometry3d& T, const std::string& name) {
  const Eigen::Matrix3d R = T.linear();
  const bool rotation =
      (R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-6 && R.determinant() > 0;
  if (rotation) return Status::ok();
  return Status::failed("the rotation of '" + name + "' is no rotation; use normalised()");
}

Status checkCovariance(const Matrix6d& covariance) {
  const double size = covariance.cwiseAbs().maxCoeff();
  if ((covariance - covariance.transpose()).cwiseAbs().maxCoeff() > 1e-9 * size) {
    return Status::failed("the covariance is not symmetric");
  }
  if (covariance.diagonal().minCoeff() < 0) {
    return Status::failed("the covariance has a negative variance");
  }
  return Status::ok();
}

/// Of a relative pose: the map would let nothing else contradict one without uncertainty.
Status checkMeasured(const Matrix6d& covariance) {
  if (covariance.trace() > 0) return checkCovariance(covariance);
  return Status::failed(
      "has_relative_pose with a covariance of zero claims to be exact; say how "
      "uncertain the pose is");
}

Status checkDt(const Motion& motion, const Frame& frame, const Frame* previous) {
  const std::int64_t passed_ns = previous ? frame.stamp_ns - previous->stamp_ns : 0;
  const double expected = 1e-9 * static_cast<double>(passed_ns);
  if (std::abs(motion.dt - expected) < 1e-6) return Status::ok();
  return Status::failed("dt is " + std::to_string(motion.dt) + " s, the stamps say " +
                        std::to_string(expected) + " s; see setPlanarVelocity()");
}

}  // namespace

bool close(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  return (a.matrix() - b.matrix()).norm() < 1e-6 * (1 + a.translation().norm());
}

Status checkRevisions(const std::vector<MotionRevision>& revisions) {
  for (const MotionRevision& revision : revisions) {
    Status status = checkPose(revision.T_previous_current, "revisions.T_previous_current");
    if (status.isOk()) status = checkCovariance(revision.covariance);
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

Status checkMotion(const Motion& motion, const Frame& frame, const Frame* previous) {
  const bool moved = !motion.T_previous_current.isApprox(Eigen::Isometry3d::Identity(), 1e-12);
  if (frame.frame == 0 && (motion.state != TrackingState::Initialising || moved)) {
    return Status::failed("frame 0 has no motion: answer Initialising and the identity");
  }
  if (motion.state == TrackingState::Initialising && moved) {
    return Status::failed("an Initialising motion is the identity");
  }
  if (motion.points.cols() > 0 && (motion.points_frame < 0 || motion.points_frame > motion.frame)) {
    return Status::failed("points of frame " + std::to_string(motion.points_frame) +
                          ", which is not one of the past");
  }
  Status status = checkPose(motion.T_previous_current, "T_previous_current");
  if (status.isOk()) status = checkCovariance(motion.covariance);
  if (status.isOk()) status = checkDt(motion, frame, previous);
  return status.isOk() ? checkRevisions(motion.revisions) : status;
}

Status checkPlace(const PlaceObservation& seen, std::int64_t& templates) {
  Status status = plugins::checkTemplateId(seen, templates);
  if (seen.recognition == Recognition::Novel) ++templates;
  if (!status.isOk() || !seen.has_relative_pose) return status;
  status = checkPose(seen.T_template_current, "T_template_current");
  return status.isOk() ? checkMeasured(seen.covariance) : status;
}

Status checkDecision(const Decision& decision, std::int64_t last) {
  if (decision.action == Action::Stay && decision.experience != last) {
    return Status::failed("stays at experience " + std::to_string(decision.experience) +
                          ", but was at " + std::to_string(last));
  }
  if (decision.action != Action::CloseLoop || !decision.has_relative_pose) return Status::ok();
  const Status status = checkPose(decision.T_experience_current, "T_experience_current");
  return status.isOk() ? checkMeasured(decision.covariance) : status;
}

Status checkUpdate(const MapUpdate& update, const MapGraph& graph, std::int64_t last_version) {
  const auto experiences = static_cast<std::int64_t>(graph.experiences.size());
  if (update.version < last_version) return Status::failed("the version of the map went down");
  if (update.experiences != experiences ||
      update.links != static_cast<std::int64_t>(graph.links.size())) {
    return Status::failed("the update counts other experiences or links than graph() has");
  }
  if (update.experience < -1 || update.experience >= experiences) {
    return Status::failed("the frame hangs on experience " + std::to_string(update.experience) +
                          ", which does not exist");
  }
  const Status status = checkPose(update.T_world_camera, "T_world_camera");
  return status.isOk() ? checkPose(update.T_experience_camera, "T_experience_camera") : status;
}

}  // namespace tolman::conformance
