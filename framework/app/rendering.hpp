// SPDX-License-Identifier: BSD-3-Clause
// Writes the frames of a source into a KITTI folder: images are encoded and written while the
// source makes the next ones.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/kitti_folder.hpp"
#include "tolman/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::app {

/// Name of the array that a source describes as a depth image; empty when there is none.
std::string depthArray(const std::vector<ArrayInfo>& arrays);

struct RenderOptions {
  std::int64_t frames = -1;  ///< most frames to take from the source; -1 for all
  std::string depth;         ///< name of the sensor array to write as depth maps; empty for none
};

struct RenderOutcome {
  Status source;  ///< Ok, or what ended the rendering early
  Status folder;  ///< Ok, or the first file that could not be written
  bool interrupted = false;
  std::int64_t written = 0;
  std::int64_t left_out = 0;  ///< frames without a sound image; they get no number in the folder
  std::vector<evaluation::Revisit> revisits;
};

/// Where frames come from.
struct RenderSource {
  std::function<Status(Frame&)> next;  ///< as Source::next()
  const SourceInfo& info;
  std::function<void()> on_frame;  ///< called after each frame, from any thread
};

/// Writes all frames, then the text files. After an interruption or a failure of the source the
/// text files are written, too, so that the images written so far are a valid data set.
RenderOutcome render(const RenderSource& source, const KittiFolder& folder,
                     const RenderOptions& options, Logger& log, const Cancellation& cancellation);

}  // namespace tolman::app
