// SPDX-License-Identifier: BSD-3-Clause
// Loops over groups of four landmarks.
#include "window_lanes.hpp"

#include <algorithm>
#include <numeric>

namespace tolman::feature_stereo {
namespace {

constexpr double kHuber = 2.0;     // sigmas; chosen, not tuned
constexpr double kBehind = 1e4;    // cost of a point behind a camera, so that no step leads there
constexpr double kRegular = 1e-6;  // makes lanes without a landmark invertible
using WindowGroup = WindowLanes::Group;
using WindowObservations = WindowLanes::Observations;

/// Poses and offset as plain numbers.
struct PlainState {
  std::vector<PlainPose> poses;
  double offset;

  explicit PlainState(const WindowState& state)
      : poses(state.poses.begin(), state.poses.end()), offset(state.offset) {}
};

/// Index of the pair of poses a <= b among those of `count`.
TOLMAN_INLINE std::size_t pairIndex(std::size_t a, std::size_t b, std::size_t count) {
  return a * count - a * (a + 1) / 2 + b;
}

/// An observation at a state, in standard deviations, with the square root of Huber's weight.
struct WeightedError {
  Four3 error;
  Four3 weights;
  Four cost;
};

TOLMAN_INLINE Four3 errorsOf(const WindowObservations& seen, const LaneProjection& p,
                             double offset) {
  return {seen.weights[0] * (p.fromCentre[0] - seen.pixel[0]),
          seen.weights[1] * (p.fromCentre[1] - seen.pixel[1]),
          seen.weights[2] * (p.fromCentre[2] + offset - seen.pixel[2])};
}

TOLMAN_INLINE WeightedError weightedError(const WindowObservations& seen, const LaneProjection& p,
                                          double offset) {
  const Four3 error = errorsOf(seen, p, offset);
  const Four squares = dot(error, error);
  const FourMask outside = squares > kHuber * kHuber;
  const Four length = squareRoot(select(outside, squares, four(kHuber * kHuber)));
  const Four robust = select(p.front, squareRoot(kHuber / length), Four{});
  WeightedError result;
  for (std::size_t i = 0; i < 3; ++i) {
    result.error[i] = robust * error[i];
    result.weights[i] = robust * seen.weights[i];
  }
  const Four cost = select(outside, 2 * kHuber * length - kHuber * kHuber, squares);
  const Four behind = select(seen.weights[0] > 0.0, four(kBehind), Four{});
  result.cost = select(p.front, cost, behind);
  return result;
}

TOLMAN_WIDE_LANES
double costOfGroups(const LaneCamera& camera, const PlainState& state,
                    const std::vector<WindowGroup>& groups, const WindowObservations* all) {
  Four sum = {};
  for (const WindowGroup& group : groups) {
    const Four3 scaled = scaledPosition(group.reference, group.coordinates);
    const WindowObservations* seen = all + group.start;
    for (std::size_t k = group.first; k < group.end; ++k, ++seen) {
      const LaneProjection p = projected(camera, state.poses[k], scaled, group.coordinates[2]);
      sum += weightedError(*seen, p, state.offset).cost;
    }
  }
  return sumOf(sum);
}

/// Normal equations of four points.
struct PointSums {
  Four6 information = {};
  Four3 gradient = {};
  Four3 by_offset = {};
};

TOLMAN_INLINE void addPoint(const LaneByPoint& J, const WeightedError& e, PointSums& sums) {
  std::size_t k = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      sums.information[k++] += J[0][i] * J[0][j] + J[1][i] * J[1][j] + J[2][i] * J[2][j];
    }
    sums.gradient[i] += J[0][i] * e.error[0] + J[1][i] * e.error[1] + J[2][i] * e.error[2];
    sums.by_offset[i] += J[2][i] * e.weights[2];
  }
}

