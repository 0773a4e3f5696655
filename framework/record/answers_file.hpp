// SPDX-License-Identifier: BSD-3-Clause
// answers.bin of a run with `record.replay`: what source, odometry and place answered, bit for bit.
// Cells and map that are given these answers again do the same as in the recorded run. (run.sqlite
// has rotations as quaternions, which are not exact.)
//
// The file is "TLMANSW2", then blocks: i64 tag, u64 size, u64 FNV-1a of the payload, payload.
//   tag -1            texts: field names of the records, id of the run, SourceInfo, ArrayInfos of
//                     the sensors
//   tag 0, 1, 2 ...   texts: Frame, bool `same points as before` and Motion, PlaceObservation
//   tag -2            text: the motions that odometry revised after the last frame
// A text is u64 length and bytes; its contents are encoded as answers_codec.hpp says.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tolman/roles.hpp"

namespace tolman::record {

inline constexpr std::string_view kAnswersFile = "answers.bin";

class AnswersFile {
 public:
  /// Creates answers.bin in a run directory.
  static Result<AnswersFile> create(const std::filesystem::path& directory,
                                    const SourceInfo& source, const std::vector<ArrayInfo>& sensors,
                                    const std::string& run_id = "");
  /// Opens answers.bin of an interrupted or killed run, and removes the answers from frame
  /// `next_frame` on. InvalidInput if an earlier frame is missing or damaged, or if the
  /// answers are of another run than `run_id`.
  static Result<AnswersFile> reopen(const std::filesystem::path& directory, std::int64_t next_frame,
                                    const std::string& run_id = "");

  Status add(const Frame& frame, const Motion& motion, const PlaceObservation& place);
  /// Afterwards all answers so far are in the file, even if the process is killed.
  Status flush();
  /// Writes the last revisions and the end, and reads the file back: another program or a disk can
  /// have changed it. Nothing may be added afterwards.
  Status finish(const std::vector<MotionRevision>& revisions);

 private:
  explicit AnswersFile(std::filesystem::path file) : file_(std::move(file)) {}
  Status open(std::ios::openmode mode);
  Status block(std::int64_t tag, const std::string& payload);

  std::filesystem::path file_;
  std::ofstream stream_;
  std::int64_t points_frame_ = -1;  ///< points_frame of the last written points
};

/// Whether the run there has all answers: its answers.bin has the last block.
bool hasAnswers(const std::filesystem::path& directory);

}  // namespace tolman::record
