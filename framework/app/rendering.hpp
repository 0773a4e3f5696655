// SPDX-License-Identifier: BSD-3-Clause
// Writes the frames of a source into a KITTI folder: images are encoded and written while the
// source makes the next ones.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/kitti_folder.hpp"
#include "tolman/context.hpp"
#include "tolman/roles.hpp"

namespace tolman::dataset {

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
  std::vector<Revisit> revisits;
};

class Rendering {
 public:
  /// Fills the next frame, as Source::next().
  using Next = std::function<Status(Frame&)>;

  /// `on_frame` is called after each frame, from any thread.
  Rendering(Next source, const SourceInfo& info, const KittiFolder& folder,
            const RenderOptions& options, Logger& log, std::function<void()> on_frame)
      : source_(std::move(source)),
        info_(info),
        folder_(folder),
        options_(options),
        log_(log),
        on_frame_(std::move(on_frame)) {}

  /// Writes all frames, then the text files. After an interruption or a failure of the source the
  /// text files are written, too, so that the images written so far are a valid data set.
  RenderOutcome run(const Cancellation& cancellation);

 private:
  /// A frame and its number in the folder.
  struct Job {
    std::int64_t index = 0;
    Frame frame;
  };
  using JobPtr = std::shared_ptr<Job>;

  JobPtr next(const Cancellation& cancellation);
  Status check(const Frame& frame);
  bool isWhole(const Frame& frame) const;
  void leaveOut(const Frame& frame);
  void write(const Job& job);
  bool writing();
  void finish();

  Next source_;
  const SourceInfo& info_;
  const KittiFolder& folder_;
  RenderOptions options_;
  Logger& log_;
  std::function<void()> on_frame_;
  DriveLog drive_;
  RenderOutcome outcome_;
  std::mutex folder_mutex_;  // of outcome_.folder
  std::int64_t taken_ = 0;
  PixelFormat format_ = PixelFormat::Gray8;
};

}  // namespace tolman::dataset