/// Adds the part of one pose alone, and computes its coupling with the points.
TOLMAN_INLINE void addPose(const LaneByPose& J, const LaneByPoint& by_point, const WeightedError& e,
                           std::size_t pose, std::size_t poses, WindowLanes::Sums& sums,
                           std::array<Four3, 6>& coupling) {
  Fours<36>& pair = sums.pairs[pairIndex(pose, pose, poses)];
  Four6& gradient = sums.gradients[pose];
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = i; j < 6; ++j) {
      pair[6 * i + j] += J[0][i] * J[0][j] + J[1][i] * J[1][j] + J[2][i] * J[2][j];
    }
    for (std::size_t j = 0; j < 3; ++j) {
      coupling[i][j] =
          J[0][i] * by_point[0][j] + J[1][i] * by_point[1][j] + J[2][i] * by_point[2][j];
    }
    gradient[i] += J[0][i] * e.error[0] + J[1][i] * e.error[1] + J[2][i] * e.error[2];
    sums.by_offset[pose][i] += J[2][i] * e.weights[2];
  }
}

template <class Rows>
TOLMAN_INLINE void scaleRows(const Four3& weights, Rows& J) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (Four& value : J[i].values) value *= weights[i];
  }
}

/// Eliminates the points of a group from the system of poses and offset (Schur complement).
TOLMAN_INLINE void eliminate(const WindowGroup& group, const WindowObservations* seen,
                             std::size_t poses, WindowLanes::Sums& sums) {
  const Four3 by_offset = product(group.inverse, group.by_offset);
  sums.offset_information -= dot(by_offset, group.by_offset);
  sums.offset_gradient -= dot(by_offset, group.gradient);
  const std::size_t fixed = group.first == 0 ? 1 : 0;  // the first pose is not in the system
  for (std::size_t a = group.first + fixed; a < group.end; ++a) {
    const std::array<Four3, 6>& coupling = seen[a - group.first].coupling;
    std::array<Four3, 6> solved;
    for (std::size_t i = 0; i < 6; ++i) {
      solved[i] = product(group.inverse, coupling[i]);
      sums.gradients[a - 1][i] -= dot(solved[i], group.gradient);
      sums.by_offset[a - 1][i] -= dot(solved[i], group.by_offset);
    }
    Fours<36>& own = sums.pairs[pairIndex(a - 1, a - 1, poses)];
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = i; j < 6; ++j) own[6 * i + j] -= dot(solved[i], coupling[j]);
    }
    for (std::size_t b = a + 1; b < group.end; ++b) {
      const std::array<Four3, 6>& other = seen[b - group.first].coupling;
      Fours<36>& pair = sums.pairs[pairIndex(a - 1, b - 1, poses)];
      for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = 0; j < 6; ++j) pair[6 * i + j] -= dot(solved[i], other[j]);
      }
    }
  }
}

TOLMAN_WIDE_LANES
double addGroups(const LaneCamera& camera, const PlainState& state, double damping,
                 std::vector<WindowGroup>& groups, WindowObservations* all,
                 WindowLanes::Sums& sums) {
  const std::size_t poses = state.poses.size() - 1;
  Four cost = {};
  for (WindowGroup& group : groups) {
    const Four3 scaled = scaledPosition(group.reference, group.coordinates);
    PointSums point;
    for (std::size_t k = group.first; k < group.end; ++k) {
      WindowObservations& seen = all[group.start + k - group.first];
      const LaneProjection p = projected(camera, state.poses[k], scaled, group.coordinates[2]);
      const WeightedError e = weightedError(seen, p, state.offset);
      LaneByPoint by_point = derivativesByPoint(camera, state.poses[k], group.reference, p);
      scaleRows(e.weights, by_point);
      addPoint(by_point, e, point);
      cost += e.cost;
      sums.offset_information += e.weights[2] * e.weights[2];
      sums.offset_gradient += e.weights[2] * e.error[2];
      if (k == 0) continue;
      LaneByPose by_pose = derivativesByPose(camera, p, group.coordinates[2]);
      scaleRows(e.weights, by_pose);
      addPose(by_pose, by_point, e, k - 1, poses, sums, seen.coupling);
    }
    for (const std::size_t i : {0U, 3U, 5U}) {
      point.information[i] = point.information[i] * (1 + damping) + kRegular;
    }
    group.inverse = inverseOf(point.information);
    group.gradient = point.gradient;
    group.by_offset = point.by_offset;
    eliminate(group, all + group.start, poses, sums);
  }
  return sumOf(cost);
}

