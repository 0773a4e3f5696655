// SPDX-License-Identifier: BSD-3-Clause
// RatSLAM's decision: a new experience, an old one, or the present one.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "activity_volume.hpp"
#include "tolman/records.hpp"

namespace tolman::pose_cells {

class ExperienceMemory {
 public:
  /// `threshold`, in cells, separates experiences.
  explicit ExperienceMemory(double threshold) : threshold_(threshold) {}

  /// Decides for a view seen at `here`, turned by `turned` headings against its template.
  Action decide(const ActivityVolume& volume, const CellPose& here, double turned,
                std::int64_t template_id);
  /// The very first experience, without a view.
  void createFirst(const CellPose& here);

  std::int64_t current() const { return current_; }  ///< -1 before the first

 private:
  struct StoredPose {
    CellPose place;
    std::int64_t template_id = -1;
  };
  Action create(const CellPose& place, std::int64_t template_id);

  double threshold_;
  std::vector<StoredPose> experiences_;
  std::map<std::int64_t, std::vector<std::int64_t>> of_template_;
  std::int64_t current_ = -1;
  std::int64_t previous_template_ = -1;
};

}  // namespace tolman::pose_cells
