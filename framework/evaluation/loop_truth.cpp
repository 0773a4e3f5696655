// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/loop_truth.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "tolman/fields.hpp"

namespace tolman::dataset {
namespace {

double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

/// The best candidates of one frame, one for each heading.
class Nearest {
 public:
  Nearest(const evaluation::Trajectory& truth, std::size_t frame, const RevisitRule& rule)
      : truth_(truth),
        pose_(truth[frame].T_world_camera),
        frame_(truth[frame].frame),
        rule_(rule) {}

  void consider(std::size_t index) {
    const Eigen::Isometry3d& other = truth_[index].T_world_camera;
    if (!isSamePlace(other, pose_, rule_)) return;
    const double distance = (other.translation() - pose_.translation()).norm();
    const std::optional<Heading> heading = headingBetween(other, pose_, rule_);
    if (heading == Heading::Same) take(best_[0], Heading::Same, index, distance);
    if (heading == Heading::Opposite) take(best_[1], Heading::Opposite, index, distance);
  }

  void append(std::vector<Revisit>& revisits) const {
    for (const auto& best : best_) {
      if (best) revisits.push_back(*best);
    }
  }

 private:
  void take(std::optional<Revisit>& best, Heading heading, std::size_t index,
            double distance) const {
    const std::int64_t earlier = truth_[index].frame;
    const bool better = !best || distance < best->distance_m ||
                        (distance == best->distance_m && earlier < best->earlier);
    if (better) best = Revisit{frame_, earlier, heading, distance};
  }

  const evaluation::Trajectory& truth_;
  const Eigen::Isometry3d& pose_;
  std::int64_t frame_;
  const RevisitRule& rule_;
  std::array<std::optional<Revisit>, 2> best_;
};

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

std::vector<Revisit> findRevisits(const evaluation::Trajectory& truth, const RevisitRule& rule) {
  std::vector<Revisit> revisits;
  if (!(rule.distance_m > 0)) return revisits;
  const std::vector<double> driven = evaluation::distances(truth);
  std::size_t known = 0;  // number of poses that are far enough back along the path
  for (std::size_t i = 0; i < truth.size(); ++i) {
    while (known < i && driven[i] - driven[known] > rule.path_m) ++known;
    Nearest nearest(truth, i, rule);
    for (std::size_t earlier = 0; earlier < known; ++earlier) nearest.consider(earlier);
    nearest.append(revisits);
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

}  // namespace tolman::dataset
