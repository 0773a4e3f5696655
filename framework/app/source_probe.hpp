// SPDX-License-Identifier: BSD-3-Clause
// What a source makes of a recording, tried in a process of its own with a deadline: a file that
// crashes or blocks one source does not keep others from being tried.
#pragma once

#include <cstdint>
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
  bool has_truth = false;
  double rate = 0;  ///< Hz, of the first frames

  /// Calibrated pairs before single cameras, before uncalibrated ones, before no images.
  int rank() const { return (width > 0 ? 1 : 0) + (calibrated ? 2 : 0) + (baseline > 0 ? 2 : 0); }
};

/// InvalidInput where the source does not read the recording, with the reason; Unsupported where it
/// has no such parameters, or does not answer.
Result<Probe> probe(const std::string& plugin, const SourceValues& values,
                    const Invocation& invocation);

}  // namespace tolman::app
