// SPDX-License-Identifier: BSD-3-Clause
// What tolman init writes about a recording, without reading one.
#include "app/init_text.hpp"

#include <catch2/catch.hpp>

using namespace tolman::app;
using Catch::Contains;

namespace {

Probe pairOf(double baseline) {
  Probe probe;
  probe.plugin = "boxes";
  probe.values = {{"path", "/data/boxes"}};
  probe.description = "20 pairs of boxes";
  probe.width = 640;
  probe.height = 480;
  probe.calibrated = true;
  probe.baseline = baseline;
  return probe;
}

Probe singleOf(int width, int height) {
  Probe probe = pairOf(0);
  probe.width = width;
  probe.height = height;
  return probe;
}

Probe withDepth() {
  Probe probe = singleOf(640, 480);
  probe.depth = true;
  return probe;
}

std::string textOf(const Probe& probe, CarriedBy told = CarriedBy::Unknown,
                   const std::string& recording = "/data/boxes") {
  RecordingSearch search;
  search.best = probe;
  search.others = {"crates"};
  return initText(recording, search, told, "odometry: {plugin: x}\n");
}

}  // namespace

TEST_CASE("what carries a camera is guessed by its baseline, or by the shape of its images") {
  CHECK(guessCarrier(pairOf(0.54)) == CarriedBy::Car);
  CHECK(guessCarrier(pairOf(0.11)) == CarriedBy::Hand);
  CHECK(guessCarrier(singleOf(1241, 376)) == CarriedBy::Car);
  CHECK(guessCarrier(singleOf(640, 480)) == CarriedBy::Hand);
}

TEST_CASE("the stages fit to the cameras") {
  CHECK(stagesFile(pairOf(0.1), CarriedBy::Toy) == "toy_stereo.yaml");
  CHECK(stagesFile(singleOf(640, 480), CarriedBy::Hand) == "hand_mono.yaml");
  CHECK(stagesFile(withDepth(), CarriedBy::Hand) == "hand_rgbd.yaml");
  Probe uncalibrated = singleOf(640, 480);
  uncalibrated.calibrated = false;
  CHECK(stagesFile(uncalibrated, CarriedBy::Car) == "uncalibrated.yaml");
  CHECK(stagesFile(singleOf(0, 0), CarriedBy::Car) == "motion.yaml");
}

TEST_CASE("calibrated pairs go before single cameras, and those before uncalibrated ones") {
  Probe uncalibrated = singleOf(640, 480);
  uncalibrated.calibrated = false;
  CHECK(pairOf(0.1).rank() > singleOf(640, 480).rank());
  CHECK(pairOf(0.1).rank() > withDepth().rank());
  CHECK(withDepth().rank() > singleOf(640, 480).rank());
  CHECK(singleOf(640, 480).rank() > uncalibrated.rank());
  Probe motion = uncalibrated;
  motion.width = 0;
  CHECK(uncalibrated.rank() > motion.rank());
}

TEST_CASE("the scale of one camera is not known, but for one with depth images") {
  CHECK_THAT(textOf(singleOf(640, 480)), Contains("the scale: lengths of one camera"));
  CHECK_THAT(textOf(withDepth()), !Contains("the scale"));
}

TEST_CASE("folders of images that are not read are named") {
  RecordingSearch search;
  search.best = pairOf(0.11);
  CHECK_THAT(initText("/data/boxes", search, CarriedBy::Car, ""), !Contains("which camera"));
  search.other_folders = {"rear", "roof/images"};
  CHECK_THAT(initText("/data/boxes", search, CarriedBy::Car, ""),
             Contains("#   - which camera: there are images also in rear, roof/images "
                      "(source.left, source.right)\n"));
}

TEST_CASE("the text has the source, the stages, and what is not known") {
  const std::string guessed = textOf(pairOf(0.11));
  CHECK_THAT(guessed, Contains("# 20 pairs of boxes\n# Not known:\n"));
  CHECK_THAT(guessed, Contains("'hand' is guessed, from the baseline"));
  CHECK_THAT(guessed, Contains("the true path"));
  CHECK_THAT(guessed, Contains("# Read also by the source crates.\n"));
  CHECK_THAT(guessed, Contains("name: boxes\n\nsource:\n  plugin: boxes\n  path: /data/boxes\n"));
  CHECK_THAT(guessed, Catch::EndsWith("\nodometry: {plugin: x}\n"));
  Probe known = pairOf(0.11);
  known.has_truth = true;
  CHECK_THAT(textOf(known, CarriedBy::Car), !Contains("Not known"));
  CHECK_THAT(textOf(singleOf(640, 480)), Contains("arbitrary units"));
}

TEST_CASE("what the source warns of is told") {
  CHECK_THAT(textOf(pairOf(0.11)), !Contains("Warnings"));
  Probe dark = pairOf(0.11);
  dark.warnings = {"source: images: set source.bits=10"};
  CHECK_THAT(textOf(dark), Contains("# Warnings:\n#   - source: images: set source.bits=10\n"));
}

TEST_CASE("a camera is read in real time") {
  CHECK_THAT(textOf(pairOf(0.11), CarriedBy::Hand, "/dev/null"),
             Contains("\npipeline:\n  mode: realtime "));
  CHECK_THAT(textOf(pairOf(0.11), CarriedBy::Hand, "/"), !Contains("pipeline"));
}

TEST_CASE("a fast recording is thinned, and large images are scaled") {
  Probe fast = pairOf(0.11);
  fast.rate = 120;
  const auto recorded = [](const Probe& probe) {
    return textOf(probe, CarriedBy::Unknown, "/usr");
  };
  CHECK_THAT(recorded(fast), Contains("  path: /data/boxes\n  step: 4 ") &&
                                 Contains("# of 120 frames a second 30 are used\n"));
  CHECK_THAT(recorded(fast), !Contains("images:"));
  CHECK_THAT(textOf(fast, CarriedBy::Unknown, "/dev/zero"), !Contains("step:"));  // a live one
  fast.values.emplace_back("step", "2");
  CHECK_THAT(recorded(fast), !Contains("step: 4"));
  Probe usual = pairOf(0.11);
  for (const double rate : {0.0, 10.0, 20.0, 30.0, 45.0}) {
    usual.rate = rate;
    CHECK_THAT(recorded(usual), !Contains("step:"));
  }
  Probe large = singleOf(1920, 1080);
  CHECK_THAT(recorded(large), Contains("\nimages:\n  scale: 0.50 ") && Contains("1920x1080 px"));
  large = singleOf(3840, 2160);
  CHECK_THAT(recorded(large), Contains("  scale: 0.25 "));
  CHECK_THAT(recorded(singleOf(1280, 720)), !Contains("images:"));
}
