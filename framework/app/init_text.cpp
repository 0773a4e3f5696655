// SPDX-License-Identifier: BSD-3-Clause
#include "app/init_text.hpp"

#include <fmt/format.h>

#include <array>

#include "config/scalars.hpp"

namespace tolman::app {
namespace {

namespace fs = std::filesystem;

// Chosen on the rigs of KITTI (0.54 m; 3.3 times as wide as high) and of EuRoC and TUM-VI (0.11 m
// and 0.10 m; 1.5 and 1 times).
constexpr double kWideBaseline = 0.3;  // m
constexpr int kWideImage = 2;          // times as wide as high

std::string_view nameOf(CarriedBy carrier) {
  constexpr std::array<std::string_view, 4> kNames = {"unknown", "car", "hand", "toy"};
  return kNames.at(static_cast<std::size_t>(carrier));
}

std::string notKnown(const Probe& probe, const RecordingSearch& search, CarriedBy told,
                     CarriedBy used) {
  std::string text;
  const auto add = [&](const std::string& line) { text += "#   - " + line + "\n"; };
  if (search.rate_assumed)
    add(fmt::format("the frame rate: {:.4g} Hz are assumed (source.rate)", probe.rate));
  if (probe.width > 0 && !probe.calibrated) {
    add("the calibration: turns are right only with the right odometry.field_of_view, and lengths");
    text += "#     have an arbitrary scale\n";
  } else if (probe.width > 0) {
    if (probe.baseline == 0) add("the scale: lengths of one camera are in arbitrary units");
    if (told == CarriedBy::Unknown) {
      add(fmt::format("what carries the camera: '{}' is guessed, from the {}; `--motion` says it",
                      nameOf(used), probe.baseline > 0 ? "baseline" : "shape of the images"));
    }
  }
  if (!probe.has_truth) add("the true path: there will be no errors, only figures");
  return text;
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
  return fmt::format("{}_{}.yaml", nameOf(carrier), probe.baseline > 0 ? "stereo" : "mono");
}

std::string initText(const fs::path& recording, const RecordingSearch& search, CarriedBy told,
                     const std::string& stages) {
  const Probe& probe = *search.best;
  const CarriedBy used = told == CarriedBy::Unknown ? guessCarrier(probe) : told;
  std::string text = "# Written by `tolman init`. Run it with `tolman run FILE`.\n";
  text += "# " + probe.description + "\n";
  const std::string unknown = notKnown(probe, search, told, used);
  if (!unknown.empty()) text += "# Not known:\n" + unknown;
  for (const std::string& other : search.others)
    text += "# Read also by the source " + other + ".\n";
  const fs::path name = recording.has_filename() ? recording : recording.parent_path();
  text += "name: " + config::writeText(name.stem().string()) + "\n\n";
  text += sourceSection(probe.plugin, probe.values);
  std::error_code ignored;
  const fs::file_status kind = fs::status(recording, ignored);
  if (!fs::is_regular_file(kind) && !fs::is_directory(kind)) {
    text += "\npipeline:\n  mode: realtime               # frames that come too fast are dropped\n";
  }
  return text + "\n" + stages;
}

}  // namespace tolman::app
