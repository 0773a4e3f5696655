// SPDX-License-Identifier: BSD-3-Clause
#include "engine/predicted_span.hpp"

#include <cmath>

namespace tolman::pipeline {

void PredictedSpan::add(const Motion& prediction) {
  T_answered_given_ = normalised(T_answered_given_ * prediction.T_previous_current);
  predicted_ = true;
  given_ns_ = prediction.stamp_ns;
}

void PredictedSpan::subtractFrom(Motion& motion) {
  const double since_given = 1e-9 * static_cast<double>(motion.stamp_ns - given_ns_);
  const double since_answered = 1e-9 * static_cast<double>(motion.stamp_ns - answered_ns_);
  // A dt above the geometric mean of the two times is nearer to the time since the last answer.
  const bool spans = predicted_ && motion.state != TrackingState::Initialising &&
                     motion.dt * motion.dt > since_given * since_answered;
  if (spans) {
    motion.T_previous_current = normalised(T_answered_given_.inverse() * motion.T_previous_current);
    setPlanarVelocity(motion, since_given);
    subtracted_.emplace(motion.frame, T_answered_given_);
  }
  T_answered_given_.setIdentity();
  predicted_ = false;
  given_ns_ = answered_ns_ = motion.stamp_ns;
}

void PredictedSpan::subtractFrom(MotionRevision& revision) const {
  const auto found = subtracted_.find(revision.frame);
  if (found == subtracted_.end()) return;
  revision.T_previous_current = normalised(found->second.inverse() * revision.T_previous_current);
}

}  // namespace tolman::pipeline
