// SPDX-License-Identifier: BSD-3-Clause
// Stores the current experience and the motion since, and decides whether a new experience or a
// loop link is due.
#pragma once

#include <cstdint>
#include <vector>

#include "tolman/geometry.hpp"

namespace tolman {

/// Chosen, not tuned (docs/method.md, Parameters).
struct ExperienceSettings {
  double spacing = 5;               ///< m, largest distance between experiences
  double turn = 0.5;                ///< rad, largest turn between experiences
  double novel_spacing = 1;         ///< m, distance from which a novel view makes a new one
  double loop_minimum_travel = 30;  ///< m, smallest travel since the experience was left
  double loop_spacing = 5;          ///< m, smallest travel between loop links
  /// Distances count from where the newest experience was made; otherwise from the current one, as
  /// the paper has it. A false loop then leaves a gap between experiences.
  bool from_newest = true;
};

class ExperienceLog {
 public:
  explicit ExperienceLog(const ExperienceSettings& settings) : settings_(settings) {}

  void advance(const Eigen::Isometry3d& T_previous_current);

  /// True for the first one (also of a new part), at `spacing` or `turn` from the last one, or for
  /// a novel view at `novel_spacing` from there.
  bool wantsNew(bool view_is_novel) const;
  /// False for the current experience and within loop_minimum_travel and loop_spacing.
  bool allowsLoopTo(std::int64_t experience) const;

  /// From here on the pose relative to the earlier path is unknown. Loops to all experiences so far
  /// are allowed.
  void startPart();

  /// The robot is at the new experience. Returns its id.
  std::int64_t create();
  void closeLoopTo(std::int64_t experience, const Eigen::Isometry3d& T_experience_current);

  std::int64_t current() const { return current_; }  ///< -1 before the first
  const Eigen::Isometry3d& fromCurrent() const { return T_experience_current_; }

  /// All that the next decisions depend on, for saving.
  struct State {
    std::int64_t current = -1;
    Eigen::Isometry3d T_experience_current = Eigen::Isometry3d::Identity();
    Eigen::Isometry3d T_made_current = Eigen::Isometry3d::Identity();
    double travel = 0;
    double travel_at_loop = 0;
    std::vector<double> travel_when_left;
    bool new_part = false;
  };
  State state() const;
  void restore(const State& state);

 private:
  void arriveAt(std::int64_t experience, const Eigen::Isometry3d& T_experience_current);

  ExperienceSettings settings_;
  std::int64_t current_ = -1;
  Eigen::Isometry3d T_experience_current_ = Eigen::Isometry3d::Identity();
  Eigen::Isometry3d T_made_current_ = Eigen::Isometry3d::Identity();  ///< from the newest one
  double travel_ = 0;                     ///< m driven; startPart() adds enough to allow loops
  double travel_at_loop_ = 0;             ///< travel_ at the last loop link
  std::vector<double> travel_when_left_;  ///< travel_ when each experience was left
  bool new_part_ = false;                 ///< a part began, and no experience was reached since
};

}  // namespace tolman
