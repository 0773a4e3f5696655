// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/loops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "tolman/fields.hpp"

namespace tolman::evaluation {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

constexpr double kSamePlace = 10;  // m
constexpr double kNearLoop = 5.5;  // m of driven path

/// True position and driven path at each frame.
class TruePlaces {
 public:
  TruePlaces(const Trajectory& truth, double storey_height)
      : driven_(distances(truth)), storey_height_(storey_height) {
    for (std::size_t i = 0; i < truth.size(); ++i) {
      places_[truth[i].frame] = {truth[i].T_world_camera.translation(), driven_[i]};
    }
  }
  /// Nothing where one of the frames has no true pose.
  std::optional<bool> same(std::int64_t a, std::int64_t b) const {
    const auto first = places_.find(a);
    const auto second = places_.find(b);
    if (first == places_.end() || second == places_.end()) return std::nullopt;
    const Eigen::Vector3d apart = first->second.position - second->second.position;
    if (storey_height_ > 0 && std::abs(apart.y()) > storey_height_) return false;
    return apart.norm() <= kSamePlace;
  }
  double driven(std::int64_t frame) const { return places_.at(frame).driven; }

 private:
  struct TruePosition {
    Eigen::Vector3d position;
    double driven = 0;  ///< m
  };
  std::vector<double> driven_;
  double storey_height_;  ///< m; 0: none
  std::map<std::int64_t, TruePosition> places_;
};

/// Counts links; returns the driven path (m) at each true loop.
std::vector<double> countLinks(const MapGraph& graph, const TruePlaces& truth,
                               LoopFigures& figures) {
  std::vector<double> closed;
  const auto frameOf = [&](std::int64_t experience) {
    return graph.experiences.at(static_cast<std::size_t>(experience)).frame;
  };
  for (const Link& link : graph.links) {
    if (link.kind != LinkKind::Loop) continue;
    const auto same = truth.same(frameOf(link.from), frameOf(link.to));
    if (!graph.isRejected(link)) {
      ++(!same ? figures.unknown_links : *same ? figures.true_links : figures.false_links);
    }
    const std::int64_t visited = std::min(frameOf(link.from), frameOf(link.to));
    if (truth.same(link.frame, visited).value_or(false)) closed.push_back(truth.driven(link.frame));
  }
  return closed;
}

void countViews(const std::vector<PlaceObservation>& places, const TruePlaces& truth,
                const std::vector<double>& closed, LoopFigures& figures) {
  std::map<std::int64_t, std::int64_t> learned;  // frame of the novel view by template
  for (const PlaceObservation& place : places) {
    if (place.recognition == Recognition::Novel)
      learned.try_emplace(place.template_id, place.frame);
    const auto old = learned.find(place.template_id);
    if (place.recognition != Recognition::Familiar) continue;
    const auto same = old == learned.end() ? std::nullopt : truth.same(place.frame, old->second);
    if (!same) {
      ++figures.unknown_views;
      continue;
    }
    ++(*same ? figures.true_views : figures.false_views);
    const bool is_closed = *same && std::ranges::any_of(closed, [&](double at) {
      return std::abs(truth.driven(place.frame) - at) <= kNearLoop;
    });
    if (is_closed) ++figures.true_views_closed;
  }
}

}  // namespace

std::optional<Heading> headingBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                                      const RevisitRule& rule) {
  const double agreement = a.linear().col(2).dot(b.linear().col(2));
  if (agreement > cosine(rule.same_below_deg)) return Heading::Same;
  if (agreement < cosine(rule.opposite_above_deg)) return Heading::Opposite;
  return std::nullopt;
}

bool isSamePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const RevisitRule& rule) {
  const Eigen::Vector3d apart = a.translation() - b.translation();
  const bool same_height = !(rule.height_m > 0) || std::abs(apart.y()) <= rule.height_m;
  return same_height && apart.norm() <= rule.distance_m;
}

std::vector<Revisit> findRevisits(const Trajectory& truth, const RevisitRule& rule) {
  std::vector<Revisit> revisits;
  if (!(rule.distance_m > 0)) return revisits;
  const std::vector<double> driven = distances(truth);
  std::size_t known = 0;  // number of poses that are far enough back along the path
  for (std::size_t i = 0; i < truth.size(); ++i) {
    while (known < i && driven[i] - driven[known] > rule.path_m) ++known;
    const Eigen::Isometry3d& pose = truth[i].T_world_camera;
    std::array<std::optional<Revisit>, 2> nearest;  // by heading
    for (std::size_t k = 0; k < known; ++k) {
      const Eigen::Isometry3d& other = truth[k].T_world_camera;
      const auto heading =
          isSamePlace(other, pose, rule) ? headingBetween(other, pose, rule) : std::nullopt;
      if (!heading) continue;
      const double distance = (other.translation() - pose.translation()).norm();
      auto& best = nearest.at(static_cast<std::size_t>(*heading));
      if (best && distance >= best->distance_m) continue;  // of equally near ones the earliest
      best = Revisit{truth[i].frame, truth[k].frame, *heading, distance};
    }
    for (const auto& best : nearest) {
      if (best) revisits.push_back(*best);
    }
  }
  return revisits;
}

std::string loopsText(std::span<const Revisit> revisits, const RevisitRule& rule) {
  std::string text = fmt::format(
      "# frame earlier same|opposite distance_m; within {:g} m after more than {:g} m\n",
      rule.distance_m, rule.path_m);
  for (const Revisit& r : revisits) {
    text += fmt::format("{} {} {} {:.3f}\n", r.frame, r.earlier, enumName(r.heading), r.distance_m);
  }
  return text;
}

LoopFigures loopFigures(const MapGraph& graph, const std::vector<PlaceObservation>& places,
                        const Trajectory& truth, double storey_height) {
  const TruePlaces true_places(truth, storey_height);
  LoopFigures figures;
  const std::vector<double> closed = countLinks(graph, true_places, figures);
  countViews(places, true_places, closed, figures);
  return figures;
}

nlohmann::ordered_json toJson(const LoopFigures& figures) {
  return {{"true_links", figures.true_links},
          {"false_links", figures.false_links},
          {"true_views", figures.true_views},
          {"false_views", figures.false_views},
          {"true_views_closed", figures.true_views_closed},
          {"unknown_links", figures.unknown_links},
          {"unknown_views", figures.unknown_views}};
}

std::vector<PrecisionRecall> precisionRecall(std::vector<PlaceClaim> claims,
                                             std::int64_t findable) {
  std::ranges::stable_sort(claims, {}, &PlaceClaim::score);
  std::vector<PrecisionRecall> curve;
  std::int64_t right = 0;
  for (std::size_t i = 0; i < claims.size(); ++i) {
    right += claims[i].right ? 1 : 0;
    if (i + 1 < claims.size() && claims[i + 1].score == claims[i].score) continue;
    const auto made = static_cast<std::int64_t>(i + 1);
    curve.push_back(
        {claims[i].score, made, static_cast<double>(right) / static_cast<double>(made),
         findable > 0 ? static_cast<double>(right) / static_cast<double>(findable) : 0});
  }
  return curve;
}

double recallAt(const std::vector<PrecisionRecall>& curve, double precision) {
  double recall = 0;
  for (const PrecisionRecall& point : curve) {
    if (point.precision >= precision) recall = std::max(recall, point.recall);
  }
  return recall;
}

}  // namespace tolman::evaluation
