// SPDX-License-Identifier: BSD-3-Clause
// How reality spoils a stimulus.
#include <cstring>

#include "conformance/stimulus.hpp"

namespace tolman::conformance {
namespace {

/// Frames 3, 4, 10, 17, 18, 24, ...: alone and in pairs.
bool isChosen(std::size_t index) { return index % 14 == 3 || index % 14 == 4 || index % 14 == 10; }

Image padded(const Image& image) {
  if (image.empty()) return image;
  const auto row_bytes =
      static_cast<std::size_t>(std::ptrdiff_t{image.width()} * bytesPerPixel(image.format()));
  const std::size_t stride = row_bytes + 37;
  const auto rows = static_cast<std::size_t>(image.height());
  const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[stride * rows]);
  std::memset(pixels.get(), 0xee, stride * rows);
  for (int r = 0; r < image.height(); ++r) {
    std::memcpy(pixels.get() + static_cast<std::size_t>(r) * stride, image.row(r), row_bytes);
  }
  return {pixels.get(),   image.width(), image.height(), static_cast<std::ptrdiff_t>(stride),
          image.format(), pixels};
}

Image plain(int width, int height, PixelFormat format, int grey) {
  const auto bytes =
      static_cast<std::size_t>(std::ptrdiff_t{width} * height * bytesPerPixel(format));
  return Image::create(width, height, format,
                       [&](std::uint8_t* data) { std::memset(data, grey, bytes); });
}

/// What the host gives to later stages when a stage was skipped.
void standIn(Moment& moment, std::int64_t experience) {
  Motion& motion = moment.motion;
  motion.state = motion.frame == 0 ? TrackingState::Initialising : TrackingState::Lost;
  motion.covariance *= 100;
  motion.tracked = 0;
  motion.is_keyframe = false;
  motion.points_frame = -1;
  motion.points.resize(4, 0);
  motion.revisions.clear();
  PlaceObservation nothing;
  nothing.frame = moment.frame.frame;
  nothing.stamp_ns = moment.frame.stamp_ns;
  moment.place = nothing;
  const double heading = moment.decision.heading;
  moment.decision = Decision();
  moment.decision.frame = moment.frame.frame;
  moment.decision.stamp_ns = moment.frame.stamp_ns;
  moment.decision.experience = experience;
  moment.decision.heading = heading;
  moment.decision.confidence = 0;
}

}  // namespace

void loseImages(Stimulus& stimulus) {
  std::vector<Moment>& moments = stimulus.moments;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (!isChosen(i) && i + 2 < moments.size()) continue;
    moments[i].frame.left = moments[i].frame.right = Image();
    moments[i].frame.defect = "the file is damaged";
  }
}

void loseTracking(Stimulus& stimulus) {
  std::int64_t experience = -1;
  for (std::size_t i = 0; i < stimulus.moments.size(); ++i) {
    Moment& moment = stimulus.moments[i];
    const bool makes_experience = moment.decision.action == Action::CreateExperience;
    const bool makes_template = moment.place.recognition == Recognition::Novel;
    const bool stays = moment.decision.action == Action::Stay;
    if (stays && moment.decision.experience != experience) {  // its loop closure was lost
      moment.decision.action = Action::CloseLoop;
    }
    if (isChosen(i) && !makes_experience && !makes_template) {
      standIn(moment, experience);
    } else if (isChosen(i)) {
      moment.motion.state = TrackingState::Lost;
      moment.motion.covariance *= 100;
    }
    experience = moment.decision.experience;
  }
}

void startBlind(Stimulus& stimulus) {
  if (stimulus.moments.size() < 3) return;
  const PlaceObservation first_view = stimulus.moments[0].place;
  const Decision first_decision = stimulus.moments[0].decision;
  Moment& third = stimulus.moments[2];
  for (std::size_t i = 0; i < 2; ++i) standIn(stimulus.moments[i], -1);
  third.place = first_view;
  third.decision = first_decision;
  third.place.frame = third.decision.frame = third.frame.frame;
  third.place.stamp_ns = third.decision.stamp_ns = third.frame.stamp_ns;
}

void dropFrames(Stimulus& stimulus) {
  std::vector<Moment> kept;
  Eigen::Isometry3d T_last_dropped = Eigen::Isometry3d::Identity();
  double dt = 0;
  for (std::size_t i = 0; i < stimulus.moments.size(); ++i) {
    Moment& moment = stimulus.moments[i];
    T_last_dropped = T_last_dropped * moment.motion.T_previous_current;
    dt += moment.motion.dt;
    const bool needed = moment.decision.action == Action::CreateExperience ||
                        moment.place.recognition == Recognition::Novel;
    if (isChosen(i) && !needed) continue;
    moment.motion.T_previous_current = T_last_dropped;
    moment.motion.revisions.clear();  // they may speak of frames that nobody saw
    setPlanarVelocity(moment.motion, dt);
    T_last_dropped.setIdentity();
    dt = 0;
    kept.push_back(std::move(moment));
  }
  stimulus.moments = std::move(kept);
  stimulus.last_revisions.clear();
}

void padRows(Stimulus& stimulus) {
  for (Moment& moment : stimulus.moments) {
    moment.frame.left = padded(moment.frame.left);
    moment.frame.right = padded(moment.frame.right);
  }
}

void blind(Stimulus& stimulus) {
  const CameraRig& rig = stimulus.rig;
  for (Moment& moment : stimulus.moments) {
    for (Image* image : {&moment.frame.left, &moment.frame.right}) {
      const int grey = moment.frame.frame % 2 == 0 ? 0 : 255;
      if (!image->empty()) *image = plain(rig.width, rig.height, image->format(), grey);
    }
  }
}

void loseRightImages(Stimulus& stimulus) {
  for (Moment& moment : stimulus.moments) moment.frame.right = Image();
}

void resizeImages(Stimulus& stimulus) {
  for (std::size_t i = 2; i < stimulus.moments.size(); i += 3) {
    Frame& frame = stimulus.moments[i].frame;
    const int shrink = i % 2 == 0 ? 17 : -9;
    for (Image* image : {&frame.left, &frame.right}) {
      if (image->empty()) continue;
      *image = plain(image->width() - shrink, image->height() + shrink, image->format(), 90);
    }
  }
}

void turnBackTime(Stimulus& stimulus) {
  for (std::size_t i = 2; i < stimulus.moments.size(); i += 3) {
    Moment& moment = stimulus.moments[i];
    const std::int64_t back_ns = i % 2 == 0 ? 100'000'000 : 5'000'000'000;
    for (std::int64_t* stamp : {&moment.frame.stamp_ns, &moment.motion.stamp_ns,
                                &moment.place.stamp_ns, &moment.decision.stamp_ns}) {
      *stamp -= back_ns;
    }
    moment.motion.dt = i % 2 == 0 ? 0 : -4.9;
  }
}

}  // namespace tolman::conformance
