// SPDX-License-Identifier: BSD-3-Clause
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
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tolman/state_stream.hpp"

namespace tolman::view_sequences {

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
