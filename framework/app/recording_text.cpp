// SPDX-License-Identifier: BSD-3-Clause
// The configuration for a recording.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>

#include "app/options.hpp"
#include "app/recording.hpp"
#include "config/text.hpp"
#include "record/run_files.hpp"

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

std::string notKnown(const Recording& r, const std::string& carrier, bool is_guessed) {
  std::string text;
  const auto add = [&](const std::string& line) { text += "#   - " + line + "\n"; };
  if (!r.other_folders.empty()) {
    add("which camera: there are images also in " + config::listed(r.other_folders) +
        " (source.left, source.right)");
  }
  if (r.rate_assumed) {
    add(fmt::format("the frame rate: {:.4g} Hz are assumed (source.rate)", r.rate));
  }
  for (const std::string& reason : r.unused) add("a file beside the images: " + reason);
  if (r.width > 0 && !r.calibrated) {
    add("the calibration: turns are right only with the right odometry.field_of_view, and lengths");
    text += "#     have an arbitrary scale\n";
  } else if (r.width > 0) {
    if (r.baseline == 0 && !r.depth) {
      add("the scale: lengths of one camera are in arbitrary units");
    }
    if (is_guessed) {
      add(fmt::format("what carries the camera: '{}' is guessed, from the {}; `--motion` says it",
                      carrier, r.baseline > 0 ? "baseline" : "shape of the images"));
    }
  }
  if (!r.has_truth) add("the true path: there will be no errors, only figures");
  return text.empty() ? "" : "# Not known:\n" + text;
}

/// The key `step` of the section `source`, for a recording that is faster than needed.
std::string stepText(const Recording& r) {
  if (r.width == 0 || r.rate <= kFastest || r.isGiven("step")) return "";
  const double step = std::round(r.rate / kUsual);
  return fmt::format("  step: {:<22.0f} # of {:.4g} frames a second {:.4g} are used\n", step,
                     r.rate, r.rate / step);
}

/// The section `images` with a `scale`, for large images.
std::string scaleText(const Recording& r) {
  const double pixels = static_cast<double>(r.width) * r.height;
  if (pixels <= kManyPixels) return "";
  const double scale =
      std::max(kSmallestScale, std::round(20 * std::sqrt(kUsualPixels / pixels)) / 20);
  return fmt::format(
      "\nimages:\n  scale: {:<21.2f} # {}x{} px cost time and give odometry little\n", scale,
      r.width, r.height);
}

std::string shippedText(const std::string& name) {
  std::ifstream file(configFile("configs/init/" + name));
  const std::string text(std::istreambuf_iterator<char>(file), {});
  if (!text.empty()) return text;
  fail(ExitCode::Configuration,
       "configs/init/" + name + " is not there; install the program again");
}

}  // namespace

std::string guessCarrier(const Recording& r) {
  const bool wide = r.baseline > 0 ? r.baseline >= kWideBaseline : r.width >= kWideImage * r.height;
  return wide ? "car" : "hand";
}

std::string stagesFile(const Recording& r, const std::string& carrier) {
  if (r.width == 0) return "motion.yaml";
  if (!r.calibrated) return "uncalibrated.yaml";
  return carrier + (r.baseline > 0 ? "_stereo.yaml" : r.depth ? "_rgbd.yaml" : "_mono.yaml");
}

std::string initText(const fs::path& path, const Recording& r, const std::string& carrier,
                     const std::string& stages, Use use) {
  const std::string used = carrier.empty() ? guessCarrier(r) : carrier;
  std::string text = "# Written by `tolman init`. Run it with `tolman run FILE`.\n";
  text += "# " + r.description + "\n" + notKnown(r, used, carrier.empty());
  if (!r.warnings.empty()) text += "# Warnings:\n";
  for (const std::string& warning : r.warnings) text += "#   - " + warning + "\n";
  const fs::path name = path.has_filename() ? path : path.parent_path();
  text += "name: " + config::writeText(name.stem().string()) + "\n\n";
  text += "source:\n  plugin: " + r.plugin + "\n";
  for (const auto& [key, value] : r.values) text += "  " + key + ": " + value + "\n";
  std::error_code ignored;
  const bool is_live = fs::is_other(path, ignored);
  if (!is_live && use == Use::Run) text += stepText(r);
  if (use == Use::Run) text += scaleText(r);
  if (is_live) {
    text += "\npipeline:\n  mode: realtime               # frames that come too fast are dropped\n";
  }
  return text + "\n" + stages;
}

std::string configurationFor(const std::string& path, const SourceValues& given,
                             const std::string& carrier, const Invocation& invocation, Use use) {
  std::error_code error;
  const fs::path recording = fs::canonical(path, error);
  if (error) fail(ExitCode::Dataset, path + ": " + error.message());
  if (record::holdsRecordedRun(recording)) {
    fail(ExitCode::Dataset, path +
                                ": is a run directory, not a recording; `tolman view`, `report`, "
                                "`export`, `plan`, `compare` and `rerun` take one");
  }
  const Recording found = lookAt(recording, given, invocation);
  const std::string used = carrier.empty() ? guessCarrier(found) : carrier;
  return initText(recording, found, carrier, shippedText(stagesFile(found, used)), use);
}

engine::SystemOptions withRecording(engine::SystemOptions options, const Invocation& invocation,
                                    Use use) {
  const fs::path given = options.config;
  const std::string ending = given.extension();
  std::error_code ignored;
  const bool is_folder = fs::is_directory(given, ignored);
  const bool is_yaml = !is_folder && (ending == ".yaml" || ending == ".yml");
  if (is_yaml || !fs::exists(given, ignored)) return options;
  if (!is_folder && sourceFor(given).empty()) return options;
  SourceValues values;
  for (const std::string& override : options.overrides) {
    constexpr std::string_view kSource = "source.";
    const std::size_t equals = override.find('=');
    if (!override.starts_with(kSource) || equals == std::string::npos) continue;
    values.emplace_back(override.substr(kSource.size(), equals - kSource.size()),
                        override.substr(equals + 1));
  }
  const std::string text = configurationFor(given, values, "", invocation, use);
  if (!invocation.quiet) {  // the comment without its first line
    const std::size_t begin = text.find('\n') + 1;
    std::cerr << text.substr(begin, text.find("\nname: ") + 1 - begin);
  }
  const int file = ::memfd_create("recording.yaml", 0);  // open until the process ends
  if (::write(file, text.data(), text.size()) != static_cast<ssize_t>(text.size())) {
    fail(ExitCode::Record, "no memory for the configuration of " + options.config);
  }
  options.config = "/proc/self/fd/" + std::to_string(file);
  return options;
}

}  // namespace tolman::app
