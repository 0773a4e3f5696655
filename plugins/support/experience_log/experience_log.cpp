// SPDX-License-Identifier: BSD-3-Clause
#include "experience_log.hpp"

#include <algorithm>
#include <cmath>

namespace tolman {

void ExperienceLog::advance(const Eigen::Isometry3d& T_previous_current) {
  T_experience_current_ = normalised(T_experience_current_ * T_previous_current);
  T_made_current_ = normalised(T_made_current_ * T_previous_current);
  travel_ += T_previous_current.translation().norm();
}

bool ExperienceLog::wantsNew(bool view_is_novel) const {
  if (current_ < 0 || new_part_) return true;
  const PlanarPose since =
      toPlanar(settings_.from_newest ? T_made_current_ : T_experience_current_);
  const double moved = std::hypot(since.x, since.y);
  if (view_is_novel && moved >= settings_.novel_spacing) return true;
  return moved >= settings_.spacing || std::abs(since.theta) >= settings_.turn;
}

bool ExperienceLog::allowsLoopTo(std::int64_t experience) const {
  if (experience == current_ && !new_part_) return false;
  const double left = travel_when_left_.at(static_cast<std::size_t>(experience));
  return travel_ - left >= settings_.loop_minimum_travel &&
         travel_ - travel_at_loop_ >= settings_.loop_spacing;
}

void ExperienceLog::arriveAt(std::int64_t experience,
                             const Eigen::Isometry3d& T_experience_current) {
  if (current_ >= 0 && !new_part_) travel_when_left_[static_cast<std::size_t>(current_)] = travel_;
  new_part_ = false;
  current_ = experience;
  T_experience_current_ = T_experience_current;
}

void ExperienceLog::startPart() {
  if (current_ < 0) return;
  travel_when_left_[static_cast<std::size_t>(current_)] = travel_;
  travel_ += std::max(settings_.loop_minimum_travel, settings_.loop_spacing);
  new_part_ = true;
}

std::int64_t ExperienceLog::create() {
  const auto id = static_cast<std::int64_t>(travel_when_left_.size());
  travel_when_left_.push_back(travel_);
  arriveAt(id, Eigen::Isometry3d::Identity());
  T_made_current_.setIdentity();
  return id;
}

void ExperienceLog::closeLoopTo(std::int64_t experience,
                                const Eigen::Isometry3d& T_experience_current) {
  arriveAt(experience, T_experience_current);
  travel_at_loop_ = travel_;
}

ExperienceLog::State ExperienceLog::state() const {
  return {current_,        T_experience_current_, T_made_current_, travel_,
          travel_at_loop_, travel_when_left_,     new_part_};
}

void ExperienceLog::restore(const State& state) {
  current_ = state.current;
  T_experience_current_ = state.T_experience_current;
  T_made_current_ = state.T_made_current;
  travel_ = state.travel;
  travel_at_loop_ = state.travel_at_loop;
  travel_when_left_ = state.travel_when_left;
  new_part_ = state.new_part;
}

}  // namespace tolman