/// `steps`: six numbers for each pose but the first, and that of the offset.
TOLMAN_WIDE_LANES
void moveGroups(const double* steps, std::size_t poses, std::vector<WindowGroup>& groups,
                const WindowObservations* all) {
  const double offset = steps[6 * poses];
  for (WindowGroup& group : groups) {
    Four3 pull = group.gradient;
    for (std::size_t i = 0; i < 3; ++i) pull[i] += offset * group.by_offset[i];
    for (std::size_t k = std::max<std::size_t>(1, group.first); k < group.end; ++k) {
      const WindowObservations& seen = all[group.start + k - group.first];
      const double* step = steps + 6 * (k - 1);
      for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 6; ++j) pull[i] += step[j] * seen.coupling[j][i];
      }
    }
    const Four3 step = product(group.inverse, pull);
    group.before = group.coordinates;
    for (std::size_t i = 0; i < 3; ++i) group.coordinates[i] -= step[i];
  }
}

/// Of one observation of four points: whether it fits, and its information on their coordinates.
struct alignas(32) LaneFit {
  FourMask fits;
  Four6 information;
};

TOLMAN_WIDE_LANES
void checkGroups(const LaneCamera& camera, const PlainState& state, double gate,
                 const std::vector<WindowGroup>& groups, const WindowObservations* all,
                 LaneFit* result) {
  for (const WindowGroup& group : groups) {
    const Four3 scaled = scaledPosition(group.reference, group.coordinates);
    const WindowObservations* seen = all + group.start;
    for (std::size_t k = group.first; k < group.end; ++k, ++seen, ++result) {
      const LaneProjection p = projected(camera, state.poses[k], scaled, group.coordinates[2]);
      const Four3 error = errorsOf(*seen, p, state.offset);
      const Four squares = dot(error, error);
      result->fits = p.front & (squares <= gate) & (seen->weights[0] > 0.0);
      LaneByPoint J = derivativesByPoint(camera, state.poses[k], group.reference, p);
      scaleRows(seen->weights, J);
      PointSums point;
      addPoint(J, WeightedError{}, point);
      result->information = point.information;
    }
  }
}

/// The keyframes that see a landmark.
struct Span {
  std::size_t first;
  std::size_t end;
  std::size_t landmark;
};

std::vector<Span> spansOf(const Window& window, const std::vector<Landmark*>& landmarks) {
  std::vector<Span> spans;
  for (std::size_t i = 0; i < landmarks.size(); ++i) {
    Span span{window.keyframes().size(), 0, i};
    for (const Observation& seen : landmarks[i]->observations) {
      const std::size_t keyframe = window.indexOf(seen.keyframe);
      span.first = std::min(span.first, keyframe);
      span.end = std::max(span.end, keyframe + 1);
    }
    spans.push_back(span);
  }
  // Landmarks of one group should be seen by the same keyframes, as empty lanes take time.
  std::stable_sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) {
    return a.first != b.first ? a.first < b.first : a.end < b.end;
  });
  return spans;
}

}  // namespace

WindowLanes::WindowLanes(const CameraRig& rig, const PixelNoise& noise, const Window& window,
                         const std::vector<Landmark*>& landmarks)
    : camera_(rig), poses_(window.keyframes().size()), places_(landmarks.size()) {
  const std::vector<Span> spans = spansOf(window, landmarks);
  groups_.resize((spans.size() + kFour - 1) / kFour);
  std::size_t count = 0;
  for (std::size_t n = 0; n < groups_.size(); ++n) {
    Group& group = groups_[n];
    const std::size_t end = std::min(spans.size(), kFour * (n + 1));
    group.first = poses_;
    for (std::size_t i = kFour * n; i < end; ++i) {
      group.first = std::min(group.first, spans[i].first);
      group.end = std::max(group.end, spans[i].end);
      places_[spans[i].landmark] = i;
    }
    group.start = count;
    count += group.end - group.first;
  }
  observations_.resize(count);
  fill(noise, window, landmarks);
}

