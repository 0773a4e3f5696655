// SPDX-License-Identifier: BSD-3-Clause
// Stores the current experience and the motion since, and decides whether a new experience or a
// loop link is due.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/geometry.hpp"

namespace tolman::paper_attractor {

/// Chosen, not tuned; the defaults are those of the parameters.
struct ExperienceSettings {
  double spacing = 5;               ///< m between experiences at most
  double turn = 0.5;                ///< rad between experiences at most
  double novel_spacing = 1;         ///< m; a novel view nearer than this makes no new experience
  double loop_minimum_travel = 30;  ///< m since the experience was left
  double loop_spacing = 5;          ///< m between loop links
};

class ExperienceLog {
 public:
  explicit ExperienceLog(const ExperienceSettings& settings) : settings_(settings) {}

  void advance(const Eigen::Isometry3d& T_previous_current);

  /// True for the first one (also of a new part), at `spacing` or `turn` from the current one by
  /// path integration, or for a novel view at `novel_spacing`.
  bool wantsNew(bool view_is_novel) const;
  /// Not to the current experience, nor before the settings' distances of travel.
  bool allowsLoopTo(std::int64_t experience) const;

  /// From here on the pose relative to the earlier path is unknown. Loops to all experiences so far
  /// are allowed.
  void startPart();

  /// The robot is at the new experience. Returns its id.
  std::int64_t create();
  void closeLoopTo(std::int64_t experience, const Eigen::Isometry3d& T_experience_current);

  std::int64_t current() const { return current_; }  ///< -1 before the first
  const Eigen::Isometry3d& fromCurrent() const { return T_experience_current_; }

 private:
  void arriveAt(std::int64_t experience, const Eigen::Isometry3d& T_experience_current);

  ExperienceSettings settings_;
  std::int64_t current_ = -1;
  Eigen::Isometry3d T_experience_current_ = Eigen::Isometry3d::Identity();
  double travel_ = 0;                     ///< m since the start
  double travel_at_loop_ = 0;             ///< m, when the last loop link was made
  std::vector<double> travel_when_left_;  ///< m, of each experience
  bool new_part_ = false;                 ///< a part began, and no experience was reached since
};

}  // namespace tolman::paper_attractor
