// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/contract.hpp"

#include <fmt/format.h>

#include <cmath>

#include "host/stages.hpp"

namespace tolman::conformance {
namespace {

Status checkPose(const Eigen::Isometry3d& T, const std::string& name) {
  const Eigen::Matrix3d R = T.linear();
  const bool rotation =
      (R.transpose() * R - Eigen::Matrix3d::Identity()).norm() < 1e-6 && R.determinant() > 0;
  if (rotation) return Status::ok();
  return Status::failed("the rotation of '" + name + "' is not orthonormal; use normalised()");
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

/// Of a relative pose. With zero covariance the map would trust it over all other measurements.
Status checkMeasured(const Matrix6d& covariance) {
  if (covariance.trace() > 0) return checkCovariance(covariance);
  return Status::failed(
      "has_relative_pose with zero covariance claims an exact pose; set its covariance");
}

Status checkDt(const Motion& motion, const Frame& frame, const Frame* previous) {
  const std::int64_t passed_ns = previous ? frame.stamp_ns - previous->stamp_ns : 0;
  const double expected = 1e-9 * static_cast<double>(passed_ns);
  if (std::abs(motion.dt - expected) < 1e-6) return Status::ok();
  return Status::failed(fmt::format("dt is {:f} s, the stamps say {:f} s; see setPlanarVelocity()",
                                    motion.dt, expected));
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
    return Status::failed(
        fmt::format("points of frame {}, which is not a past frame", motion.points_frame));
  }
  Status status = checkPose(motion.T_previous_current, "T_previous_current");
  if (status.isOk()) status = checkCovariance(motion.covariance);
  if (status.isOk()) status = checkDt(motion, frame, previous);
  return status.isOk() ? checkRevisions(motion.revisions) : status;
}

Status checkPlace(const PlaceObservation& seen, std::int64_t& templates) {
  Status status = host::checkTemplateId(seen, templates);
  if (seen.recognition == Recognition::Novel) ++templates;
  if (!status.isOk() || !seen.has_relative_pose) return status;
  status = checkPose(seen.T_template_current, "T_template_current");
  return status.isOk() ? checkMeasured(seen.covariance) : status;
}

Status checkDecision(const Decision& decision, std::int64_t last) {
  if (decision.action == Action::Stay && decision.experience != last) {
    return Status::failed(
        fmt::format("stays at experience {}, but was at {}", decision.experience, last));
  }
  for (const EarlierLoop& loop : decision.earlier) {
    Status status = checkPose(loop.T_experience_camera, "earlier.T_experience_camera");
    if (status.isOk()) status = checkMeasured(loop.covariance);
    if (!status.isOk()) return status;
  }
  if (decision.action != Action::CloseLoop || !decision.has_relative_pose) return Status::ok();
  const Status status = checkPose(decision.T_experience_current, "T_experience_current");
  return status.isOk() ? checkMeasured(decision.covariance) : status;
}

Status checkUpdate(const MapUpdate& update, const MapGraph& graph, std::int64_t last_version) {
  const auto experiences = static_cast<std::int64_t>(graph.experiences.size());
  if (update.version < last_version) return Status::failed("the version of the map decreased");
  if (update.experiences != experiences ||
      update.links != static_cast<std::int64_t>(graph.links.size())) {
    return Status::failed("the update's counts of experiences and links differ from graph()");
  }
  if (update.experience < -1 || update.experience >= experiences) {
    return Status::failed("the frame is attached to experience " +
                          std::to_string(update.experience) + ", which does not exist");
  }
  const Status status = checkPose(update.T_world_camera, "T_world_camera");
  return status.isOk() ? checkPose(update.T_experience_camera, "T_experience_camera") : status;
}

}  // namespace tolman::conformance
