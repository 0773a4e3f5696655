// SPDX-License-Identifier: BSD-3-Clause
#include "path_steps.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::view_sequences {

double PathSteps::lengthOf(const Motion& motion) {
  const double length = motion.T_previous_current.translation().norm();
  if (motion.scale_known) return length;
  if (!(length > 0)) return 0;
  // Mean over about a hundred motions.
  mean_length_ = mean_length_ > 0 ? mean_length_ + 0.01 * (length - mean_length_) : length;
  return spacing_ * length / mean_length_;
}

std::optional<PathStep> PathSteps::move(const Motion& motion) {
  const bool restarts = motion.state == TrackingState::Initialising && !initialising_;
  initialising_ = motion.state == TrackingState::Initialising;
  if (restarts) {
    if (has_started_) path_ += gap_;
    pass_is_due_ = true;
  }
  if (!initialising_) {
    const double length = lengthOf(motion);
    path_ += length;
    since_step_ += length;
  }
  has_started_ = true;
  constexpr double kRounding = 1e-9;  // relative; of sums of motions
  if (!pass_is_due_ && since_step_ < spacing_ * (1 - kRounding)) return std::nullopt;
  const PathStep step{path_, pass_is_due_ ? 1 : since_step_ / spacing_, pass_is_due_};
  pass_is_due_ = false;
  since_step_ = 0;
  return step;
}

void PathSteps::postpone(const PathStep& step) {
  pass_is_due_ = step.begins_pass;
  since_step_ = step.begins_pass ? 0 : step.advance * spacing_;
}

void PathSteps::save(StateWriter& writer) const {
  for (const double value : {path_, since_step_, mean_length_}) writer.put(value);
  for (const bool flag : {has_started_, initialising_, pass_is_due_}) {
    writer.put(static_cast<std::uint8_t>(flag));
  }
}

bool PathSteps::load(StateReader& reader) {
  for (double* value : {&path_, &since_step_, &mean_length_}) *value = reader.get<double>();
  for (bool* flag : {&has_started_, &initialising_, &pass_is_due_}) {
    *flag = reader.get<std::uint8_t>() != 0;
  }
  const auto isLength = [](double value) { return std::isfinite(value) && value >= 0; };
  return isLength(path_) && isLength(since_step_) && isLength(mean_length_);
}

}  // namespace tolman::view_sequences
