// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/loop_truth.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>
#include <unordered_map>

#include "tolman/fields.hpp"

namespace tolman::evaluation {
namespace {

/// Poses by square cells of the x-z plane, as wide as the search radius: whatever is within the
/// radius lies in the cell of the query or one of its eight neighbours.
class Cells {
 public:
  explicit Cells(double width_m) : width_m_(width_m) {}

  void add(const Eigen::Vector3d& position, std::size_t index) {
    cells_[key(column(position.x()), column(position.z()))].push_back(index);
  }

  template <class Visit>
  void visitNear(const Eigen::Vector3d& position, Visit&& visit) const {
    const std::int64_t x = column(position.x());
    const std::int64_t z = column(position.z());
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dz = -1; dz <= 1; ++dz) {
        const auto cell = cells_.find(key(x + dx, z + dz));
        if (cell == cells_.end()) continue;
        for (const std::size_t index : cell->second) visit(index);
      }
    }
  }

 private:
  std::int64_t column(double coordinate_m) const {
    constexpr double kMost = 1e15;  // beyond it all share a cell, which costs time only
    return static_cast<std::int64_t>(
        std::clamp(std::floor(coordinate_m / width_m_), -kMost, kMost));
  }
  /// Far cells may share a key; distances are measured anyway.
  static std::uint64_t key(std::int64_t x, std::int64_t z) {
    return static_cast<std::uint64_t>(x) << 32U ^ (static_cast<std::uint64_t>(z) & 0xffffffffU);
  }

  double width_m_;
  std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

/// The best candidates of one frame, one for each heading.
class Nearest {
 public:
  Nearest(const Trajectory& truth, std::size_t frame, const RevisitRule& rule)
      : truth_(truth),
        pose_(truth[frame].T_world_camera),
        frame_(truth[frame].frame),
        rule_(rule),
        same_above_(cosine(rule.same_below_deg)),
        opposite_below_(cosine(rule.opposite_above_deg)) {}

  void consider(std::size_t index) {
    const Eigen::Isometry3d& other = truth_[index].T_world_camera;
    const double distance = (other.translation() - pose_.translation()).norm();
    if (!(distance <= rule_.distance_m)) return;
    const double agreement = other.linear().col(2).dot(pose_.linear().col(2));
    if (agreement > same_above_) take(best_[0], Heading::Same, index, distance);
    if (agreement < opposite_below_) take(best_[1], Heading::Opposite, index, distance);
  }

  void append(std::vector<Revisit>& revisits) const {
    for (const auto& best : best_) {
      if (best) revisits.push_back(*best);
    }
  }

 private:
  static double cosine(double degrees) { return std::cos(degrees * std::numbers::pi / 180); }

  void take(std::optional<Revisit>& best, Heading heading, std::size_t index,
            double distance) const {
    const std::int64_t earlier = truth_[index].frame;
    const bool better = !best || distance < best->distance_m ||
                        (distance == best->distance_m && earlier < best->earlier);
    if (better) best = Revisit{frame_, earlier, heading, distance};
  }

  const Trajectory& truth_;
  const Eigen::Isometry3d& pose_;
  std::int64_t frame_;
  const RevisitRule& rule_;
  double same_above_;
  double opposite_below_;
  std::array<std::optional<Revisit>, 2> best_;
};

}  // namespace

std::vector<Revisit> findRevisits(const Trajectory& truth, const RevisitRule& rule) {
  std::vector<Revisit> revisits;
  if (!(rule.distance_m > 0)) return revisits;
  const std::vector<double> driven = distances(truth);
  Cells cells(rule.distance_m);
  std::size_t known = 0;  // poses that lie far enough back along the path; standing still adds none
  for (std::size_t i = 0; i < truth.size(); ++i) {
    for (; known < i && driven[i] - driven[known] > rule.path_m; ++known) {
      cells.add(truth[known].T_world_camera.translation(), known);
    }
    Nearest nearest(truth, i, rule);
    cells.visitNear(truth[i].T_world_camera.translation(),
                    [&](std::size_t index) { nearest.consider(index); });
    nearest.append(revisits);
  }
  return revisits;
}

std::string loopsText(std::span<const Revisit> revisits, const RevisitRule& rule) {
  char line[160];
  std::snprintf(line, sizeof line,
                "# frame earlier same|opposite distance_m; within %g m after more than %g m\n",
                rule.distance_m, rule.path_m);
  std::string text = line;
  for (const Revisit& r : revisits) {
    std::snprintf(line, sizeof line, "%lld %lld %s %.3f\n", static_cast<long long>(r.frame),
                  static_cast<long long>(r.earlier), enumName(r.heading).data(), r.distance_m);
    text += line;
  }
  return text;
}

}  // namespace tolman::evaluation
