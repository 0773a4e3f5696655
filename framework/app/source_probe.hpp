// SPDX-License-Identifier: BSD-3-Clause
// Tests whether a source can read a recording. The test runs in its own process with a deadline, so
// that the search continues if a file crashes or blocks a source.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "app/program.hpp"

namespace tolman::app {

/// Parameters of a source: name and YAML value.
using SourceValues = std::vector<std::pair<std::string, std::string>>;

/// The section `source` of a configuration.
std::string sourceSection(const std::string& plugin, const SourceValues& values);

/// A source that read the first frames.
struct Probe {
  std::string plugin;
  SourceValues values;
  std::string description;
  int width = 0;  ///< px; 0: no images
  int height = 0;
  bool calibrated = false;
  double baseline = 0;  ///< m; 0: one camera
  bool depth = false;   ///< with depth images
  bool has_truth = false;
  double rate = 0;                    ///< Hz, of the first frames
  std::vector<std::string> warnings;  ///< of the source: "source: its text"

  /// Calibrated pairs before single cameras (those with depth first), before uncalibrated ones,
  /// before no images.
  int rank() const {
    return (width > 0 ? 1 : 0) + (calibrated ? 2 : 0) + (baseline > 0 ? 2 : depth ? 1 : 0);
  }
};

/// Time limit for one source. It is longer for large files, because a bag is read completely before
/// its first frame.
std::chrono::seconds probeDeadline(const std::filesystem::path& recording);

/// InvalidInput where the source does not read the recording, or not in time, with the reason;
/// Unsupported where it has no such parameters, or its process fails.
Result<Probe> probe(const std::string& plugin, const SourceValues& values,
                    std::chrono::seconds deadline, const Invocation& invocation);

}  // namespace tolman::app
