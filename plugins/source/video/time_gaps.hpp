// SPDX-License-Identifier: BSD-3-Clause
// Gaps between the times of pictures. A container that is damaged in the middle is often read on
// behind the damage, and only the times tell that pictures are missing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tolman::video {

class TimeGaps {
 public:
  /// The time of the next picture.
  void add(std::int64_t stamp_ns);
  /// Of the longest gap, if it has the length of several pictures; empty: there is none.
  std::string warning() const;

 private:
  std::vector<std::int64_t> steps_;  ///< ns
  std::int64_t last_ = 0;
  bool any_ = false;
};

}  // namespace tolman::video
