// SPDX-License-Identifier: BSD-3-Clause
// What a recording is: the source that reads it, the files beside it that the source can use, and
// the configuration for it.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/program.hpp"
#include "engine/checked_system.hpp"

namespace tolman::app {

/// Parameters of a source: name and YAML value.
using SourceValues = std::vector<std::pair<std::string, std::string>>;

/// A recording as its source reads the first frames.
struct Recording {
  std::string plugin;
  SourceValues values;
  std::string description{};
  int width = 0;  ///< px; 0: no images
  int height = 0;
  bool calibrated = false;
  double baseline = 0;  ///< m; 0: one camera
  bool depth = false;   ///< with depth images
  bool has_truth = false;
  double rate = 0;  ///< Hz, of the first frames
  bool rate_assumed = false;
  std::vector<std::string> warnings{};       ///< of the source: "source: its text"
  std::vector<std::string> other_folders{};  ///< with images that the source does not read
  std::vector<std::string> unused{};         ///< files of times or calibrations, with the reason

  bool isGiven(std::string_view parameter) const;
};

/// The id of the source for this layout (configs/init/layouts.yaml); empty for an unknown one.
/// Looks at names only.
std::string sourceFor(const std::filesystem::path& recording);

/// Reads the first frames with the source of the layout, `images` for an unknown one, or the one
/// that is given as `plugin`. Where the source declares them, it also tries `rate`, `left` and
/// `right`, `calibration`, `stamps` with `stamps_column` and `stamps_unit`, and `stamps_in_names`,
/// with the files in the folder. `given`: further parameters. Fails (5) if it cannot be read.
Recording lookAt(const std::filesystem::path& recording, const SourceValues& given,
                 const Invocation& invocation);

/// What carries the camera: "car", "hand" or "toy". A wide baseline or a wide image means a car.
std::string guessCarrier(const Recording& recording);

/// The file in configs/init with the stages for these images: hand_stereo.yaml
std::string stagesFile(const Recording& recording, const std::string& carrier);

/// What the configuration is for. A run takes fewer and smaller images of a fast or large camera.
enum class Use : bool { Run, Copy };

/// The configuration for the recording at `path`. An empty `carrier` is guessed; `stages` is the
/// text of stagesFile().
std::string initText(const std::filesystem::path& path, const Recording& recording,
                     const std::string& carrier, const std::string& stages, Use use = Use::Run);

/// The configuration that `init` writes, and the file of its stages.
struct Initial {
  std::string text;
  std::string stages;
};
/// `given`: parameters of the source. Fails (5) if the recording cannot be read.
Initial initialFor(const std::string& path, const SourceValues& given, const std::string& carrier,
                   const Invocation& invocation, Use use = Use::Run);

/// The parameters in overrides such as "first=3", behind the prefix.
SourceValues valuesIn(const std::vector<std::string>& overrides, const std::string& prefix);

/// If `options.config` is a recording, replaces it by the configuration for it.
engine::SystemOptions withRecording(engine::SystemOptions options, const Invocation& invocation,
                                    Use use);

}  // namespace tolman::app
