// SPDX-License-Identifier: BSD-3-Clause
#include "conformance/checks_input.hpp"

#include <array>
#include <cstring>

#include "conformance/check.hpp"

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

// Faults of real data: images that are missing, without texture or of odd size, lost tracking,
// dropped frames, one camera.

namespace {

using Fault = void (*)(InputSequence&);

/// Legal input must be answered.
template <Fault kFault>
void checkAnswered(CheckContext& context) {
  InputSequence sequence = context.sequence();
  kFault(sequence);
  context.runOnce(sequence);
}

/// Illegal input may be refused frame by frame; the instance must stay usable.
void requireSurvival(CheckContext& context, const InputSequence& sequence) {
  const auto instance = context.configured(sequence.rig);
  std::size_t refused = 0;
  for (const FrameInput& input : sequence.inputs)
    refused += instance->process(input).isOk() ? 0 : 1;
  (void)instance->finish(sequence);
  context.require(instance->reset(), "after illegal input");
  context.require(instance->destroy(), "after illegal input");
  context.note(std::to_string(refused) + " of " + std::to_string(sequence.inputs.size()) +
               " frames refused");
}

template <Fault kFault>
void checkSurvived(CheckContext& context) {
  InputSequence sequence = context.sequence();
  kFault(sequence);
  requireSurvival(context, sequence);
}

/// configure() may refuse the rig; if it does not, the frames must be answered.
void requireAnswersOrRefusal(CheckContext& context, const InputSequence& sequence,
                             const std::string& when) {
  TestInstance instance(context.completePlugin());
  const Status status = instance.configure(sequence.rig);
  if (!status.isOk()) {
    const bool refused = status.code() == StatusCode::Unsupported ||
                         status.code() == StatusCode::InvalidInput ||
                         status.code() == StatusCode::InvalidParameter;
    if (!refused) context.error(when + ": " + status.message(), "return Status::unsupported()");
    return;
  }
  context.require(instance.run(sequence), when);
  context.require(instance.finish(sequence), when);
}

void checkEmpty(CheckContext& context) {
  InputSequence sequence = context.sequence();
  removeImages(sequence);
  context.runOnce(sequence, "some frames without images");
  for (FrameInput& input : sequence.inputs) {
    input.frame.left = input.frame.right = Image();
    input.frame.defect = "the file is damaged";
  }
  context.runOnce(sequence, "no frame with an image");
}

void checkSkippedStages(CheckContext& context) {
  checkAnswered<loseTracking>(context);
  checkAnswered<loseFirstFrames>(context);
}

SequenceOptions shortSequence(CheckContext& context) {
  SequenceOptions options = context.sequenceOptions();
  options.frames = 8;
  return options;
}

void checkSizes(CheckContext& context) {
  SequenceOptions options = shortSequence(context);
  for (const auto& [width, height] : {std::pair(161, 61), std::pair(16, 8), std::pair(1, 1)}) {
    options.width = width;
    options.height = height;
    requireAnswersOrRefusal(context, makeSequence(options),
                            std::to_string(width) + "x" + std::to_string(height) + " px");
  }
}

void checkColour(CheckContext& context) {
  SequenceOptions options = shortSequence(context);
  options.format = PixelFormat::Bgr8;
  requireSurvival(context, makeSequence(options));
}

void checkRigs(CheckContext& context) {
  SequenceOptions options = shortSequence(context);
  options.stereo = false;
  InputSequence sequence = makeSequence(options);
  requireAnswersOrRefusal(context, sequence, "one camera");
  sequence.rig.calibrated = false;
  sequence.rig.pinhole = {};
  requireAnswersOrRefusal(context, sequence, "one camera, not calibrated");
  for (FrameInput& input : sequence.inputs) input.frame.left = Image();
  sequence.rig = {};
  requireAnswersOrRefusal(context, sequence, "no camera (a motion log)");
}

constexpr std::array kInputChecks = {
    Check{"frames-empty", 1, kWithImages, "frames without images are answered, not failed",
          "an empty image is legal: answer Lost or None", &checkEmpty},
    Check{"frames-plain", 1, kWithImages, "images without texture are answered",
          "answer Lost or None; do not divide by a sum that can be zero",
          &checkAnswered<makeTextureless>},
    Check{"skipped-stages", 1, kWithInput,
          "lost tracking and the default records of skipped stages are answered",
          "Lost, None and Stay are legal from the first frame on", &checkSkippedStages},
    Check{"frames-dropped", 1, kWithInput, "frames may be left out, as under `realtime`",
          "frame.frame may increase by more than one", &checkAnswered<dropFrames>},
    Check{"rig-sizes", 1, kWithImages, "odd and tiny images are answered, or the rig is refused",
          "refuse images that are too small in configure()", &checkSizes},
    Check{"rig-kinds", 1, kWithInput,
          "one camera, no calibration, no camera: answered, or refused in configure()",
          "test context.rig in configure() and return Status::unsupported()", &checkRigs},
    Check{"colour", 1, kWithImages, "colour images cause no crash", "test image.format()",
          &checkColour},
    Check{"no-right-image", 1, kWithImages, "a missing right image causes no crash",
          "test whether frame.right is empty", &checkSurvived<removeRightImages>},
    Check{"wrong-sizes", 1, kWithImages, "an image of another size causes no crash",
          "compare the size with the rig's, and return Status::invalidInput()",
          &checkSurvived<resizeImages>},
    Check{"time-order", 1, kWithInput, "stamps that repeat or decrease cause no crash",
          "return Status::invalidInput() for a stamp that is not later",
          &checkSurvived<reverseStamps>},
};

}  // namespace

std::span<const Check> inputChecks() { return kInputChecks; }

}  // namespace tolman::conformance
