// SPDX-License-Identifier: BSD-3-Clause
// Where each view was first seen, and how much its cell has habituated: a view that is seen again
// and again injects less energy, and none at last, so that one view cannot hold the network in
// place. RatSLAM's rule, which the paper takes over.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>

namespace tolman {

/// The defaults are OpenRatSLAM's (for St Lucia).
struct HabituationSettings {
  double energy = 1;         ///< that a view without habituation injects
  double resting_decay = 1;  ///< initial and lowest decay of a view, and its increase when the view
                             ///< is repeated at once
  double restore = 0.04;     ///< of the decay, per view
  int newest_ignored = 0;    ///< this many of the newest views inject nothing
  int first_ignored = 0;     ///< nothing is injected until so many views were seen
};

/// `Place`: a position in the network.
template <class Place>
class HabituatingViews {
 public:
  explicit HabituatingViews(const HabituationSettings& settings) : settings_(settings) {}

  struct Injection {
    Place place;  ///< where the view was first seen
    double energy = 0;
  };
  /// One view: a new one is linked to `here`; a known one injects, unless it is too new or its cell
  /// has habituated.
  std::optional<Injection> see(std::int64_t template_id, const Place& here) {
    ++seen_;
    const bool repeated = template_id == previous_;
    previous_ = template_id;
    const auto count = static_cast<std::int64_t>(views_.size());
    const auto [found, fresh] =
        views_.try_emplace(template_id, View{here, count, settings_.resting_decay, seen_});
    if (fresh) return std::nullopt;
    View& view = found->second;
    recover(view);
    if (repeated) view.decay += settings_.resting_decay;
    const bool too_new = view.order >= std::max(settled_, count - settings_.newest_ignored);
    if (too_new || seen_ <= settings_.first_ignored) return std::nullopt;
    // Falls as an exponential of the decay, to nothing at ln(30) / 1.2 = 2.8; OpenRatSLAM's.
    const double energy = settings_.energy * (30 - std::exp(1.2 * view.decay)) / 30;
    if (!(energy > 0)) return std::nullopt;
    return Injection{view.place, energy};
  }
  /// Where a view was first seen; null for one that was never seen.
  Place* find(std::int64_t template_id) {
    const auto found = views_.find(template_id);
    return found == views_.end() ? nullptr : &found->second.place;
  }
  /// The robot was carried to an unknown place: no view so far is too new any more.
  void startPart() { settled_ = static_cast<std::int64_t>(views_.size()); }

 private:
  struct View {
    Place place;
    std::int64_t order = 0;  ///< of its first sight among the views
    double decay = 1;
    std::int64_t last_seen = 0;
  };

  /// All views recover with each view; counted only when one is looked at.
  void recover(View& view) const {
    const auto rested = static_cast<double>(seen_ - view.last_seen);
    view.decay = std::max(settings_.resting_decay, view.decay - settings_.restore * rested);
    view.last_seen = seen_;
  }

  HabituationSettings settings_;
  std::map<std::int64_t, View> views_;
  std::int64_t seen_ = 0;
  std::int64_t previous_ = -1;
  std::int64_t settled_ = 0;  ///< number of views from before the last gap
};

}  // namespace tolman
