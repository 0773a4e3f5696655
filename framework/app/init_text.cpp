// SPDX-License-Identifier: BSD-3-Clause
#include "app/init_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "config/nearest_name.hpp"
#include "config/scalars.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

// Chosen on the rigs of KITTI (0.54 m; 3.3 times as wide as high) and of EuRoC and TUM-VI (0.11 m
// and 0.10 m; 1.5 and 1 times).
constexpr double kWideBaseline = 0.3;  // m
constexpr int kWideImage = 2;          // times as wide as high

// All lengths of the stages are in metres and all times in seconds, so the frame rate affects only
// the cost and the motion between frames. Odometry was measured at 10 to 30 Hz (KITTI, EuRoC, TUM)
// and at 0.3 to 0.5 million pixels.
constexpr double kFastest = 45;  // Hz
constexpr double kUsual = 30;    // Hz
constexpr double kManyPixels = 1e6;
constexpr double kUsualPixels = 0.47e6;  // KITTI's
constexpr double kSmallestScale = 0.1;

std::string_view nameOf(CarriedBy carrier) {
  constexpr std::array<std::string_view, 4> kNames = {"unknown", "car", "hand", "toy"};
  return kNames.at(static_cast<std::size_t>(carrier));
}

std::string notKnown(const Probe& probe, const RecordingSearch& search, CarriedBy told,
                     CarriedBy used) {
  std::string text;
  const auto add = [&](const std::string& line) { text += "#   - " + line + "\n"; };
  if (!search.other_folders.empty()) {
    add("which camera: there are images also in " + config::listed(search.other_folders) +
        " (source.left, source.right)");
  }
  if (search.rate_assumed)
    add(fmt::format("the frame rate: {:.4g} Hz are assumed (source.rate)", probe.rate));
  for (const std::string& reason : search.unread_times) add("the times: " + reason);
  for (const std::string& reason : search.unread_calibrations) {
    add("the calibration could not be used: " + reason);
  }
  if (probe.width > 0 && !probe.calibrated) {
    add("the calibration: turns are right only with the right odometry.field_of_view, and lengths");
    text += "#     have an arbitrary scale\n";
  } else if (probe.width > 0) {
    if (probe.baseline == 0 && !probe.depth)
      add("the scale: lengths of one camera are in arbitrary units");
    if (told == CarriedBy::Unknown) {
      add(fmt::format("what carries the camera: '{}' is guessed, from the {}; `--motion` says it",
                      nameOf(used), probe.baseline > 0 ? "baseline" : "shape of the images"));
    }
  }
  if (!probe.has_truth) add("the true path: there will be no errors, only figures");
  return text;
}

bool isGiven(const Probe& probe, std::string_view name) {
  return std::ranges::any_of(probe.values, [&](const auto& value) { return value.first == name; });
}

/// The key `step` of the section `source`, for a recording that is faster than needed.
std::string stepText(const Probe& probe) {
  if (probe.width == 0 || probe.rate <= kFastest || isGiven(probe, "step")) return "";
  const double step = std::round(probe.rate / kUsual);
  return fmt::format("  step: {:<22.0f} # of {:.4g} frames a second {:.4g} are used\n", step,
                     probe.rate, probe.rate / step);
}

/// The section `images` with a `scale`, for large images.
std::string scaleText(const Probe& probe) {
  const double pixels = static_cast<double>(probe.width) * probe.height;
  if (pixels <= kManyPixels) return "";
  const double scale =
      std::max(kSmallestScale, std::round(20 * std::sqrt(kUsualPixels / pixels)) / 20);
  return fmt::format(
      "\nimages:\n  scale: {:<21.2f} # {}x{} px cost time and give odometry little\n", scale,
      probe.width, probe.height);
}

}  // namespace

CarriedBy guessCarrier(const Probe& probe) {
  const bool wide = probe.baseline > 0 ? probe.baseline >= kWideBaseline
                                       : probe.width >= kWideImage * probe.height;
  return wide ? CarriedBy::Car : CarriedBy::Hand;
}

std::string stagesFile(const Probe& probe, CarriedBy carrier) {
  if (probe.width == 0) return "motion.yaml";
  if (!probe.calibrated) return "uncalibrated.yaml";
  const char* cameras = probe.baseline > 0 ? "stereo" : probe.depth ? "rgbd" : "mono";
  return fmt::format("{}_{}.yaml", nameOf(carrier), cameras);
}

std::string initText(const fs::path& recording, const RecordingSearch& search, CarriedBy told,
                     const std::string& stages) {
  const Probe& probe = *search.best;
  const CarriedBy used = told == CarriedBy::Unknown ? guessCarrier(probe) : told;
  std::string text = "# Written by `tolman init`. Run it with `tolman run FILE`.\n";
  text += "# " + probe.description + "\n";
  const std::string unknown = notKnown(probe, search, told, used);
  if (!unknown.empty()) text += "# Not known:\n" + unknown;
  if (!probe.warnings.empty()) text += "# Warnings:\n";
  for (const std::string& warning : probe.warnings) text += "#   - " + warning + "\n";
  for (const std::string& other : search.others)
    text += "# Read also by the source " + other + ".\n";
  const fs::path name = recording.has_filename() ? recording : recording.parent_path();
  text += "name: " + config::writeText(name.stem().string()) + "\n\n";
  text += sourceSection(probe.plugin, probe.values);
  std::error_code ignored;
  const fs::file_status kind = fs::status(recording, ignored);
  const bool is_live = !fs::is_regular_file(kind) && !fs::is_directory(kind);
  text += (is_live ? "" : stepText(probe)) + scaleText(probe);
  if (is_live) {
    text += "\npipeline:\n  mode: realtime               # frames that come too fast are dropped\n";
  }
  return text + "\n" + stages;
}

}  // namespace tolman::app
