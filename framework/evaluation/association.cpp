// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/association.hpp"

#include <fmt/format.h>

#include <Eigen/SVD>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <tuple>

namespace tolman::evaluation {

namespace {

/// Indices of two poses, of the truth and of the estimate.
struct IndexPair {
  std::size_t truth;
  std::size_t estimate;
};
using IndexPairs = std::vector<IndexPair>;

/// Whether poses `from` and `to` of the estimate have others between them that show a longer way
/// than the straight line. The noise of a robot that stands is none.
bool isBent(const Trajectory& estimate, std::size_t from, std::size_t to) {
  constexpr double kLonger = 0.1;  // of the straight line
  constexpr double kNoise = 0.25;  // m
  if (to <= from + 1) return false;
  const auto position = [&](std::size_t i) -> Eigen::Vector3d {
    return estimate[i].T_world_camera.translation();
  };
  double length = 0;
  for (std::size_t i = from; i < to; ++i) length += (position(i + 1) - position(i)).norm();
  const double straight = (position(to) - position(from)).norm();
  return length - straight > std::max(kLonger * straight, kNoise);
}

/// How many poses at the usual rate of the matches the truth has time for. Its own gaps count not.
std::size_t expectedPoses(const Trajectory& truth, const Trajectory& matched) {
  const auto step = static_cast<double>(medianStep(matched));
  if (!(step > 0)) return truth.size();
  const double longest = 2 * std::max(step, static_cast<double>(medianStep(truth)));
  double poses = 1;
  for (std::size_t i = 1; i < truth.size(); ++i) {
    const auto gap = static_cast<double>(truth[i].stamp_ns - truth[i - 1].stamp_ns);
    poses += gap <= longest ? gap / step : 1;
  }
  return static_cast<std::size_t>(poses + 1e-6);
}

std::size_t nearest(const Trajectory& path, std::int64_t stamp_ns) {
  const auto after = std::ranges::lower_bound(path, stamp_ns, {}, &TrajectoryPose::stamp_ns);
  const auto index = static_cast<std::size_t>(after - path.begin());
  if (index == 0) return 0;
  if (after == path.end()) return index - 1;
  return after->stamp_ns - stamp_ns < stamp_ns - (after - 1)->stamp_ns ? index : index - 1;
}

/// As TUM's program finds it: of two equally near poses the one that is met first.
std::size_t bisected(const Trajectory& path, std::int64_t stamp_ns) {
  const auto apart = [&](std::size_t i) { return std::abs(path[i].stamp_ns - stamp_ns); };
  std::size_t best = 0;
  for (std::size_t low = 0, high = path.size(); low < high;) {
    const std::size_t middle = (low + high) / 2;
    if (apart(middle) < apart(best)) best = middle;
    (path[middle].stamp_ns > stamp_ns ? high : low) =
        path[middle].stamp_ns > stamp_ns ? middle : middle + 1;
  }
  return best;
}

/// For each pose of `each` the nearest of `other`, by `find`: pairs of their indices.
IndexPairs nearestOfEach(const Trajectory& each, const Trajectory& other, std::int64_t limit_ns,
                         std::size_t (*find)(const Trajectory&, std::int64_t) = nearest) {
  IndexPairs pairs;
  for (std::size_t i = 0; i < each.size(); ++i) {
    const std::size_t k = find(other, each[i].stamp_ns);
    if (std::abs(other[k].stamp_ns - each[i].stamp_ns) <= limit_ns) pairs.push_back({k, i});
  }
  return pairs;
}

/// All pairs within the limit, the nearest first; of those the ones that have no pose in common.
IndexPairs oneToOne(const Trajectory& truth, const Trajectory& estimate, std::int64_t limit_ns) {
  const auto apart = [&](const IndexPair& p) {
    return std::abs(truth[p.truth].stamp_ns - estimate[p.estimate].stamp_ns);
  };
  IndexPairs all, pairs;
  for (std::size_t i = 0, first = 0; i < estimate.size(); ++i) {
    while (first < truth.size() && truth[first].stamp_ns < estimate[i].stamp_ns - limit_ns) ++first;
    for (std::size_t k = first; k < truth.size() && apart({k, i}) <= limit_ns; ++k) {
      all.push_back({k, i});
    }
  }
  std::ranges::sort(all, {},
                    [&](const IndexPair& p) { return std::tuple(apart(p), p.truth, p.estimate); });
  std::vector<bool> has_truth(truth.size()), has_estimate(estimate.size());
  for (const IndexPair& p : all) {
    if (has_truth[p.truth] || has_estimate[p.estimate]) continue;
    has_truth[p.truth] = has_estimate[p.estimate] = true;
    pairs.push_back(p);
  }
  std::ranges::sort(pairs, {}, &IndexPair::truth);
  return pairs;
}

IndexPairs byFrame(const Trajectory& truth, const Trajectory& estimate) {
  IndexPairs pairs;
  std::size_t k = 0;
  for (std::size_t i = 0; i < estimate.size(); ++i) {
    while (k < truth.size() && truth[k].frame < estimate[i].frame) ++k;
    if (k == truth.size()) break;
    if (truth[k].frame == estimate[i].frame) pairs.push_back({k, i});
  }
  return pairs;
}

IndexPairs pairsOf(const Trajectory& truth, const Trajectory& estimate, const Matching& matching) {
  switch (matching.rule) {
    case MatchRule::Order:
      return byFrame(truth, estimate);
    case MatchRule::Nearest:
      return oneToOne(truth, estimate, matching.limit_ns);
    case MatchRule::Shorter: {
      if (truth.size() >= estimate.size()) break;
      IndexPairs pairs = nearestOfEach(truth, estimate, matching.limit_ns);
      for (IndexPair& p : pairs) std::swap(p.truth, p.estimate);
      return pairs;
    }
    case MatchRule::Each:
      return nearestOfEach(estimate, truth, matching.limit_ns, bisected);
    case MatchRule::Interpolate:
      break;
  }
  return nearestOfEach(estimate, truth, matching.limit_ns);
}

/// Adds pairs; an interpolated truth where `matching` says so.
class Collector {
 public:
  Collector(const Trajectory& truth, const Trajectory& estimate)
      : truth_(truth), estimate_(estimate), driven_(distances(truth)) {}

