// SPDX-License-Identifier: BSD-3-Clause
// Which motions from frame to frame the messages of an odometry topic measure: not those before its
// first or after its last message, nor those in a hole, where messages are missing.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace tolman::ros_bag {

class OdometryCoverage {
 public:
  OdometryCoverage() = default;
  /// `stamps_ns`: times of the messages, sorted.
  explicit OdometryCoverage(std::vector<std::int64_t> stamps_ns);

  enum class Kind : std::uint8_t { Measured, Outside, InHole };
  /// Of the motion between these times, in any order. Outside if there are no messages.
  Kind kindOf(std::int64_t one_ns, std::int64_t other_ns) const;

  /// Whether the times of the messages and of the frames have any in common. `frames_ns`: times of
  /// the frames in the order of the run.
  bool overlaps(const std::vector<std::int64_t>& frames_ns) const;
  /// "its messages are from 1.000 s to 3.000 s, the images from 2.000 s to 4.000 s"
  std::string ranges(const std::vector<std::int64_t>& frames_ns) const;
  /// One text, without topic, for each kind of frames whose motion is not measured.
  std::vector<std::string> problems(const std::vector<std::int64_t>& frames_ns) const;

 private:
  struct Hole {
    std::int64_t begin_ns = 0;
    std::int64_t end_ns = 0;
  };
  std::int64_t count(const std::vector<std::int64_t>& frames_ns, Kind kind) const;
  std::string holesText() const;

  std::vector<std::int64_t> stamps_ns_;
  std::vector<Hole> holes_;
  std::int64_t period_ns_ = 0;  ///< the median
};

}  // namespace tolman::ros_bag
