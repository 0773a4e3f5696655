// SPDX-License-Identifier: BSD-3-Clause
// The motions of all frames, by slot. The map needs the newest motions for links and revisions,
// and older ones only for loops at earlier frames, for the last revisions and to save its state. So
// the newest are kept in memory and older ones in a temporary file. If this file cannot be written,
// for example on a full disk, all are kept in memory.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "scratch_file.hpp"
#include "uncertain_pose.hpp"

namespace tolman::experience_map {

/// Not thread-safe, not even for reading. Throws std::runtime_error when the file cannot be read.
class MotionStore {
 public:
  void append(const UncertainPose& motion);
  void replace(std::size_t slot, const UncertainPose& motion);
  UncertainPose operator[](std::size_t slot) const;
  std::size_t size() const { return filed_ + recent_.size(); }

 private:
  void loadBlock(std::size_t first) const;
  void fileOldest();

  ScratchFile file_;
  std::size_t filed_ = 0;              ///< slots in the file, a multiple of the block
  std::vector<UncertainPose> recent_;  ///< motions of the slots from filed_ on
  /// The block of the file that was read last, a cache for neighbouring slots.
  mutable std::vector<UncertainPose> block_;
  mutable std::size_t block_first_ = 0;
};

}  // namespace tolman::experience_map
