// SPDX-License-Identifier: BSD-3-Clause
#include "place_verifier.hpp"

namespace tolman::view_sequences {

void PlaceVerifier::beginFrame(const Frame& frame) {
  frame_ = &frame;
  corners_.reset();
}

const landmarks::Corners& PlaceVerifier::corners() {
  if (!corners_) {
    corners_ = landmarks::findCorners(landmarks::grayOf(frame_->left), settings_.corners);
  }
  return *corners_;
}

Status PlaceVerifier::store(std::int64_t view) {
  if (!canMeasure() || frame_->right.empty()) return Status::ok();
  if (store_.nearest(view, settings_.spacing - 1)) return Status::ok();
  const landmarks::Landmarks found = landmarks::findLandmarks(
      landmarks::grayOf(frame_->left), landmarks::grayOf(frame_->right), rig_, corners());
  const bool enough = static_cast<int>(found.points.size()) >= settings_.least_agreeing;
  return enough ? store_.add(view, found) : Status::ok();
}

std::optional<std::int64_t> PlaceVerifier::viewNear(std::int64_t view) const {
  return canMeasure() ? store_.nearest(view, settings_.spacing) : std::nullopt;
}

Result<std::optional<landmarks::MeasuredPose>> PlaceVerifier::locate(std::int64_t view) {
  const auto stored = store_.read(view);
  if (!stored.isOk()) return stored.status();
  return landmarks::poseOf(landmarks::findAgain(stored.value(), corners()), rig_.pinhole,
                           settings_.least_agreeing);
}

}  // namespace tolman::view_sequences
