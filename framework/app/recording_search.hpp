// SPDX-License-Identifier: BSD-3-Clause
// Finds the source that reads a recording, and the files beside it that the source can use.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/source_probe.hpp"

namespace tolman::app {

struct RecordingSearch {
  std::optional<Probe> best;
  std::vector<std::string> others;         ///< other sources that read it, but give less
  std::vector<std::string> reasons;        ///< "SOURCE: why it does not read the recording"
  std::vector<std::string> other_folders;  ///< with images that the found source does not read
  std::vector<std::string> unread_times;   ///< why the source cannot use the times that lie there
  /// "FILE:LINE: why", of files that seem to be calibrations and were not used.
  std::vector<std::string> unread_calibrations;
  bool rate_assumed = false;
};

/// Tries every source that has a parameter `path`. Where a source declares them, it also tries
/// `rate`, `left` and `right`, `calibration`, `stamps` with `stamps_column` and `stamps_unit`, and
/// `stamps_in_names`, with the files in the folder. `given`: further parameters for every source.
RecordingSearch searchRecording(const std::filesystem::path& recording, const SourceValues& given,
                                const Invocation& invocation);

}  // namespace tolman::app
