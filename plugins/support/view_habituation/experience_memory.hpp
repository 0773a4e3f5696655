// SPDX-License-Identifier: BSD-3-Clause
// The decision of RatSLAM and of NeuroSLAM: whether a view, seen at this place of the network,
// makes a new experience or belongs to a known one.
#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <tolman/records.hpp>
#include <utility>
#include <vector>

namespace tolman {

/// `Place`: a position in the network.
template <class Place>
class ExperienceMemory {
 public:
  using Distance = std::function<double(const Place&, const Place&)>;

  /// `threshold`, in cells, separates experiences.
  ExperienceMemory(double threshold, Distance distance)
      : threshold_(threshold), distance_(std::move(distance)) {}

  /// Decides for a view seen at `here`: create an experience, close a loop to the nearest old one
  /// of the same view that is nearer than the threshold, or stay.
  Action decide(const Place& here, std::int64_t template_id) {
    const bool changed = template_id != previous_template_;
    previous_template_ = template_id;
    const auto attached = of_template_.find(template_id);
    if (current_ < 0 || attached == of_template_.end()) return create(here, template_id);
    const auto away = [&](std::int64_t id) {
      return distance_(here, places_[static_cast<std::size_t>(id)]);
    };
    if (!changed && away(current_) <= threshold_) return Action::Stay;
    const std::int64_t nearest = *std::ranges::min_element(attached->second, {}, away);
    if (away(nearest) >= threshold_) return create(here, template_id);
    return std::exchange(current_, nearest) == nearest ? Action::Stay : Action::CloseLoop;
  }
  /// The first experience, without a view.
  Action createFirst(const Place& here) { return create(here, -1); }

  std::int64_t current() const { return current_; }  ///< -1 before the first

 private:
  Action create(const Place& place, std::int64_t template_id) {
    current_ = static_cast<std::int64_t>(places_.size());
    places_.push_back(place);
    if (template_id >= 0) of_template_[template_id].push_back(current_);
    return Action::CreateExperience;
  }

  double threshold_;
  Distance distance_;
  std::vector<Place> places_;  ///< of the experiences
  std::map<std::int64_t, std::vector<std::int64_t>> of_template_;
  std::int64_t current_ = -1;
  std::int64_t previous_template_ = -1;
};

}  // namespace tolman
