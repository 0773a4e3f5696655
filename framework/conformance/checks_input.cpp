// SPDX-License-Identifier: BSD-3-Clause
// Frames as reality gives them: missing, plain, odd, late, from one camera.
#include <array>

#include "conformance/check.hpp"
#include "conformance/lab.hpp"

namespace tolman::conformance {
namespace {

/// Legal input has answers.
void demandAnswers(Lab& lab, const Stimulus& stimulus, const std::string& when) {
  const auto actor = lab.living(stimulus.rig);
  lab.demand(actor->run(stimulus), when);
  lab.demand(actor->finish(stimulus), when);
  lab.demand(actor->destroy(), when);
}

/// A rig that a plugin may refuse; what it accepts it must master.
void demandAnswersUnlessRefused(Lab& lab, const Stimulus& stimulus, const std::string& when) {
  Actor actor(lab.complete());
  const Status status = actor.configure(stimulus.rig);
  if (!status.isOk()) {
    const bool clean = status.code() == StatusCode::Unsupported ||
                       status.code() == StatusCode::InvalidInput ||
                       status.code() == StatusCode::InvalidParameter;
    if (!clean) lab.error(when + ": " + status.message(), "refuse it with Status::unsupported()");
    return;
  }
  lab.demand(actor.run(stimulus), when);
  lab.demand(actor.finish(stimulus), when);
}

/// Illegal input may be refused frame by frame; the instance lives on.
void demandSurvival(Lab& lab, const Stimulus& stimulus) {
  const auto actor = lab.living(stimulus.rig);
  std::size_t refused = 0;
  for (const Moment& moment : stimulus.moments) refused += actor->work(moment).isOk() ? 0 : 1;
  (void)actor->finish(stimulus);
  lab.demand(actor->reset(), "after illegal input");
  lab.demand(actor->destroy(), "after illegal input");
  lab.note(std::to_string(refused) + " of " + std::to_string(stimulus.moments.size()) +
           " frames refused");
}

void checkEmpty(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  loseImages(stimulus);
  demandAnswers(lab, stimulus, "some frames without images");
  for (Moment& moment : stimulus.moments) {
    moment.frame.left = moment.frame.right = Image();
    moment.frame.defect = "the file is damaged";
  }
  demandAnswers(lab, stimulus, "no frame with an image");
}

void checkPlain(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  blind(stimulus);
  demandAnswers(lab, stimulus, "black and white images without texture");
}

void checkStandIns(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  loseTracking(stimulus);
  demandAnswers(lab, stimulus, "lost tracking and skipped stages");
  stimulus = lab.stimulus();
  startBlind(stimulus);
  demandAnswers(lab, stimulus, "lost from the start");
}

void checkGaps(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  dropFrames(stimulus);
  demandAnswers(lab, stimulus, "frames left out");
}

void checkSizes(Lab& lab) {
  StimulusOptions options = lab.stimulusOptions();
  options.frames = 8;
  for (const auto& [width, height] : {std::pair(161, 61), std::pair(16, 8), std::pair(1, 1)}) {
    options.width = width;
    options.height = height;
    demandAnswersUnlessRefused(lab, makeStimulus(options),
                               std::to_string(width) + "x" + std::to_string(height) + " px");
  }
}

void checkColour(Lab& lab) {
  StimulusOptions options = lab.stimulusOptions();
  options.frames = 8;
  options.format = PixelFormat::Bgr8;
  demandSurvival(lab, makeStimulus(options));
}

void checkRigs(Lab& lab) {
  StimulusOptions options = lab.stimulusOptions();
  options.frames = 8;
  options.stereo = false;
  Stimulus stimulus = makeStimulus(options);
  demandAnswersUnlessRefused(lab, stimulus, "one camera");
  stimulus.rig.calibrated = false;
  stimulus.rig.pinhole = {};
  demandAnswersUnlessRefused(lab, stimulus, "one camera, not calibrated");
  for (Moment& moment : stimulus.moments) moment.frame.left = Image();
  stimulus.rig = {};
  demandAnswersUnlessRefused(lab, stimulus, "no camera (a motion log)");
}

void checkOneEye(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  loseRightImages(stimulus);
  demandSurvival(lab, stimulus);
}

void checkWrongSizes(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  resizeImages(stimulus);
  demandSurvival(lab, stimulus);
}

void checkTime(Lab& lab) {
  Stimulus stimulus = lab.stimulus();
  turnBackTime(stimulus);
  demandSurvival(lab, stimulus);
}

constexpr std::array kChecks = {
    Check{"frames-empty", 1, kSeeing, "empty images are answered, not failed",
          "an empty image is legal: answer Lost or None", &checkEmpty},
    Check{"frames-plain", 1, kSeeing, "images without texture are answered",
          "answer Lost or what you know; divide by no sum that can be zero", &checkPlain},
    Check{"stand-ins", 1, kFed, "lost tracking and the stand-ins of skipped stages are answered",
          "Lost, None and Stay are legal from the first frame on", &checkStandIns},
    Check{"frames-dropped", 1, kFed, "frames may be left out, as under `realtime`",
          "frame.frame may jump: count nothing on it", &checkGaps},
    Check{"rig-sizes", 1, kSeeing, "odd and tiny images are answered, or the rig is refused",
          "refuse in configure() what is too small", &checkSizes},
    Check{"rig-kinds", 1, kFed,
          "one camera, no calibration, no camera: answered, or refused in configure()",
          "look at context.rig in configure() and return Status::unsupported()", &checkRigs},
    Check{"colour", 1, kSeeing, "colour images bring nobody down", "ask image.format()",
          &checkColour},
    Check{"one-eye", 1, kSeeing, "a right image that is missing brings nobody down",
          "look whether frame.right is empty", &checkOneEye},
    Check{"wrong-sizes", 1, kSeeing, "an image of another size brings nobody down",
          "compare the size with the rig's, and return Status::invalidInput()", &checkWrongSizes},
    Check{"time-order", 1, kFed, "time that stands still or goes back brings nobody down",
          "return Status::invalidInput() for a stamp that is not later", &checkTime},
};

}  // namespace

std::span<const Check> inputChecks() { return kChecks; }

}  // namespace tolman::conformance
