// SPDX-License-Identifier: BSD-3-Clause
// The steps of one frame: profiles, comparison with the last ones, report.
#include "scanline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace tolman::scanline {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

Result<Region> regionOf(const std::string& name, const std::vector<double>& edges) {
  if (edges.size() == 4 && edges[0] < edges[1] && edges[2] < edges[3]) {
    return Region{edges[0], edges[1], edges[2], edges[3]};
  }
  return Status::invalidParameter(name +
                                  " is empty: give [left, right, upper, lower] with left < right "
                                  "and upper < lower");
}

/// Motion along an arc of length `distance` with the turn `turn` (rad).
PlanarPose arc(double distance, double turn) {
  return {distance * std::cos(0.5 * turn), distance * std::sin(0.5 * turn), turn};
}

/// Covariance along and across the motion, and of the turn. The deviations of height, pitch and
/// roll, which the method does not measure, are those of a car on a road. Chosen, not tuned.
Matrix6d covarianceOf(double sigma_distance, double sigma_turn) {
  constexpr double kUnseenTurn = 0.01;  // rad
  Vector6d sigmas;
  sigmas << 0.3 * sigma_distance, 0.3 * sigma_distance, sigma_distance, kUnseenTurn, sigma_turn,
      kUnseenTurn;
  return sigmas.cwiseAbs2().asDiagonal();
}

}  // namespace

Status Scanline::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  rig_ = context.rig;
  const Parameters& p = parameters_;
  const Result<Region> turn = regionOf("turn_region", p.turn_region);
  if (!turn.isOk()) return turn.status();
  const Result<Region> speed = regionOf("speed_region", p.speed_region);
  if (!speed.isOk()) return speed.status();
  if (rig_.width == 0) {
    return Status::unsupported("the source has no images; use a source with a camera");
  }
  turn_maker_.emplace(rig_, turn.value(), p.field_of_view * kDegree);
  speed_maker_.emplace(rig_, speed.value(), p.field_of_view * kDegree);
  constexpr int kMinColumns = 8;  // chosen, not tuned
  if (std::min(turn_maker_->samples(), speed_maker_->samples()) < kMinColumns) {
    return Status::invalidParameter("a part of the image has fewer than 8 columns; make it wider");
  }
  return reset();
}

Status Scanline::reset() {
  reference_.reset();
  v_ = omega_ = since_reference_ = 0;
  predicted_ = {};
  lost_frames_ = 0;
  last_stamp_ns_ = -1;
  return Status::ok();
}

std::optional<Scanline::Scan> Scanline::scan(const Image& image) const {
  if (image.empty()) return std::nullopt;
  Scan made = {turn_maker_->make(image), speed_maker_->make(image)};
  constexpr double kWeakestContrast = 0.01;  // grey levels of 0 to 1, deviation; chosen, not tuned
  if (contrastOf(made.turn) < kWeakestContrast) return std::nullopt;
  return made;
}

Status Scanline::track(const Frame& frame, Motion& motion) {
  const Image& image = frame.left;
  if (!image.empty() && (image.width() != rig_.width || image.height() != rig_.height)) {
    return Status::invalidInput("the image has " + std::to_string(image.width()) + "x" +
                                std::to_string(image.height()) + " pixels, the camera " +
                                std::to_string(rig_.width) + "x" + std::to_string(rig_.height) +
                                "; give images of one size");
  }
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  motion.dt = last_stamp_ns_ < 0 ? 0 : 1e-9 * double(frame.stamp_ns - last_stamp_ns_);
  motion.scale_known = false;
  last_stamp_ns_ = frame.stamp_ns;
  since_reference_ += motion.dt;
  std::optional<Scan> now = scan(image);
  if (!reference_) {
    // Nothing to compare with: no speed is reported.
    motion.state = TrackingState::Initialising;
    if (motion.dt > 0) motion.covariance = covarianceOf(10, 1);  // m, rad: unknown
  } else if (now) {
    answerMeasured(*now, motion);
  } else {
    answerPredicted(motion);
  }
  if (now) {
    reference_ = std::move(now);
    since_reference_ = 0;
    predicted_ = {};
    lost_frames_ = 0;
  }
  setPlanarVelocity(motion, motion.dt);
  return Status::ok();
}

void Scanline::answerMeasured(const Scan& now, Motion& motion) {
  const Parameters& p = parameters_;
  const double step = turn_maker_->radiansPerSample();
  const auto shifts = [&](const ProfileMaker& maker) {
    return static_cast<int>(std::ceil(p.largest_turn * kDegree / maker.radiansPerSample()));
  };
  const ProfileMatch turned = matchProfiles(reference_->turn, now.turn, shifts(*turn_maker_));
  const ProfileMatch moved = matchProfiles(reference_->speed, now.speed, shifts(*speed_maker_));
  // When the camera turns left, the scene moves right in the image.
  const double turn = turned.moved_right * step;
  const double way = moved.difference > p.still ? p.metres_per_difference * moved.difference : 0;
  const double distance = std::min(way, p.largest_speed * since_reference_);
  const PlanarPose since_reference = arc(distance, turn);
  motion.state = TrackingState::Tracking;
  // While lost, predicted motions were reported; this frame gets the rest of the measured motion.
  motion.T_previous_current = fromPlanar(between(predicted_, since_reference));
  constexpr double kSigmaTurn = 0.3 * kDegree;  // of the sharpest minimum; chosen, not tuned
  const double doubt = std::hypot(kSigmaTurn, 0.5 * turned.uncertainty * step);
  const double least = p.still * p.metres_per_difference;
  motion.covariance = covarianceOf(std::max(p.sigma_distance * distance, least), doubt);
  motion.tracked = turned.compared;
  if (since_reference_ > 0) {
    v_ = distance / since_reference_;
    omega_ = turn / since_reference_;
  }
}

void Scanline::answerPredicted(Motion& motion) {
  ++lost_frames_;
  const PlanarPose step = arc(v_ * motion.dt, omega_ * motion.dt);
  predicted_ = compose(predicted_, step);
  motion.state = TrackingState::Lost;
  motion.T_previous_current = fromPlanar(step);
  const double least = parameters_.still * parameters_.metres_per_difference;
  motion.covariance =
      covarianceOf(lost_frames_ * std::max(std::abs(step.x), least), lost_frames_ * 3 * kDegree);
}

Status Scanline::finish(std::vector<MotionRevision>& /*revisions*/) { return Status::ok(); }

}  // namespace tolman::scanline
