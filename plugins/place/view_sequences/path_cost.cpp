// SPDX-License-Identifier: BSD-3-Clause
#include "path_cost.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "wide_lanes.hpp"

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

namespace {

constexpr int kLargestStep = 3;  // views that the recursion moves in a step; chosen, not tuned

/// The recursion of one step. `costs`: of moving by 0 to kLargestStep views.
struct Transition {
  std::array<float, kLargestStep + 1> costs;
  float memory;
  float offset;

  float cost(float z, float best) const { return z + offset + memory * (best < 0 ? best : 0); }
};

/// Cost of view `i`, near the end of a sequence: only `beyond` views, fewer than kLargestStep,
/// are before it in the driving direction.
template <std::int64_t kForward>
float costAtEnd(const Transition& t, const float* before, const float* z, std::int64_t i,
                std::int64_t beyond) {
  float best = 0;
  for (std::int64_t k = 0; k <= beyond; ++k) {
    best = std::min(best, before[i - kForward * k] + t.costs[static_cast<std::size_t>(k)]);
  }
  return t.cost(z[i], best);
}

/// Cost of the views from `begin` to `end`, which have kLargestStep views before them.
template <std::int64_t kForward>
[[gnu::always_inline]] inline void stepInner(const Transition& t, const float* before,
                                             const float* z, float* after, std::int64_t begin,
                                             std::int64_t end) {
  static_assert(kLargestStep == 3);
  const float c0 = t.costs[0];
  const float c1 = t.costs[1];
  const float c2 = t.costs[2];
  const float c3 = t.costs[3];
  for (std::int64_t i = begin; i < end; ++i) {
    const float stay = before[i] + c0;
    const float one = before[i - kForward] + c1;
    const float two = before[i - 2 * kForward] + c2;
    const float three = before[i - 3 * kForward] + c3;
    const float near = stay < one ? stay : one;
    const float far = two < three ? two : three;
    const float best = near < far ? near : far;
    after[i] = z[i] + t.offset + t.memory * (best < 0 ? best : 0.0F);
  }
}

TOLMAN_WIDE_LANES void stepForwards(const Transition& t, const float* before, const float* z,
                                    float* after, std::int64_t count) {
  const std::int64_t first = std::min<std::int64_t>(count, kLargestStep);
  for (std::int64_t i = 0; i < first; ++i) after[i] = costAtEnd<1>(t, before, z, i, i);
  stepInner<1>(t, before, z, after, first, count);
}

TOLMAN_WIDE_LANES void stepBackwards(const Transition& t, const float* before, const float* z,
                                     float* after, std::int64_t count) {
  const std::int64_t last = std::max<std::int64_t>(count - kLargestStep, 0);
  stepInner<-1>(t, before, z, after, 0, last);
  for (std::int64_t i = last; i < count; ++i) {
    after[i] = costAtEnd<-1>(t, before, z, i, count - 1 - i);
  }
}

}  // namespace

void PathCost::add(std::int64_t predecessor) {
  const auto view = static_cast<std::int64_t>(cost_.size());
  if (predecessor != view - 1 || predecessor < 0) {
    starts_.push_back(view);
    if (predecessor >= 0) links_.push_back({predecessor, view});
  }
  cost_.push_back(0);
}

void PathCost::join(std::int64_t from, std::int64_t to) { links_.push_back({from, to}); }

void PathCost::step(std::span<const float> standardised, double advance, std::int64_t candidates) {
  Transition transition{
      {}, static_cast<float>(settings_.memory), static_cast<float>(settings_.offset)};
  for (int k = 0; k <= kLargestStep; ++k) {
    transition.costs[static_cast<std::size_t>(k)] =
        static_cast<float>(settings_.penalty * std::abs(k - advance));
  }
  const bool forwards = settings_.direction == Direction::Forwards;
  before_.swap(cost_);
  cost_.resize(before_.size());
  for (std::size_t s = 0; s < starts_.size(); ++s) {
    const std::int64_t start = starts_[s];
    const auto end =
        s + 1 < starts_.size() ? starts_[s + 1] : static_cast<std::int64_t>(before_.size());
    const auto step_sequence = forwards ? stepForwards : stepBackwards;
    step_sequence(transition, before_.data() + start, standardised.data() + start,
                  cost_.data() + start, end - start);
  }
  for (const SequenceLink& link : links_) {
    const std::int64_t giver = forwards ? link.from : link.to;
    if (giver >= candidates) continue;
    const auto to = static_cast<std::size_t>(forwards ? link.to : link.from);
    const float best = before_[static_cast<std::size_t>(giver)] + transition.costs[1];
    cost_[to] = std::min(cost_[to], transition.cost(standardised[to], best));
  }
}

void PathCost::correct(std::int64_t view, float change) {
  cost_[static_cast<std::size_t>(view)] += change;
}

void PathCost::forget() { std::ranges::fill(cost_, 0.0F); }

void PathCost::save(StateWriter& writer) const {
  writer.putAll<float>(cost_);
  writer.put(static_cast<std::uint64_t>(starts_.size()));
  writer.putAll<std::int64_t>(starts_);
  writer.put(static_cast<std::uint64_t>(links_.size()));
  for (const SequenceLink& link : links_) {
    writer.put(link.from);
    writer.put(link.to);
  }
}

bool PathCost::load(StateReader& reader, std::int64_t views) {
  *this = PathCost(settings_);
  const auto isView = [&](std::int64_t i) { return i >= 0 && i < views; };
  if (static_cast<std::uint64_t>(views) > reader.remaining() / sizeof(float)) return false;
  cost_.resize(static_cast<std::size_t>(views));
  reader.getAll<float>(cost_);
  const auto starts = reader.get<std::uint64_t>();
  if (starts > reader.remaining() / sizeof(std::int64_t)) return false;
  starts_.resize(starts);
  reader.getAll<std::int64_t>(starts_);
  const auto links = reader.get<std::uint64_t>();
  if (links > reader.remaining() / sizeof(SequenceLink)) return false;
  for (std::uint64_t i = 0; i < links; ++i) {
    const auto from = reader.get<std::int64_t>();
    links_.push_back({from, reader.get<std::int64_t>()});
  }
  const bool sound = std::ranges::all_of(cost_, [](float e) { return std::isfinite(e); }) &&
                     std::ranges::all_of(starts_, isView) &&
                     std::ranges::adjacent_find(starts_, std::greater_equal{}) == starts_.end() &&
                     std::ranges::all_of(links_, [&](const SequenceLink& link) {
                       return isView(link.from) && isView(link.to);
                     });
  return sound && (views == 0 || (!starts_.empty() && starts_.front() == 0));
}

}  // namespace tolman::view_sequences
