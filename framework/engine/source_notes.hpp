// SPDX-License-Identifier: BSD-3-Clause
// What the frames of any source say that hardly can be, whatever plugin it is: steps in time, and
// a truth that was told and never came. Sources of files say it with the line of the file.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::run {

class SourceNotes {
 public:
  /// A frame that was recorded, in order. Returns what to warn of: a step of more than a day and a
  /// thousand of the steps before. Only the first three are told one by one.
  std::optional<std::string> add(const Frame& frame);
  /// At the end of the run: what to warn of. `told_truth`: SourceInfo::has_truth.
  std::vector<std::string> atEnd(bool told_truth) const;

 private:
  /// The median; pauses do not change it.
  std::int64_t usualStep() const;
  std::int64_t last_ns_ = 0;
  std::vector<std::int64_t> steps_ns_;
  int jumps_ = 0;
  std::int64_t frames_ = 0;
  std::int64_t true_poses_ = 0;
};

}  // namespace tolman::run