void WindowLanes::fill(const PixelNoise& noise, const Window& window,
                       const std::vector<Landmark*>& landmarks) {
  for (std::size_t n = 0; n < landmarks.size(); ++n) {
    const Landmark& landmark = *landmarks[n];
    Group& group = groups_[places_[n] / kFour];
    const std::size_t lane = places_[n] % kFour;
    group.reference.set(lane, landmark.point.T_world_reference);
    for (std::size_t i = 0; i < 3; ++i) {
      group.coordinates[i][lane] = landmark.point.coordinates[static_cast<Eigen::Index>(i)];
    }
    for (const Observation& seen : landmark.observations) {
      Observations& target =
          observations_[group.start + window.indexOf(seen.keyframe) - group.first];
      const Eigen::Vector3d sigma = noise.sigma(seen.pixel.z());
      target.pixel[0][lane] = seen.pixel.x() - camera_.cx;
      target.pixel[1][lane] = seen.pixel.y() - camera_.cy;
      target.pixel[2][lane] = seen.pixel.z();
      target.weights[0][lane] = 1 / sigma.x();
      target.weights[1][lane] = 1 / sigma.y();
      target.weights[2][lane] = seen.has_disparity ? 1 / sigma.z() : 0;
    }
  }
}

double WindowLanes::cost(const WindowState& state) {
  return costOfGroups(camera_, PlainState(state), groups_, observations_.data());
}

double WindowLanes::linearise(const WindowState& state, double damping, WindowSystem& system) {
  const std::size_t poses = poses_ - 1;
  sums_.pairs.assign(poses * (poses + 1) / 2, {});
  sums_.gradients.assign(poses, {});
  sums_.by_offset.assign(poses, {});
  sums_.offset_information = sums_.offset_gradient = Four{};
  const double cost =
      addGroups(camera_, PlainState(state), damping, groups_, observations_.data(), sums_);
  const auto size = static_cast<Eigen::Index>(6 * poses);
  system.information.resize(size + 1, size + 1);
  system.gradient.resize(size + 1);
  for (std::size_t a = 0; a < poses; ++a) {
    for (std::size_t b = a; b < poses; ++b) {
      const Fours<36>& pair = sums_.pairs[pairIndex(a, b, poses)];
      for (std::size_t i = 0; i < 6; ++i) {
        for (std::size_t j = a == b ? i : 0; j < 6; ++j) {
          const auto row = static_cast<Eigen::Index>(6 * a + i);
          const auto column = static_cast<Eigen::Index>(6 * b + j);
          system.information(row, column) = system.information(column, row) =
              sumOf(pair[6 * i + j]);
        }
      }
    }
    for (std::size_t i = 0; i < 6; ++i) {
      const auto row = static_cast<Eigen::Index>(6 * a + i);
      system.gradient[row] = sumOf(sums_.gradients[a][i]);
      system.information(row, size) = system.information(size, row) = sumOf(sums_.by_offset[a][i]);
    }
  }
  system.information(size, size) = sumOf(sums_.offset_information);
  system.gradient[size] = sumOf(sums_.offset_gradient);
  return cost;
}

void WindowLanes::move(const Eigen::VectorXd& step) {
  moveGroups(step.data(), poses_ - 1, groups_, observations_.data());
}

void WindowLanes::moveBack() {
  for (Group& group : groups_) group.coordinates = group.before;
}

Eigen::Vector3d WindowLanes::coordinatesOf(std::size_t landmark) const {
  const Group& group = groups_[places_[landmark] / kFour];
  const std::size_t lane = places_[landmark] % kFour;
  return {group.coordinates[0][lane], group.coordinates[1][lane], group.coordinates[2][lane]};
}

std::vector<WindowLanes::Fit> WindowLanes::fits(const WindowState& state, double gate) {
  std::vector<LaneFit> lanes(observations_.size());
  checkGroups(camera_, PlainState(state), gate, groups_, observations_.data(), lanes.data());
  std::vector<Fit> all(places_.size());
  for (std::size_t n = 0; n < places_.size(); ++n) {
    const Group& group = groups_[places_[n] / kFour];
    const std::size_t lane = places_[n] % kFour;
    for (std::size_t k = group.first; k < group.end; ++k) {
      const LaneFit& fit = lanes[group.start + k - group.first];
      if (fit.fits[lane] == 0) continue;
      all[n].keyframes |= 1U << k;
      Eigen::Matrix3d& information = all[n].information;
      std::size_t entry = 0;
      for (Eigen::Index i = 0; i < 3; ++i) {
        for (Eigen::Index j = i; j < 3; ++j) information(i, j) += fit.information[entry++][lane];
      }
    }
    all[n].information.triangularView<Eigen::StrictlyLower>() = all[n].information.transpose();
  }
  return all;
}

}  // namespace tolman::feature_stereo
