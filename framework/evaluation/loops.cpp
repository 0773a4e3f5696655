// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/loops.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "tolman/fields.hpp"

namespace tolman::evaluation {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

constexpr double kSamePlace = 10;  // m
constexpr double kNearLoop = 5.5;  // m of driven path
// Of a measured pose. The truth of a drive is itself off by about a metre from pass to pass.
constexpr double kWrongPose = 1;    // m
constexpr double kWrongSigmas = 5;  // standard deviations

/// True pose and driven path at each frame.
class TruePlaces {
 public:
  TruePlaces(const Trajectory& truth, double storey_height)
      : rule_{.distance_m = kSamePlace, .height_m = storey_height} {
    const std::vector<double> driven = distances(truth);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      places_[truth[i].frame] = {truth[i].T_world_camera, driven[i]};
    }
  }
  /// Null where there is none.
  const Eigen::Isometry3d* poseOf(std::int64_t frame) const {
    const auto found = places_.find(frame);
    return found == places_.end() ? nullptr : &found->second.first;
  }
  std::optional<bool> same(std::int64_t a, std::int64_t b) const {
    const Eigen::Isometry3d *first = poseOf(a), *second = poseOf(b);
    if (first == nullptr || second == nullptr) return std::nullopt;
    return isSamePlace(*first, *second, rule_);
  }
  double driven(std::int64_t frame) const { return places_.at(frame).second; }  ///< m

 private:
  RevisitRule rule_;
  std::map<std::int64_t, std::pair<Eigen::Isometry3d, double>> places_;
};

/// Compares a measured pose with the true one.
void judgePose(const PlaceObservation& view, const Eigen::Isometry3d& then,
               const Eigen::Isometry3d& now, double storey_height, JudgedLoop& loop) {
  const Eigen::Isometry3d error = view.T_template_current.inverse() * (then.inverse() * now);
  const Eigen::Vector3d off = error.translation();
  loop.error_m = off.norm();
  const Eigen::Matrix3d covariance = view.covariance.topLeftCorner<3, 3>();
  loop.error_sigmas = std::sqrt(std::max(0.0, off.dot(covariance.ldlt().solve(off))));
  const double height = (now.linear() * off).y();
  const bool other_storey = storey_height > 0 && std::abs(height) > storey_height;
  const bool wrong = off.norm() > kWrongPose && *loop.error_sigmas > kWrongSigmas;
  loop.is_true = !other_storey && !wrong && off.norm() <= kSamePlace;
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

std::map<std::int64_t, std::int64_t> framesOfTemplates(
    const std::vector<PlaceObservation>& places) {
  std::map<std::int64_t, std::int64_t> learned;
  for (const PlaceObservation& place : places) {
    if (place.recognition == Recognition::Novel) {
      learned.try_emplace(place.template_id, place.frame);
    }
  }
  return learned;
}

std::vector<JudgedLoop> judgeLoops(const MapGraph& graph,
                                   const std::vector<PlaceObservation>& places,
                                   const Trajectory& truth, double storey_height) {
  const TruePlaces true_places(truth, storey_height);
  const auto learned = framesOfTemplates(places);
  std::map<std::int64_t, const PlaceObservation*> views;
  const bool turned = hasOrientations(truth);
  for (const PlaceObservation& place : places) {
    const bool measured = place.recognition == Recognition::Familiar && place.has_relative_pose;
    if (turned && measured) views[place.frame] = &place;
  }
  const auto frameOf = [&](std::int64_t experience) {
    return graph.experiences.at(static_cast<std::size_t>(experience)).frame;
  };
  std::vector<JudgedLoop> loops;
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    const Link& link = graph.links[i];
    if (link.kind != LinkKind::Loop) continue;
    JudgedLoop& loop = loops.emplace_back();
    loop.link = link.id;
    loop.frame = link.frame;
    loop.earlier = std::min(frameOf(link.from), frameOf(link.to));
    loop.rejected = graph.isRejected(link);
    if (i < graph.residuals.size()) loop.residual = graph.residuals[i];
    const std::int64_t from = frameOf(link.from), to = frameOf(link.to);
    loop.is_true = true_places.same(from, to);
    if (loop.is_true) {
      loop.apart_m =
          (true_places.poseOf(to)->translation() - true_places.poseOf(from)->translation()).norm();
    }
    const auto view = views.find(link.frame);
    const auto then = view == views.end() ? learned.end() : learned.find(view->second->template_id);
    if (then == learned.end()) continue;
    const Eigen::Isometry3d* here = true_places.poseOf(link.frame);
    const Eigen::Isometry3d* there = true_places.poseOf(then->second);
    if (here != nullptr && there != nullptr) {
      judgePose(*view->second, *there, *here, storey_height, loop);
    }
  }
  return loops;
}

LoopFigures loopFigures(const std::vector<JudgedLoop>& loops,
                        const std::vector<PlaceObservation>& places, const Trajectory& truth,
                        double storey_height) {
  const TruePlaces true_places(truth, storey_height);
  const auto learned = framesOfTemplates(places);
  LoopFigures figures;
  std::vector<double> closed;  // driven path at each true loop, m
  for (const JudgedLoop& loop : loops) {
    const bool known = true_places.poseOf(loop.frame) != nullptr;
    if (known && loop.is_true.value_or(false)) closed.push_back(true_places.driven(loop.frame));
    if (loop.rejected) continue;
    ++(!loop.is_true   ? figures.unknown_links
       : *loop.is_true ? figures.true_links
                       : figures.false_links);
  }
  for (const PlaceObservation& place : places) {
    if (place.recognition != Recognition::Familiar) continue;
    const auto old = learned.find(place.template_id);
    const auto same =
        old == learned.end() ? std::nullopt : true_places.same(place.frame, old->second);
    ++(!same ? figures.unknown_views : *same ? figures.true_views : figures.false_views);
    const auto isNear = [&](double at) {
      return std::abs(true_places.driven(place.frame) - at) <= kNearLoop;
    };
    if (same && *same && std::ranges::any_of(closed, isNear)) ++figures.true_views_closed;
  }
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
