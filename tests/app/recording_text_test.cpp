// SPDX-License-Identifier: BSD-3-Clause
// What tolman init writes about a recording, without reading one.
#include <catch2/catch.hpp>

#include "app/recording.hpp"

using namespace tolman::app;
using Catch::Contains;

namespace {

Recording pairOf(double baseline) {
  Recording recording;
  recording.plugin = "boxes";
  recording.values = {{"path", "/data/boxes"}};
  recording.description = "20 pairs of boxes";
  recording.width = 640;
  recording.height = 480;
  recording.calibrated = true;
  recording.baseline = baseline;
  return recording;
}

Recording singleOf(int width, int height) {
  Recording recording = pairOf(0);
  recording.width = width;
  recording.height = height;
  return recording;
}

Recording withDepth() {
  Recording recording = singleOf(640, 480);
  recording.depth = true;
  return recording;
}

std::string textOf(const Recording& recording, const std::string& carrier = "",
                   const std::string& path = "/data/boxes") {
  return initText(path, recording, carrier, "odometry: {plugin: x}\n");
}

}  // namespace

TEST_CASE("what carries a camera is guessed by its baseline, or by the shape of its images") {
  CHECK(guessCarrier(pairOf(0.54)) == "car");
  CHECK(guessCarrier(pairOf(0.11)) == "hand");
  CHECK(guessCarrier(singleOf(1241, 376)) == "car");
  CHECK(guessCarrier(singleOf(640, 480)) == "hand");
}

TEST_CASE("the stages fit to the cameras") {
  CHECK(stagesFile(pairOf(0.1), "toy") == "toy_stereo.yaml");
  CHECK(stagesFile(singleOf(640, 480), "hand") == "hand_mono.yaml");
  CHECK(stagesFile(withDepth(), "hand") == "hand_rgbd.yaml");
  Recording uncalibrated = singleOf(640, 480);
  uncalibrated.calibrated = false;
  CHECK(stagesFile(uncalibrated, "car") == "uncalibrated.yaml");
  CHECK(stagesFile(singleOf(0, 0), "car") == "motion.yaml");
}

TEST_CASE("the scale of one camera is not known, but for one with depth images") {
  CHECK_THAT(textOf(singleOf(640, 480)), Contains("the scale: lengths of one camera"));
  CHECK_THAT(textOf(withDepth()), !Contains("the scale"));
}

TEST_CASE("what was not used is named") {
  Recording pair = pairOf(0.11);
  CHECK_THAT(textOf(pair, "car"), !Contains("which camera"));
  pair.other_folders = {"rear", "roof/images"};
  pair.unused = {"calib.txt:2: no number"};
  CHECK_THAT(textOf(pair, "car"),
             Contains("#   - which camera: there are images also in rear, roof/images "
                      "(source.left, source.right)\n#   - a file beside the images: calib.txt:2"));
}

TEST_CASE("the text has the source, the stages, and what is not known") {
  const std::string guessed = textOf(pairOf(0.11));
  CHECK_THAT(guessed, Contains("# 20 pairs of boxes\n# Not known:\n"));
  CHECK_THAT(guessed, Contains("'hand' is guessed, from the baseline"));
  CHECK_THAT(guessed, Contains("the true path"));
  CHECK_THAT(guessed, Contains("name: boxes\n\nsource:\n  plugin: boxes\n  path: /data/boxes\n"));
  CHECK_THAT(guessed, Catch::EndsWith("\nodometry: {plugin: x}\n"));
  Recording known = pairOf(0.11);
  known.has_truth = true;
  CHECK_THAT(textOf(known, "car"), !Contains("Not known"));
  CHECK_THAT(textOf(singleOf(640, 480)), Contains("arbitrary units"));
}

TEST_CASE("warnings of the source are repeated") {
  CHECK_THAT(textOf(pairOf(0.11)), !Contains("Warnings"));
  Recording dark = pairOf(0.11);
  dark.warnings = {"source: images: set source.bits=10"};
  CHECK_THAT(textOf(dark), Contains("# Warnings:\n#   - source: images: set source.bits=10\n"));
}

TEST_CASE("a camera is read in real time") {
  CHECK_THAT(textOf(pairOf(0.11), "hand", "/dev/null"), Contains("\npipeline:\n  mode: realtime "));
  CHECK_THAT(textOf(pairOf(0.11), "hand", "/"), !Contains("pipeline"));
}

TEST_CASE("a fast recording is thinned, and large images are scaled") {
  Recording fast = pairOf(0.11);
  fast.rate = 120;
  const auto recorded = [](const Recording& recording) { return textOf(recording, "", "/usr"); };
  CHECK_THAT(recorded(fast), Contains("  path: /data/boxes\n  step: 4 ") &&
                                 Contains("# of 120 frames a second 30 are used\n"));
  CHECK_THAT(recorded(fast), !Contains("images:"));
  CHECK_THAT(textOf(fast, "", "/dev/zero"), !Contains("step:"));  // a live one
  fast.values.emplace_back("step", "2");
  CHECK_THAT(recorded(fast), !Contains("step: 4"));
  Recording usual = pairOf(0.11);
  for (const double rate : {0.0, 10.0, 20.0, 30.0, 45.0}) {
    usual.rate = rate;
    CHECK_THAT(recorded(usual), !Contains("step:"));
  }
  Recording large = singleOf(1920, 1080);
  CHECK_THAT(recorded(large), Contains("\nimages:\n  scale: 0.50 ") && Contains("1920x1080 px"));
  large = singleOf(3840, 2160);
  CHECK_THAT(recorded(large), Contains("  scale: 0.25 "));
  CHECK_THAT(recorded(singleOf(1280, 720)), !Contains("images:"));
}
