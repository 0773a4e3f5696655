// SPDX-License-Identifier: BSD-3-Clause
#include "street_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "ground_grid.hpp"
#include "street_path.hpp"

namespace tolman::town {
namespace {

constexpr double kLargestExtent = 12e3;  ///< m
constexpr double kMargin = 2;            ///< m by which grids exceed kFarthest
constexpr double kFarBlend = 150;  ///< m outside of the grids over which the height blends to hills
constexpr double kKerbClearance = 1;  ///< m, camera to kerb

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

GridExtent extentOf(const std::vector<PathPoint>& path) {
  GridExtent extent{path.front().centre, path.front().centre};
  for (const PathPoint& point : path) {
    extent.low = extent.low.cwiseMin(point.centre);
    extent.high = extent.high.cwiseMax(point.centre);
  }
  extent.low.array() -= StreetPlan::kFarthest + kMargin;
  extent.high.array() += StreetPlan::kFarthest + kMargin;
  return extent;
}

/// Checks that every camera is above the road and between its kerbs.
Status checkCameras(const CameraRoute& route, const StreetPlan& plan, double camera_height) {
  const double lowest = std::min(0.5, camera_height / 2);
  const double highest = std::max(4.0, camera_height + 2.35);
  std::size_t worst_frame = 0;
  double worst = 0;  // m beyond the limit
  double worst_above = 0;
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    if (route.isRaised(i)) continue;
    const Eigen::Vector3d place = route.T_town_camera[i].translation();
    if (plan.distance(place.x(), place.y()) > StreetPlan::kRoadHalfWidth - kKerbClearance) {
      return Status::invalidInput("frame " + std::to_string(i) +
                                  ": the car leaves the street backwards or sideways; "
                                  "choose a route that is driven forwards");
    }
    const double above = place.z() - plan.height(place.x(), place.y());
    const double beyond = std::max(lowest - above, above - highest);
    if (beyond <= worst) continue;
    worst = beyond;
    worst_frame = i;
    worst_above = above;
  }
  if (worst <= 0) return Status::ok();
  return Status::invalidInput("frame " + std::to_string(worst_frame) + ": the camera would be " +
                              fixed(worst_above, 1) + " m above the road (" + fixed(lowest, 1) +
                              " to " + fixed(highest, 1) +
                              " m is possible); choose a route that keeps to the ground and does "
                              "not cross itself at another height");
}

}  // namespace

double StreetPlan::height(double x, double y) const {
  const Eigen::Vector2d place(x, y);
  const double outside = (place - place.cwiseMax(low_).cwiseMin(high_)).norm();
  const double near = height_.at(x, y);
  if (outside <= 0) return near;
  const double t = std::min(outside / kFarBlend, 1.0);
  const double far = mean_height_ + farHills(x, y);
  return near + t * t * (3 - 2 * t) * (far - near);
}

Result<StreetPlan> StreetPlan::grow(const CameraRoute& route, double camera_height) {
  if (route.T_town_camera.empty()) return Status::invalidInput("the route has no pose");
  const std::vector<PathPoint> path = samplePath(route, camera_height);
  const GridExtent extent = extentOf(path);
  const double size = (extent.high - extent.low).maxCoeff();
  if (!(size <= kLargestExtent)) {
    return Status::invalidInput("the route extends over " + fixed(size / 1000, 1) +
                                " km, more than " + fixed(kLargestExtent / 1000, 0) +
                                " km; choose a shorter one");
  }
  StreetPlan plan;
  plan.low_ = extent.low;
  plan.high_ = extent.high;
  plan.sections_ = findSections(path);
  plan.distance_ = distanceGrid(path, extent, kFarthest);
  const std::vector<double> heights = agreeOnHeights(path);
  double sum = 0;
  double count = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i].raised) continue;
    sum += heights[i];
    ++count;
  }
  if (count == 0) return Status::invalidInput("no frame of the route is on a street");
  plan.mean_height_ = sum / count;
  plan.height_ = heightGrid(path, heights, plan.distance_, extent, plan.mean_height_, route.pads);
  if (const Status status = checkCameras(route, plan, camera_height); !status.isOk()) return status;
  return plan;
}

}  // namespace tolman::town
