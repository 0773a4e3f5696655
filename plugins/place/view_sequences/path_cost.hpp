// SPDX-License-Identifier: BSD-3-Clause
// The driven path in steps, and the cost of every stored view as the present place along it.
//
// Steps of equal length along the driven path, from the motions of odometry.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <vector>

#include "tolman/records.hpp"
#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

struct PathStep {
  double path = 0;           ///< m driven so far, over all passes
  double advance = 1;        ///< length of this step, in spacings
  bool begins_pass = false;  ///< tracking (re)started at an unknown pose
};

class PathSteps {
 public:
  /// `gap` m are added to the path between two passes.
  PathSteps(double spacing, double gap) : spacing_(spacing), gap_(gap) {}

  /// Adds the frame's motion. Returns a step if the frame begins a pass, or if at least one spacing
  /// was driven since the last step. Lengths in unknown units are scaled so that a mean motion is
  /// one spacing.
  std::optional<PathStep> move(const Motion& motion);
  /// To be called if the image of a step's frame could not be used: the next frame repeats the
  /// step.
  void postpone(const PathStep& step);

  void save(StateWriter& writer) const;
  /// False for a damaged state.
  bool load(StateReader& reader);

 private:
  double lengthOf(const Motion& motion);

  double spacing_;
  double gap_;
  double path_ = 0;
  double since_step_ = 0;
  double mean_length_ = 0;  ///< of motions in unknown units
  bool has_started_ = false;
  bool initialising_ = false;  ///< odometry had no motion at the previous frame
  bool pass_is_due_ = true;    ///< the next usable frame begins a pass
};

// Mean and standard deviation of many numbers. Sums are in a fixed order on every machine.

struct Sums {
  double count = 0;
  double sum = 0;
  double squares = 0;

  void add(const Sums& other) {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
  double variance() const {
    return count > 0 ? std::max(0.0, squares / count - mean() * mean()) : 0;
  }
  /// Standard deviation with a prior: `deviation` counts as much as `views` numbers.
  double deviationWithPrior(double views, double deviation) const {
    return std::sqrt((count * variance() + views * deviation * deviation) / (count + views));
  }
};

inline Sums sumsOf(std::span<const float> values) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> sum{};
  std::array<double, kLanes> squares{};
  const std::size_t whole = values.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double value = values[i + k];
      sum[k] += value;
      squares[k] += value * value;
    }
  }
  Sums sums;
  sums.count = static_cast<double>(values.size());
  for (std::size_t k = 0; k < kLanes; ++k) {
    sums.sum += sum[k];
    sums.squares += squares[k];
  }
  for (std::size_t i = whole; i < values.size(); ++i) {
    sums.sum += values[i];
    sums.squares += static_cast<double>(values[i]) * values[i];
  }
  return sums;
}

// The standardised value z of a distance: its difference from the mean of all distances of a step,
// in standard deviations.

class UsualDistance {
 public:
  explicit UsualDistance(const Sums& sums)
      : mean_(sums.mean()), deviation_(sums.deviationWithPrior(kPriorViews, kPriorDeviation)) {}

  /// Negative: more alike than usual.
  float standardised(float distance) const {
    return std::max(static_cast<float>((distance - mean_) / deviation_), -kLargest);
  }

 private:
  // Prior of the standard deviation, with the weight of kPriorViews views: that of distances
  // between different places (campus walks, day and night). Grids of structure use the same.
  static constexpr double kPriorDeviation = 0.12;
  static constexpr double kPriorViews = 20;
  // Limits the effect of a single view, however similar. Chosen on the walks and a corridor
  // (docs/report/places.md).
  static constexpr float kLargest = 4;

  double mean_;
  double deviation_;
};

// The probability of a place, from its cost and that of its rivals.