  void add(const PoseAt& at, std::size_t of_estimate) {
    TrajectoryPose pose = truth_[at.before];
    pose.T_world_camera = at.T_world_camera;
    double driven = driven_[at.before];
    if (at.share > 0) {
      pose.stamp_ns = estimate_[of_estimate].stamp_ns;
      driven += at.share * (driven_[at.before + 1] - driven);
    }
    const bool is_first = matches_.size() == 0;
    const bool carried = !is_first && matches_.truth.back().session != pose.session;
    const bool gap = !is_first && isBent(estimate_, last_, of_estimate);
    matches_.piece.push_back(is_first ? 0 : matches_.piece.back() + (carried || gap ? 1 : 0));
    matches_.truth.push_back(pose);
    matches_.estimate.push_back(estimate_[of_estimate]);
    matches_.index.push_back(at.before);
    matches_.driven.push_back(driven);
    last_ = of_estimate;
  }

  Result<Matches> result(const Matching& matching) && {
    const bool by_order = matching.rule == MatchRule::Order;
    if (matches_.size() > 0) {
      if (last_ + 1 < estimate_.size()) matches_.after = estimate_[last_ + 1];
      matches_.truth_total =
          by_order ? truth_.size()
                   : std::max(matches_.size(), expectedPoses(truth_, matches_.estimate));
      return std::move(matches_);
    }
    return Status::invalidInput(fmt::format(
        "no pose of the estimate ({}) matches one of the truth ({}) by {}; check that both are of "
        "the same run",
        estimate_.size(), truth_.size(),
        by_order ? "frame index" : fmt::format("stamp within {} ns", matching.limit_ns)));
  }

