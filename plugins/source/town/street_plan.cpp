// SPDX-License-Identifier: BSD-3-Clause
#include "street_plan.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

#include "street_grids.hpp"
#include "street_path.hpp"
#include "street_sections.hpp"

namespace tolman::town {
namespace {

constexpr double kLargestExtent = 12e3;  ///< m
constexpr double kMargin = 2;            ///< m by which grids exceed kFarthest
constexpr double kFarBlend = 150;  ///< m outside of the grids over which the height blends to hills
constexpr double kKerbClearance = 1;  ///< m, camera to kerb
constexpr double kCrossing = 8;       ///< m, between frames that meet

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

/// The frame of another pass that is nearest to `frame`.
std::optional<std::size_t> crossingFrame(const CameraRoute& route, std::size_t frame) {
  const auto place = [&](std::size_t i) -> Eigen::Vector3d {
    return route.T_town_camera[i].translation();
  };
  std::vector<double> driven = {0};
  for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
    driven.push_back(driven.back() + (place(i) - place(i - 1)).norm());
  }
  std::optional<std::size_t> found;
  double nearest = kCrossing;
  for (std::size_t i = 0; i < driven.size(); ++i) {
    const double apart = (place(i) - place(frame)).head<2>().norm();
    if (apart >= nearest || std::abs(driven[i] - driven[frame]) < kOtherPass) continue;
    nearest = apart;
    found = i;
  }
  return found;
}

struct Clearance {
  double lowest;   ///< m, camera above the road
  double highest;  ///< m
};

Status heightRefusal(const CameraRoute& route, std::size_t frame, double above,
                     const Clearance& possible) {
  const auto height = [&](std::size_t i) { return route.T_town_camera[i].translation().z(); };
  const auto other = crossingFrame(route, frame);
  if (other && std::abs(height(*other) - height(frame)) > 1) {
    return Status::invalidInput(
        "frames " + std::to_string(std::min(frame, *other)) + " and " +
        std::to_string(std::max(frame, *other)) + " cross " +
        fixed(std::abs(height(*other) - height(frame)), 1) +
        " m apart in height; choose another route, or crossings: level or bridge");
  }
  return Status::invalidInput("frame " + std::to_string(frame) + ": the camera would be " +
                              fixed(above, 1) + " m above the road (" + fixed(possible.lowest, 1) +
                              " to " + fixed(possible.highest, 1) +
                              " m is possible); choose a route that keeps to the ground");
}

/// Checks that every camera is above the road and between its kerbs.
Status checkCameras(const CameraRoute& route, const StreetPlan& plan, double camera_height) {
  const Clearance possible{std::min(0.5, camera_height / 2), std::max(4.0, camera_height + 2.35)};
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
    const double beyond = std::max(possible.lowest - above, above - possible.highest);
    if (beyond <= worst) continue;
    worst = beyond;
    worst_frame = i;
    worst_above = above;
  }
  return worst > 0 ? heightRefusal(route, worst_frame, worst_above, possible) : Status::ok();
}

/// The runs of raised points, extended by a point at both ends so that they are connected to the
/// street.
std::vector<Deck> findDecks(const std::vector<PathPoint>& path,
                            const std::vector<double>& heights) {
  std::vector<Deck> decks;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const bool next = i + 1 < path.size() && path[i + 1].raised;
    const bool before = i > 0 && path[i - 1].raised;
    if (!path[i].raised && !next && !before) continue;
    if (!path[i].raised && (decks.empty() || next)) decks.emplace_back();
    if (decks.empty()) decks.emplace_back();
    decks.back().points.push_back({path[i].centre, path[i].direction, heights[i]});
  }
  return decks;
}

}  // namespace

double StreetPlan::deckDistance(double x, double y) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Deck& deck : decks_) {
    for (const Deck::Point& point : deck.points) {
      nearest = std::min(nearest, (point.position - Eigen::Vector2d(x, y)).norm());
    }
  }
  return nearest;
}

double StreetPlan::height(double x, double y) const {
  const Eigen::Vector2d place(x, y);
  const double outside = (place - place.cwiseMax(low_).cwiseMin(high_)).norm();
  const double near = height_.at(x, y);
  if (outside <= 0) return near;
  const double t = std::min(outside / kFarBlend, 1.0);
  const double far = mean_height_ + farHills(x, y);
  return near + t * t * (3 - 2 * t) * (far - near);
}

double StreetPlan::roadHeight(double x, double y, double camera_z) const {
  double found = height(x, y);
  double nearest = kRoadHalfWidth + 1;  // m from the centreline of a deck
  for (const Deck& deck : decks_) {
    for (const Deck::Point& point : deck.points) {
      const double apart = (point.position - Eigen::Vector2d(x, y)).norm();
      if (apart >= nearest || point.height > camera_z || point.height < found) continue;
      nearest = apart;
      found = point.height;
    }
  }
  return found;
}

Result<StreetPlan> StreetPlan::grow(const CameraRoute& route, double camera_height) {
  if (route.T_town_camera.empty()) return Status::invalidInput("the route has no pose");
  if (!std::isfinite(camera_height) || camera_height <= 0) {
    return Status::invalidParameter("camera_height must be positive; give metres above the road");
  }
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
  plan.decks_ = findDecks(path, heights);
  plan.height_ = heightGrid(path, heights, plan.distance_, extent, plan.mean_height_, route.pads);
  if (const Status status = checkCameras(route, plan, camera_height); !status.isOk()) return status;
  return plan;
}

}  // namespace tolman::town
