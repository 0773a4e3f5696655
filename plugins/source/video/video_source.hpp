// SPDX-License-Identifier: BSD-3-Clause
// Source `video`: a video file, a pipe or a camera. Files are read in any order; pipes and cameras
// forward only, and a camera until the run is stopped.
#pragma once

#include <memory>
#include <vector>

#include "capture.hpp"
#include "file_access.hpp"
#include "frame_reader.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"
#include "video_parameters.hpp"

namespace tolman::video {

class VideoSource final : public Source {
 public:
  using Parameters = VideoParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;
  /// Decodes all pictures of a file.
  Status inspect(std::vector<Finding>& findings);

 private:
  Status prepare(const Context& context);
  Status makeRig(PictureSize picture);
  /// Refuses first and last beyond the end of a file.
  Status checkBounds(const Context& context) const;
  Status beyondEnd(std::int64_t pictures) const;
  /// Reads the times of all pictures, for other orders than forward.
  Status makeSequence();
  Status nextForward(Frame& frame);
  Status nextOfSequence(Frame& frame);
  Status atEnd();
  /// A defect of the end of the file is a failure, or a warning with on_corrupt: skip.
  Status judgeEnd(const StreamEnd& end);
  Status give(Picture& picture, std::int64_t index, Frame& frame);
  Result<std::int64_t> stampNs(const Picture& picture, std::int64_t index) const;
  void inspectPictures(std::vector<Finding>& findings);

  Parameters parameters_;
  PathKind kind_ = PathKind::File;
  Logger* log_ = nullptr;
  OpenFile pipe_;  ///< read by capture_
  OpenCapture open_;
  std::unique_ptr<Capture> capture_;  ///< for forward order
  std::unique_ptr<FrameReader> reader_;
  FrameSequence sequence_;
  CameraRig rig_;
  std::string description_;
  source_parameters::UsedBits used_bits_;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_frame_ = 0;
  std::int64_t next_picture_ = 0;  ///< in forward order: index of the next picture of capture_
};

}  // namespace tolman::video