 private:
  const Trajectory& truth_;
  const Trajectory& estimate_;
  std::vector<double> driven_;
  std::size_t last_ = 0;  ///< index of the last matched estimate
  Matches matches_;
};

}  // namespace

Result<Matches> associate(const Trajectory& truth, const Trajectory& estimate,
                          const Matching& matching) {
  if (truth.empty()) return Status::invalidInput("there is no ground truth");
  if (estimate.empty()) return Status::invalidInput("there is no estimate");
  Collector collector(truth, estimate);
  if (matching.rule == MatchRule::Interpolate) {
    for (std::size_t i = 0; i < estimate.size(); ++i) {
      const auto at = poseAt(truth, estimate[i].stamp_ns, matching.limit_ns);
      if (at) collector.add(*at, i);
    }
  } else {
    for (const IndexPair& p : pairsOf(truth, estimate, matching)) {
      collector.add({truth[p.truth].T_world_camera, p.truth, 0}, p.estimate);
    }
  }
  return std::move(collector).result(matching);
}

Result<Matches> associateByFrame(const Trajectory& truth, const Trajectory& estimate) {
  return associate(truth, estimate, {});
}

std::int64_t usualDifference(const Trajectory& truth, const Trajectory& estimate) {
  constexpr std::int64_t kLeast = 20'000'000;  // ns
  if (!hasStamps(truth) || !hasStamps(estimate)) return -1;
  const bool overlap = truth.front().stamp_ns <= estimate.back().stamp_ns &&
                       estimate.front().stamp_ns <= truth.back().stamp_ns;
  return overlap ? std::max(kLeast, std::min(medianStep(truth), medianStep(estimate)) / 2) : -1;
}

std::int64_t usualGap(const Trajectory& truth) {
  return std::max<std::int64_t>(100'000'000, medianStep(truth) * 5 / 2);
}

namespace {

// Singular values below this share of the largest are rounding errors.
constexpr double kRankTolerance = 1e-10;

/// Rotation between the orientations of the first pair, used where the positions do not move.
Eigen::Matrix3d firstRotation(const Matches& matches) {
  return matches.truth.front().T_world_camera.linear() *
         matches.estimate.front().T_world_camera.linear().transpose();
}

/// The smallest rotation from unit vector `a` to `b`. (Eigen's own function takes ten seconds to
/// compile.)
Eigen::Matrix3d shortestTurn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  const double cosine = a.dot(b);
  if (cosine < -1 + 1e-12) {  // half a turn about any orthogonal axis
    const Eigen::Vector3d axis = a.unitOrthogonal();
    return 2 * axis * axis.transpose() - Eigen::Matrix3d::Identity();
  }
  const Eigen::Vector3d cross = a.cross(b);
  return Eigen::Quaterniond(1 + cosine, cross.x(), cross.y(), cross.z())
      .normalized()
      .toRotationMatrix();
}

/// Umeyama, equations 38-43; `covariance` is truth times estimate transposed.
struct Umeyama {
  Eigen::Matrix3d R;
  double trace;  ///< trace(D S), the numerator of the scale
};

Umeyama umeyama(const Eigen::Matrix3d& covariance, const Eigen::Matrix3d& fallback) {
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(covariance,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Vector3d& d = svd.singularValues();
  if (!(d[0] > 0)) return {fallback, 0};
  if (d[1] <= kRankTolerance * d[0]) {  // a line: the rotation about it is undetermined
    return {shortestTurn(svd.matrixV().col(0), svd.matrixU().col(0)), d[0]};
  }
  Eigen::Vector3d s = Eigen::Vector3d::Ones();
  if (svd.matrixU().determinant() * svd.matrixV().determinant() < 0) s[2] = -1;  // no reflection
  return {svd.matrixU() * s.asDiagonal() * svd.matrixV().transpose(), d.dot(s)};
}

/// The best rotation about an axis, in closed form: the one with the largest trace of R'
/// covariance.
Eigen::Matrix3d rotationAbout(const Eigen::Vector3d& axis, const Eigen::Matrix3d& covariance,
                              const Eigen::Matrix3d& fallback) {
  const auto angle = [&](const Eigen::Matrix3d& m) {
    const Eigen::Vector3d twist(m(2, 1) - m(1, 2), m(0, 2) - m(2, 0), m(1, 0) - m(0, 1));
    const double sine = axis.dot(twist), cosine = m.trace() - axis.dot(m * axis);
    return std::hypot(cosine, sine) > 0 ? std::optional(std::atan2(sine, cosine)) : std::nullopt;
  };
  const auto found = angle(covariance);
  return Eigen::AngleAxisd(found ? *found : angle(fallback).value_or(0), axis).toRotationMatrix();
}

/// The pairs centred on a point of each: its mean, or for Origin its first pose.
struct Centred {
  Centred(const Matches& matches, std::size_t count, bool at_first)
      : truth(positions(matches.truth).leftCols(static_cast<Eigen::Index>(count))),
        estimate(positions(matches.estimate).leftCols(static_cast<Eigen::Index>(count))) {
    truth_centre = at_first ? Eigen::Vector3d(truth.col(0)) : truth.rowwise().mean();
    estimate_centre = at_first ? Eigen::Vector3d(estimate.col(0)) : estimate.rowwise().mean();
    truth.colwise() -= truth_centre;
    estimate.colwise() -= estimate_centre;
  }
  Eigen::Matrix3d covariance() const { return truth * estimate.transpose(); }

  Eigen::Matrix3Xd truth;
  Eigen::Matrix3Xd estimate;
  Eigen::Vector3d truth_centre;
  Eigen::Vector3d estimate_centre;
};

}  // namespace

Eigen::Isometry3d Similarity::apply(const Eigen::Isometry3d& T_world_camera) const {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = R * T_world_camera.linear();
  T.translation() = scale * (R * T_world_camera.translation()) + t;
  return T;
}

Result<Similarity> align(const Matches& matches, const AlignmentRule& rule) {
  const bool fits = rule.kind == Alignment::Sim3 || rule.scale == ScaleRule::Fit;
  const std::size_t count = rule.first > 0 ? std::min(rule.first, matches.size()) : matches.size();
  const Eigen::Matrix3d first = firstRotation(matches);
  const Centred about_mean(matches, count, false);
  const Umeyama best = umeyama(about_mean.covariance(), first);
  Centred points = rule.kind == Alignment::Origin ? Centred(matches, count, true) : about_mean;
  Similarity similarity;
  if (rule.kind == Alignment::None) {
    points.truth.colwise() += points.truth_centre;
    points.estimate.colwise() += points.estimate_centre;
    points.truth_centre = points.estimate_centre = Eigen::Vector3d::Zero();
  } else if (rule.kind == Alignment::Origin) {
    similarity.R = first;
  } else if (rule.kind == Alignment::Se3 || rule.kind == Alignment::Sim3) {
    similarity.R = best.R;
  } else {
    similarity.R = rotationAbout(rule.vertical, points.covariance(), first);
  }
  if (fits) {
    const double products = similarity.R.cwiseProduct(points.covariance()).sum();
    similarity.scale = products / points.estimate.squaredNorm();
  } else if (rule.scale == ScaleRule::Sim3) {
    similarity.scale = best.trace / about_mean.estimate.squaredNorm();
  }
  if (!std::isfinite(similarity.scale) || similarity.scale < 1e-12) {
    return Status::invalidInput("no scale can be found: truth or estimate does not move");
  }
  similarity.t = points.truth_centre - similarity.scale * (similarity.R * points.estimate_centre);
  if (rule.kind == Alignment::Se2) similarity.t.y() = 0;
  return similarity;
}

Matches aligned(const Matches& matches, const Similarity& similarity) {
  Matches result = matches;
  for (TrajectoryPose& pose : result.estimate) {
    pose.T_world_camera = similarity.apply(pose.T_world_camera);
  }
  if (result.after) {
    result.after->T_world_camera = similarity.apply(result.after->T_world_camera);
  }
  return result;
}

}  // namespace tolman::evaluation
