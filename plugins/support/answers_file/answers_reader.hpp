// SPDX-License-Identifier: BSD-3-Clause
// Reads answers.bin of a run that was made with `record.replay`: the answers of source, odometry
// and place, frame by frame and bit for bit. The host's record/answers_file.hpp defines the format.
#pragma once

#include <cstdint>
#include <fstream>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::answers_file {

class AnswersReader {
 public:
  /// `run` is a run directory. Reads the sizes of all blocks: a run that has not ended is refused.
  Status open(const std::string& run);
  /// Returns to the first frame.
  void rewind();

  const SourceInfo& source() const { return source_; }
  const std::vector<ArrayInfo>& sensors() const { return sensors_; }
  std::int64_t frames() const { return static_cast<std::int64_t>(blocks_.size()); }
  /// "has 20 of the 51 frames of its source, because its run was interrupted; ..."; empty if the
  /// run finished, or if its source did not tell how many would come, as live ones.
  const std::string& part() const { return part_; }

  // Frames must be read in ascending order; some may be left out. Motion and place are read only if
  // the given frame is the one of the recorded run, otherwise they fail.
  Status read(std::int64_t frame, Frame& answer);
  Status read(const Frame& frame, Motion& answer);
  Status read(const Frame& frame, PlaceObservation& answer);
  /// The revisions that odometry reported after the last frame.
  Status read(std::vector<MotionRevision>& revisions);

 private:
  struct Block {
    std::int64_t tag = 0;
    std::uint64_t size = 0;
    std::uint64_t checksum = 0;
    std::streamoff start = 0;  ///< of the payload in the file
  };
  Status readStart(const Block& block);
  Status checkRun(const nlohmann::json& run, std::string_view id) const;
  Status readFrame(std::int64_t frame);
  Status readPayload(const Block& block);
  Status compare(std::string_view recorded, const Frame& frame) const;
  Status damaged(const std::string& what) const;

  std::string file_;
  std::ifstream stream_;
  SourceInfo source_;
  std::string part_;
  std::vector<ArrayInfo> sensors_;
  std::vector<Block> blocks_;  ///< of the frames
  Block end_;
  std::string payload_;
  // Points of the last motion that has some; equal points are stored once.
  std::int64_t next_motion_ = 0;
  Eigen::Matrix<float, 4, Eigen::Dynamic> points_;
};

}  // namespace tolman::answers_file
