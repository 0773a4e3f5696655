// SPDX-License-Identifier: BSD-3-Clause
#include "pavement.hpp"

#include <algorithm>
#include <cmath>

#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kMiddle = StreetPlan::kRoadHalfWidth + 1.1;      ///< m from the centreline
constexpr double kBehindCars = StreetPlan::kRoadHalfWidth + 2.1;  ///< m
constexpr double kCarReach = 4.4;                                 ///< m along the street
constexpr double kClear = StreetPlan::kRoadHalfWidth + 0.9;       ///< m from every centreline
constexpr std::size_t kShortest = 12;                             ///< points

/// The pavement on one side of a section.
class Side {
 public:
  Side(const StreetSection& section, bool left, const std::vector<Eigen::Vector2d>& cars,
       const PointGrid& grid)
      : section_(section), sign_(left ? 1 : -1), cars_(cars), grid_(grid) {
    for (std::size_t i = 0; i < section.points.size(); ++i) {
      over_.push_back(isBesideCar(i) ? kBehindCars : kMiddle);
    }
  }

  /// Place of a point, moved aside near parked cars, from some metres before them.
  Eigen::Vector2d place(std::size_t i) const {
    double sum = 0;
    double count = 0;
    for (std::size_t j = i - std::min<std::size_t>(i, 2); j < std::min(i + 3, over_.size()); ++j) {
      sum += over_[j];
      ++count;
    }
    return point(i, sum / count);
  }

 private:
  Eigen::Vector2d point(std::size_t i, double over) const {
    const StreetPoint& p = section_.points[i];
    return p.position + sign_ * over * Eigen::Vector2d(-p.direction.y(), p.direction.x());
  }
  bool isBesideCar(std::size_t i) const {
    const Eigen::Vector2d here = point(i, kMiddle);
    const std::vector<std::size_t> near = grid_.near(here);
    return std::any_of(near.begin(), near.end(),
                       [&](std::size_t c) { return (cars_[c] - here).norm() < kCarReach; });
  }

  const StreetSection& section_;
  double sign_;
  const std::vector<Eigen::Vector2d>& cars_;
  const PointGrid& grid_;
  std::vector<double> over_;
};

}  // namespace

double PavementRun::length() const {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

PavementRun::Position PavementRun::at(double s) const {
  std::size_t i = 1;
  for (; i + 1 < points.size(); ++i) {
    const double step = (points[i] - points[i - 1]).norm();
    if (s <= step) break;
    s -= step;
  }
  const Eigen::Vector2d way = (points[i] - points[i - 1]).normalized();
  return {points[i - 1] + s * way, way};
}

std::vector<PavementRun> pavementRuns(const StreetPlan& plan,
                                      const std::vector<Eigen::Vector2d>& cars) {
  PointGrid grid;
  for (std::size_t i = 0; i < cars.size(); ++i) grid.add(cars[i], i);
  std::vector<PavementRun> runs;
  for (const StreetSection& section : plan.sections()) {
    for (const bool left : {false, true}) {
      const Side side(section, left, cars, grid);
      PavementRun run;
      run.is_left = left;
      const auto close = [&] {
        if (run.points.size() >= kShortest) runs.push_back(run);
        run.points.clear();
      };
      for (std::size_t i = 0; i < section.points.size(); ++i) {
        const Eigen::Vector2d place = side.place(i);
        if (plan.distance(place.x(), place.y()) < kClear) {
          close();
        } else if (run.points.empty() || (place - run.points.back()).norm() > 0.3) {
          run.points.push_back(place);  // points closer together are on the inside of a bend
        }
      }
      close();
    }
  }
  return runs;
}

}  // namespace tolman::town
