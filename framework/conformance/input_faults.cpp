// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/input_faults.hpp"

#include <cstring>

namespace tolman::conformance {
namespace {

/// Frames 3, 4, 10, 17, 18, 24, ...: single ones and pairs.
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

Image uniform(int width, int height, PixelFormat format, int grey) {
  const auto bytes =
      static_cast<std::size_t>(std::ptrdiff_t{width} * height * bytesPerPixel(format));
  return Image::create(width, height, format,
                       [&](std::uint8_t* data) { std::memset(data, grey, bytes); });
}

/// Replaces the answers to one frame by substitutes such as later stages get after a skipped stage.
void replaceSkipped(FrameInput& input, std::int64_t experience) {
  Motion& motion = input.motion;
  motion.state = motion.frame == 0 ? TrackingState::Initialising : TrackingState::Lost;
  motion.covariance *= 100;
  motion.tracked = 0;
  motion.is_keyframe = false;
  motion.points_frame = -1;
  motion.points.resize(4, 0);
  motion.revisions.clear();
  PlaceObservation none;
  none.frame = input.frame.frame;
  none.stamp_ns = input.frame.stamp_ns;
  input.place = none;
  const double heading = input.decision.heading;
  input.decision = Decision();
  input.decision.frame = input.frame.frame;
  input.decision.stamp_ns = input.frame.stamp_ns;
  input.decision.experience = experience;
  input.decision.heading = heading;
  input.decision.confidence = 0;
}

}  // namespace

void removeImages(InputSequence& sequence) {
  std::vector<FrameInput>& inputs = sequence.inputs;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!isChosen(i) && i + 2 < inputs.size()) continue;
    inputs[i].frame.left = inputs[i].frame.right = Image();
    inputs[i].frame.defect = "the file is damaged";
  }
}

void loseTracking(InputSequence& sequence) {
  std::int64_t experience = -1;
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    FrameInput& input = sequence.inputs[i];
    const bool makes_experience = input.decision.action == Action::CreateExperience;
    const bool makes_template = input.place.recognition == Recognition::Novel;
    const bool stays = input.decision.action == Action::Stay;
    if (stays &&
        input.decision.experience != experience) {  // the frame with its loop closure was skipped
      input.decision.action = Action::CloseLoop;
    }
    if (isChosen(i) && !makes_experience && !makes_template) {
      replaceSkipped(input, experience);
    } else if (isChosen(i)) {
      input.motion.state = TrackingState::Lost;
      input.motion.covariance *= 100;
    }
    experience = input.decision.experience;
  }
}

void loseFirstFrames(InputSequence& sequence) {
  if (sequence.inputs.size() < 3) return;
  const PlaceObservation first_place = sequence.inputs[0].place;
  const Decision first_decision = sequence.inputs[0].decision;
  FrameInput& third = sequence.inputs[2];
  for (std::size_t i = 0; i < 2; ++i) replaceSkipped(sequence.inputs[i], -1);
  third.place = first_place;
  third.decision = first_decision;
  third.place.frame = third.decision.frame = third.frame.frame;
  third.place.stamp_ns = third.decision.stamp_ns = third.frame.stamp_ns;
}

void dropFrames(InputSequence& sequence) {
  std::vector<FrameInput> kept;
  Eigen::Isometry3d T_dropped = Eigen::Isometry3d::Identity();
  double dt = 0;
  for (std::size_t i = 0; i < sequence.inputs.size(); ++i) {
    FrameInput& input = sequence.inputs[i];
    T_dropped = T_dropped * input.motion.T_previous_current;
    dt += input.motion.dt;
    const bool needed = input.decision.action == Action::CreateExperience ||
                        input.place.recognition == Recognition::Novel;
    if (isChosen(i) && !needed) continue;
    input.motion.T_previous_current = T_dropped;
    input.motion.revisions.clear();  // they may refer to frames that were left out
    input.decision.earlier.clear();
    setPlanarVelocity(input.motion, dt);
    T_dropped.setIdentity();
    dt = 0;
    kept.push_back(std::move(input));
  }
  sequence.inputs = std::move(kept);
  sequence.last_revisions.clear();
}

void padRows(InputSequence& sequence) {
  for (FrameInput& input : sequence.inputs) {
    input.frame.left = padded(input.frame.left);
    input.frame.right = padded(input.frame.right);
  }
}

void makeTextureless(InputSequence& sequence) {
  const CameraRig& rig = sequence.rig;
  for (FrameInput& input : sequence.inputs) {
    for (Image* image : {&input.frame.left, &input.frame.right}) {
      const int grey = input.frame.frame % 2 == 0 ? 0 : 255;
      if (!image->empty()) *image = uniform(rig.width, rig.height, image->format(), grey);
    }
  }
}

void removeRightImages(InputSequence& sequence) {
  for (FrameInput& input : sequence.inputs) input.frame.right = Image();
}

void resizeImages(InputSequence& sequence) {
  for (std::size_t i = 2; i < sequence.inputs.size(); i += 3) {
    Frame& frame = sequence.inputs[i].frame;
    const int shrink = i % 2 == 0 ? 17 : -9;
    for (Image* image : {&frame.left, &frame.right}) {
      if (image->empty()) continue;
      *image = uniform(image->width() - shrink, image->height() + shrink, image->format(), 90);
    }
  }
}

void reverseStamps(InputSequence& sequence) {
  for (std::size_t i = 2; i < sequence.inputs.size(); i += 3) {
    FrameInput& input = sequence.inputs[i];
    const std::int64_t back_ns = i % 2 == 0 ? 100'000'000 : 5'000'000'000;
    for (std::int64_t* stamp : {&input.frame.stamp_ns, &input.motion.stamp_ns,
                                &input.place.stamp_ns, &input.decision.stamp_ns}) {
      *stamp -= back_ns;
    }
    input.motion.dt = i % 2 == 0 ? 0 : -4.9;
  }
}

}  // namespace tolman::conformance
