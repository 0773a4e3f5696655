// SPDX-License-Identifier: BSD-3-Clause
// NeuroSLAM's decision: whether a view, seen at this place of the network, makes a new experience
// or belongs to a known one.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "tolman/records.hpp"

namespace tolman::neuroslam_cells {

/// Place of both networks, in cells; each axis is periodic.
struct ConjunctivePlace {
  double x = 0;
  double y = 0;
  double height = 0;
  double heading = 0;
};

struct Periods {
  double side = 36;
  double headings = 36;
};

/// Shortest distance over all axes, in cells.
double distance(const ConjunctivePlace& a, const ConjunctivePlace& b, const Periods& periods);

class ExperienceMemory {
 public:
  ExperienceMemory(double threshold, const Periods& periods)
      : threshold_(threshold), periods_(periods) {}

  /// Decides for a view seen at `here`: create an experience, close a loop to an old one of the
  /// same view that is nearer than the threshold, or stay.
  Action decide(const ConjunctivePlace& here, std::int64_t template_id);
  /// The first experience, without a view.
  Action createFirst(const ConjunctivePlace& here) { return create(here, -1); }

  std::int64_t current() const { return current_; }  ///< -1 before the first

 private:
  Action create(const ConjunctivePlace& place, std::int64_t template_id);

  double threshold_;
  Periods periods_;
  std::vector<ConjunctivePlace> places_;  ///< of the experiences
  std::map<std::int64_t, std::vector<std::int64_t>> of_template_;
  std::int64_t current_ = -1;
  std::int64_t previous_template_ = -1;
};

}  // namespace tolman::neuroslam_cells
