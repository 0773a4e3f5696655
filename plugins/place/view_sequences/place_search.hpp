// SPDX-License-Identifier: BSD-3-Clause
// Finds the robot on the stored paths: compares the present view with the stored ones, adds up
// costs along the path, and computes the probabilities of the best places.
#pragma once

#include <cstdint>
#include <vector>

#include "path_cost.hpp"
#include "place_codes.hpp"

namespace tolman::view_sequences {

struct SearchSettings {
  std::int64_t exhaustive = 4000;  ///< with more views, codes choose which ones are compared
  double recent = 20;              ///< m of path: newer views are not candidates
  PathCostSettings cost;
};

struct PlaceCandidate {
  std::int64_t view = -1;
  double probability = 0;  ///< that the robot is there
};

class PlaceSearch {
 public:
  explicit PlaceSearch(const SearchSettings& settings)
      : settings_(settings), cost_(settings.cost) {}

  const ViewBank& bank() const { return bank_; }
  /// Stores a view; `predecessor` as for PathCost::add().
  void add(const PackedView& view, double path, std::int64_t predecessor);
  void join(std::int64_t from, std::int64_t to) { cost_.join(from, to); }
  /// The next views are of another time or place.
  void beginPass();

  /// One step along the path: `path` in m so far, `advance` in stored views.
  void step(const ViewQuery& query, double path, double advance);
  static constexpr int kMaxPlaces = 5;  // bounds the time of landmarks
  /// At most `most` places after a step, kMaxPlaces or fewer, the most probable first; different
  /// places are more than ten views apart. Empty as long as there is too little to compare with.
  std::vector<PlaceCandidate> candidates(int most) const;

  void save(StateWriter& writer) const;
  bool load(StateReader& reader);

 private:
  void compareAll(const ViewQuery& query);
  void compareFrom(const ViewQuery& query, std::int64_t first);
  void refineBest(const ViewQuery& query);
  Sums sumsOfBits(std::int64_t count) const;
  std::vector<float> distancesOf(const ViewQuery& query, const std::vector<std::int64_t>& views);
  std::vector<std::int64_t> bestViews(std::size_t count) const;
  float costOf(std::int64_t view) const { return cost_.cost()[static_cast<std::size_t>(view)]; }
  std::int64_t coded() const;
  std::int64_t viewsUntil(double path) const;

  SearchSettings settings_;
  ViewBank bank_;
  PlaceCodes codes_;
  PathCost cost_;
  std::int64_t candidates_ = 0;     ///< number of views that are not recent, the first ones
  float cost_of_recent_ = 0;        ///< best of the older half of the recent views
  std::vector<std::int64_t> best_;  ///< after a step, the views of lowest cost, in order
  std::vector<std::uint16_t> bits_;
  std::vector<float> distances_;  ///< of all views, standardised by compareAll()
};

/// Distance of `view` and its shift in cells, interpolated between the tried ones.
struct MeasuredShift {
  double distance = 2;
  double moved_left = 0;
};
MeasuredShift shiftOf(const ViewQuery& query, const ViewBank& bank, std::int64_t view);

}  // namespace tolman::view_sequences
