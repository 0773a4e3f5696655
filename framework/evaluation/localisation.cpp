// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/localisation.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::evaluation {
namespace {

using Search = LocalisationFigures::Search;

/// Median over the searches that ended.
double medianOf(const std::vector<Search>& searches, double Search::*number) {
  std::vector<double> numbers;
  for (const Search& search : searches) {
    if (search.found) numbers.push_back(search.*number);
  }
  return statistics(numbers).median;
}

}  // namespace

LocalisationCounter::LocalisationCounter(const std::vector<Experience>& experiences,
                                         const Trajectory& truth)
    : experiences_(experiences) {
  for (const TrajectoryPose& pose : truth) truth_[pose.frame] = &pose.T_world_camera;
}

std::optional<double> LocalisationCounter::errorOf(const MapUpdate& update) const {
  const auto at = static_cast<std::size_t>(update.experience);
  if (at >= experiences_.size()) return std::nullopt;
  const auto then = truth_.find(experiences_[at].frame);
  const auto now = truth_.find(update.frame);
  if (then == truth_.end() || now == truth_.end()) return std::nullopt;
  const Eigen::Isometry3d true_pose = then->second->inverse() * *now->second;
  return (true_pose.translation() - update.T_experience_camera.translation()).norm();
}

void LocalisationCounter::add(const Motion& motion, const MapUpdate& update) {
  auto& searches = figures_.searches;
  const bool searched = !searches.empty() && !searches.back().found;
  if (update.experience >= 0) {
    if (searched) searches.back().found = true;
    if (motion.state == TrackingState::Lost) {
      ++figures_.lost;
      return;
    }
    ++figures_.found;
    if (const auto error = errorOf(update)) {
      errors_.push_back(*error);
      if (*error > kWrongPlace) ++figures_.wrong;
    }
    return;
  }
  ++(motion.state == TrackingState::Lost ? figures_.lost : figures_.unknown);
  if (!searched) {
    searches.push_back({.first_frame = motion.frame});
  } else {
    ++searches.back().frames;
    searches.back().seconds += motion.dt;
    searches.back().metres += motion.T_previous_current.translation().norm();
  }
}

LocalisationFigures LocalisationCounter::figures() const {
  LocalisationFigures figures = figures_;
  figures.error_m = statistics(errors_);
  return figures;
}

std::string localisationText(const LocalisationFigures& f) {
  const auto found = std::ranges::count_if(f.searches, &Search::found);
  std::string text = fmt::format("found in {} of {} frames, unknown in {}, odometry lost in {}",
                                 f.found, f.found + f.unknown + f.lost, f.unknown, f.lost);
  text += fmt::format("; found itself {} of {} times", found, f.searches.size());
  if (found > 0) {
    text +=
        fmt::format(", after {:.1f} m and {:.1f} s (median)", medianOf(f.searches, &Search::metres),
                    medianOf(f.searches, &Search::seconds));
  }
  if (f.error_m.count == 0) return text;
  text += fmt::format("; error median {:.2f}, 90 % {:.2f} m", f.error_m.median, f.error_m.p90);
  return text + (f.wrong == 0 ? fmt::format("; never wrong by more than {:.0f} m", kWrongPlace)
                              : fmt::format("; WRONG by more than {:.0f} m in {} frames",
                                            kWrongPlace, f.wrong));
}

nlohmann::ordered_json toJson(const LocalisationFigures& f) {
  nlohmann::ordered_json searches = nlohmann::ordered_json::array();
  for (const Search& s : f.searches) {
    searches.push_back({{"first_frame", s.first_frame},
                        {"frames", s.frames},
                        {"seconds", s.seconds},
                        {"metres", s.metres},
                        {"found", s.found}});
  }
  nlohmann::ordered_json json = {{"map", f.map},
                                 {"found", f.found},
                                 {"unknown", f.unknown},
                                 {"lost", f.lost},
                                 {"searches", std::move(searches)}};
  if (f.error_m.count == 0) {
    json["reason"] = f.reason;
    return json;
  }
  json["error_m"] = {{"median", f.error_m.median}, {"p90", f.error_m.p90}, {"max", f.error_m.max}};
  json["wrong"] = f.wrong;
  return json;
}

}  // namespace tolman::evaluation
