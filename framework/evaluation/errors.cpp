// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/errors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {
namespace {

/// Collects the errors of single steps.
class StepErrors {
 public:
  void add(const Matches& matches, std::size_t from, std::size_t to, double divisor) {
    const Eigen::Isometry3d truth = motion(matches.truth, from, to);
    const Eigen::Isometry3d error = truth.inverse() * motion(matches.estimate, from, to);
    translations_.push_back(error.translation().norm() / divisor);
    rotations_.push_back(logSo3(error.linear()).norm() * 180 / std::numbers::pi / divisor);
  }
  RelativeError result() && {
    return {statistics(std::move(translations_)), statistics(std::move(rotations_))};
  }

 private:
  static Eigen::Isometry3d motion(const Trajectory& trajectory, std::size_t from, std::size_t to) {
    return trajectory[from].T_world_camera.inverse() * trajectory[to].T_world_camera;
  }
  std::vector<double> translations_;
  std::vector<double> rotations_;
};

}  // namespace

Statistics statistics(std::vector<double> values) {
  Statistics result;
  result.count = values.size();
  if (values.empty()) return result;
  std::sort(values.begin(), values.end());
  const auto count = static_cast<double>(values.size());
  for (const double value : values) {
    result.mean += value / count;
    result.rmse += value * value / count;
  }
  result.rmse = std::sqrt(result.rmse);
  const std::size_t middle = values.size() / 2;
  result.median =
      values.size() % 2 == 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
  result.min = values.front();
  result.max = values.back();
  return result;
}

std::vector<double> positionErrors(const Matches& aligned, Direction direction) {
  std::vector<double> values;
  for (std::size_t i = 0; i < aligned.size(); ++i) {
    Eigen::Vector3d error = aligned.estimate[i].T_world_camera.translation() -
                            aligned.truth[i].T_world_camera.translation();
    if (direction == Direction::Horizontal) error.y() = 0;
    if (direction == Direction::Vertical) error.x() = error.z() = 0;
    values.push_back(error.norm());
  }
  return values;
}

Statistics absoluteError(const Matches& aligned, Direction direction) {
  return statistics(positionErrors(aligned, direction));
}

RelativeError relativeErrorOverFrames(const Matches& aligned, std::int64_t delta) {
  StepErrors errors;
  std::size_t to = 0;
  for (std::size_t from = 0; from < aligned.size(); ++from) {
    const std::int64_t wanted = aligned.estimate[from].frame + delta;
    while (to < aligned.size() && aligned.estimate[to].frame < wanted) ++to;
    if (to == aligned.size()) break;
    if (aligned.estimate[to].frame == wanted && aligned.inOnePiece(from, to)) {
      errors.add(aligned, from, to, 1);
    }
  }
  return std::move(errors).result();
}

RelativeError relativeErrorOverDistance(const Matches& aligned, double length) {
  StepErrors errors;
  const std::vector<double>& distance = aligned.driven;
  std::size_t to = 0;
  for (std::size_t from = 0; from < aligned.size(); ++from) {
    while (to < aligned.size() && distance[to] - distance[from] < length) ++to;
    if (to == aligned.size()) break;
    if (!aligned.inOnePiece(from, to)) continue;
    errors.add(aligned, from, to, distance[to] - distance[from]);
  }
  return std::move(errors).result();
}

}  // namespace tolman::evaluation
