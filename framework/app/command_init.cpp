// SPDX-License-Identifier: BSD-3-Clause
// tolman init: looks at a recording and writes a configuration for it. Commands that take a
// configuration take a recording as well, with the same configuration.
#include <fmt/format.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cmath>
#include <iostream>

#include "app/options.hpp"
#include "app/recording.hpp"
#include "base/text_file.hpp"
#include "config/text.hpp"
#include "record/atomic_file.hpp"
#include "record/run_directory.hpp"

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

std::vector<std::string> notKnown(const Recording& r, const std::string& carrier, bool is_guessed) {
  std::vector<std::string> lines;
  if (!r.other_folders.empty()) {
    lines.push_back("which camera: there are images also in " + config::listed(r.other_folders) +
                    " (source.left, source.right)");
  }
  if (r.rate_assumed) {
    lines.push_back(fmt::format("the frame rate: {:.4g} Hz are assumed (source.rate)", r.rate));
  }
  for (const std::string& reason : r.unused) lines.push_back("a file beside the images: " + reason);
  if (r.width > 0 && !r.calibrated) {
    lines.emplace_back(
        "the calibration: turns are right only with the right odometry.field_of_view, and "
        "lengths\n#     have an arbitrary scale");
  } else if (r.width > 0) {
    if (r.baseline == 0 && !r.depth) {
      lines.emplace_back("the scale: lengths of one camera are in arbitrary units");
    }
    if (is_guessed) {
      lines.push_back(
          fmt::format("what carries the camera: '{}' is guessed, from the {}; `--motion` says it",
                      carrier, r.baseline > 0 ? "baseline" : "shape of the images"));
    }
  }
  if (!r.has_truth) lines.emplace_back("the true path: there will be no errors, only figures");
  return lines;
}

std::string commentOf(const std::string& heading, const std::vector<std::string>& lines) {
  std::string text = lines.empty() ? "" : "# " + heading + ":\n";
  for (const std::string& line : lines) text += "#   - " + line + "\n";
  return text;
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

struct InitCommand {
  std::string recording;
  Output out;
  std::string carrier;
  std::vector<std::string> values;
};

void init(const InitCommand& command, const Invocation& invocation) {
  const std::string& file = command.out.path;
  if (!file.empty()) refuseExisting({file}, command.out.replace, "--out");
  const std::string text =
      initialFor(command.recording, valuesIn(command.values, ""), command.carrier, invocation).text;
  if (file.empty()) {
    std::cout << text;
    return;
  }
  failUnless(record::writeOutput(file, text));
  printFiles({file}, invocation);
}

}  // namespace

Initial initialFor(const std::string& path, const SourceValues& given, const std::string& carrier,
                   const Invocation& invocation, Use use) {
  std::error_code error;
  const fs::path recording = fs::canonical(path, error);
  if (error) fail(ExitCode::Dataset, path + ": " + error.message());
  if (record::holdsRun(recording)) {
    fail(ExitCode::Dataset, path +
                                ": is a run directory, not a recording; `tolman view`, `report`, "
                                "`export`, `plan`, `compare` and `rerun` take one");
  }
  const Recording found = lookAt(recording, given, invocation);
  const std::string used = carrier.empty() ? guessCarrier(found) : carrier;
  const std::string stages = stagesFile(found, used);
  const std::string file = configFile("configs/init/" + stages);
  return {initText(recording, found, carrier,
                   valueOf(text_encoding::readText(file), ExitCode::Configuration), use),
          stages};
}

/// The parameters in overrides such as "first=3", behind the prefix.
SourceValues valuesIn(const std::vector<std::string>& overrides, const std::string& prefix) {
  SourceValues values;
  for (const std::string& text : overrides) {
    const std::size_t at = text.find('=');
    if (!text.starts_with(prefix) || at == std::string::npos) continue;
    values.emplace_back(text.substr(prefix.size(), at - prefix.size()), text.substr(at + 1));
  }
  return values;
}

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
  const fs::path name = path.has_filename() ? path : path.parent_path();
  std::string text =
      "# Written by `tolman init`. Run it with `tolman run FILE`.\n# " + r.description + "\n" +
      commentOf("Not known", notKnown(r, used, carrier.empty())) +
      commentOf("Warnings", r.warnings) + "name: " + config::writeText(name.stem().string()) +
      "\n\nsource:\n  plugin: " + r.plugin + "\n";
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

engine::SystemOptions withRecording(engine::SystemOptions options, const Invocation& invocation,
                                    Use use) {
  const fs::path given = options.config;
  const std::string ending = given.extension();
  std::error_code ignored;
  const bool is_folder = fs::is_directory(given, ignored);
  const bool is_yaml = !is_folder && (ending == ".yaml" || ending == ".yml");
  if (is_yaml || !fs::exists(given, ignored)) return options;
  if (!is_folder && sourceFor(given).empty()) return options;
  const std::string text =
      initialFor(given, valuesIn(options.overrides, "source."), "", invocation, use).text;
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

void addInitCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("init", "Look at a recording, and write a configuration for it");
  auto options = std::make_shared<InitCommand>();
  addArgument(command, "recording", options->recording, "RECORDING",
              "Folder or file of the recording, or camera");
  options->out.add(command, "FILE", "File to write (default: standard output)", "Replace the file");
  addChoice(command, "--motion", options->carrier, {"car", "hand", "toy"},
            "What carries the camera (default: a guess)");
  addList(command, "--set", options->values, "NAME=VALUE",
          "Parameter of the source: --set a=b (repeatable)")
      ->check(isAssignment);
  command.callback([options, &invocation] { init(*options, invocation); });
}

}  // namespace tolman::app
