// SPDX-License-Identifier: BSD-3-Clause
// Faults of real data: images that are missing, without texture or of odd size, lost tracking,
// dropped frames, one camera.
#include <array>

#include "conformance/check.hpp"
#include "conformance/test_instance.hpp"

namespace tolman::conformance {
namespace {

using Fault = void (*)(InputSequence&);

/// Legal input must be answered.
template <Fault kFault>
void checkAnswered(CheckContext& context) {
  InputSequence sequence = context.sequence();
  kFault(sequence);
  context.runOnce(sequence);
}

/// configure() may refuse the rig; if it does not, the frames must be answered.
void requireAnswersOrRefusal(CheckContext& context, const InputSequence& sequence,
                             const std::string& when) {
  const auto instance = TestInstance::make(context.completePlugin());
  const Status status = instance->configure(sequence.rig);
  if (!status.isOk()) {
    if (!isRefusal(status)) {
      context.error(when + ": " + status.message(), "return Status::unsupported()");
    }
    return;
  }
  context.require(instance->run(sequence), when);
  context.require(instance->finish(sequence), when);
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
          "Lost, None and Stay are legal from the first frame on", &checkAnswered<loseTracking>},
    Check{"frames-dropped", 1, kWithInput, "frames may be left out, as under `realtime`",
          "frame.frame may increase by more than one", &checkAnswered<dropFrames>},
    Check{"rig-sizes", 1, kWithImages, "odd and tiny images are answered, or the rig is refused",
          "refuse images that are too small in configure()", &checkSizes},
    Check{"rig-kinds", 1, kWithInput,
          "one camera, no calibration, no camera: answered, or refused in configure()",
          "test context.rig in configure() and return Status::unsupported()", &checkRigs},
};

}  // namespace

std::span<const Check> inputChecks() { return kInputChecks; }

}  // namespace tolman::conformance
