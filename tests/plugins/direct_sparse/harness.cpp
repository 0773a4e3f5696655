// SPDX-License-Identifier: BSD-3-Clause
#include "harness.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "street.hpp"

namespace tolman::test {

Host::Host(const CameraRig& rig, ParameterValues values, direct_sparse::Cameras cameras)
    : services_(std::move(values), 7), plugin_(cameras) {
  services_.rig = rig;
  configured_ = plugin_.configure(services_);
}

Motion Host::track(const Frame& frame) {
  Motion motion;
  const Status status = plugin_.track(frame, motion);
  if (!status.isOk()) throw std::runtime_error(status.message());
  if (!firstInvalidField(motion).empty()) throw std::runtime_error(firstInvalidField(motion));
  motions_.push_back(motion.T_previous_current);
  apply(motion.revisions);
  return motion;
}

void Host::finish() {
  std::vector<MotionRevision> revisions;
  const Status status = plugin_.finish(revisions);
  if (!status.isOk()) throw std::runtime_error(status.message());
  apply(revisions);
}

void Host::apply(const std::vector<MotionRevision>& revisions) {
  for (const MotionRevision& revision : revisions) {
    motions_.at(static_cast<std::size_t>(revision.frame)) = revision.T_previous_current;
  }
}

std::vector<Eigen::Isometry3d> Host::trajectory() const {
  std::vector<Eigen::Isometry3d> poses;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (const Eigen::Isometry3d& motion : motions_) poses.push_back(pose = pose * motion);
  return poses;
}

double Host::length() const {
  double metres = 0;
  for (const Eigen::Isometry3d& motion : motions_) metres += motion.translation().norm();
  return metres;
}

Frame again(const Frame& frame, std::int64_t index) {
  Frame copy = frame;
  copy.frame = index;
  copy.stamp_ns = index * 100'000'000;
  return copy;
}

Image changed(const Image& image, double gain, double offset) {
  return Image::create(image.width(), image.height(), PixelFormat::Gray8, [&](std::uint8_t* data) {
    for (int v = 0; v < image.height(); ++v) {
      for (int u = 0; u < image.width(); ++u) {
        const double value = std::clamp(gain * image.row(v)[u] + offset, 0.0, 255.0);
        *data++ = static_cast<std::uint8_t>(std::lround(value));
      }
    }
  });
}

Image filled(int grey) {
  const CameraRig rig = streetRig();
  return Image::create(rig.width, rig.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    std::fill_n(data, rig.width * rig.height, static_cast<std::uint8_t>(grey));
  });
}

}  // namespace tolman::test