/// Largest difference of the indices of two stored views that show the same place. Chosen, not
/// tuned.
inline constexpr std::int64_t kSamePlace = 10;
/// Largest distance (m) between a place and a pose that its landmarks measure. Views with landmarks
/// are 4 m apart, so one of them is nearer. Chosen on the town's 06 and 07, where all poses beyond
/// 15 m were of views further along the same street, with errors of metres.
inline constexpr double kFarthestPose = 6;
/// Cost of the hypothesis that the robot is at no known place. Chosen on the same data as
/// kNatsPerCost.
inline constexpr double kCostOfNovelty = -4;

/// Posterior probability of the place with this cost (lower: more likely) against the alternatives
/// whose costs are `rivals`: the best other place, the views of 10 to 20 m ago, and no known place.
/// kNatsPerCost was chosen on 1,241 right and 724 wrong best places of campus walks
/// (places_gardens, six pairs of passes, whole and in halves) and on two drives in the town (06,
/// 07); checked on a corridor (places_two_laps) and the drives 00 and 05.
inline double probabilityOf(double cost, std::initializer_list<double> rivals) {
  constexpr double kNatsPerCost = 0.7;
  double odds_against = 0;
  for (const double rival : rivals) odds_against += std::exp(kNatsPerCost * (cost - rival));
  return 1 / (1 + odds_against);
}

// The cost of every stored view as the present place, added up along the driven path (lower: more
// likely): a Viterbi recursion over the stored sequences. SeqSLAM (Milford and Wyeth, ICRA 2012)
// adds up differences along lines of constant speed; here steps of driven metres replace them. For
// stored view p at step t
//   C_t(p) = z_t(p) + offset + memory * min(0, min_k(C_{t-1}(p - k) + penalty * |k - advance|))
// where k is 0 to 3 views, t counts the steps of at least one spacing along the driven path, z is
// the standardised distance of the view (negative: more alike than usual), and `advance` the length
// of the step in spacings of stored views. Crossing a link between two sequences costs as much as
// moving by one view. -offset lies between the z of a right and that of a wrong place: only a right
// place lowers the cost. A cost above 0 counts as 0 in the next step (as in Page's CUSUM test), so
// that the costs return to 0 within a few steps after the robot has left the known path. On a path
// that is driven in the opposite direction the order of views is reversed: p + k instead of p - k.

enum class Direction : std::uint8_t { Forwards, Backwards };

/// Chosen on `places_gardens` (first half) and `places_two_laps`; docs/report/places.md has the
/// measurements.
struct PathCostSettings {
  double memory = 0.92;                       ///< factor per step
  double penalty = 1.5;                       ///< per view that a step differs from `advance`
  double offset = 1.4;                        ///< per step
  Direction direction = Direction::Forwards;  ///< in which the stored paths are driven at present
};

class PathCost {
 public:
  explicit PathCost(const PathCostSettings& settings) : settings_(settings) {}

  /// Adds a stored view. `predecessor` is the view before it on the path: usually the one stored
  /// before it, an older one where the path left a known one, or -1 for none.
  void add(std::int64_t predecessor);
  /// Links a stored view to an older one, where the path came back to a known path.
  void join(std::int64_t from, std::int64_t to);
  /// One step: `standardised` has z for every stored view. Only the first `candidates` views pass
  /// their cost on to another sequence, because the similarity of the present view to recent ones
  /// is no evidence for an older place.
  void step(std::span<const float> standardised, double advance, std::int64_t candidates);
  /// Adds `change` to the cost of one view, as if its z were different by this.
  void correct(std::int64_t view, float change);
  /// Sets all costs to 0, because the position is unknown.
  void forget();

  std::span<const float> cost() const { return cost_; }

  void save(StateWriter& writer) const;
  bool load(StateReader& reader, std::int64_t views);

 private:
  struct SequenceLink {
    std::int64_t from;
    std::int64_t to;
  };

  PathCostSettings settings_;
  std::vector<float> cost_;
  std::vector<float> before_;         ///< working memory: the cost of the previous step
  std::vector<std::int64_t> starts_;  ///< first view of each stored sequence
  std::vector<SequenceLink> links_;   ///< between sequences
};

}  // namespace tolman::view_sequences
