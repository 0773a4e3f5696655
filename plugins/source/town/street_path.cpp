// SPDX-License-Identifier: BSD-3-Clause
#include "street_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "street_plan.hpp"

namespace tolman::town {
namespace {

constexpr double kSpacing = 1;             ///< m
constexpr double kSmallestAdvance = 0.5;   ///< m, between poses that are used
constexpr double kBeyondEnds = 50;         ///< m of street before the first and after the last pose
constexpr double kWayBack = 10;            ///< m of driving, in the opposite direction
constexpr std::size_t kDirectionSpan = 2;  ///< points to either side
constexpr double kJoins = 5;               ///< m between centrelines at which a known street begins
constexpr double kLeaves = 7;              ///< m at which it ends: larger, so that it is not split
constexpr std::size_t kShortest = 6;   ///< points; shorter streets and interruptions are ignored
constexpr double kSmallestStep = 0.2;  ///< m; smaller advances are on the inside of a tight bend
const double kSameDirection = std::cos(35 * std::numbers::pi / 180);

Eigen::Vector2d heading(const Eigen::Isometry3d& T_town_camera) {
  const Eigen::Vector2d forward = T_town_camera.linear().col(2).head<2>();
  return forward.norm() > 1e-6 ? forward.normalized() : Eigen::Vector2d(0, 1);
}

struct RoutePosition {
  Eigen::Vector3d at;
  bool raised;
};

/// Camera positions, without those that are not ahead of the one before.
std::vector<RoutePosition> progress(const CameraRoute& route) {
  std::vector<RoutePosition> places = {
      {route.T_town_camera.front().translation(), route.isRaised(0)}};
  const auto add = [&](std::size_t frame, double smallest_advance) {
    const Eigen::Isometry3d& pose = route.T_town_camera[frame];
    const Eigen::Vector2d step = (pose.translation() - places.back().at).head<2>();
    if (step.norm() < smallest_advance || step.dot(heading(pose)) <= 0) return;
    places.push_back({pose.translation(), route.isRaised(frame)});
  };
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) add(i, kSmallestAdvance);
  add(route.T_town_camera.size() - 1, 0.1 * kSmallestAdvance);
  return places;
}

std::vector<PathPoint> everyMetre(const std::vector<RoutePosition>& places) {
  std::vector<PathPoint> points;
  const auto add = [&](const Eigen::Vector3d& place, double s, bool raised) {
    PathPoint point;
    point.driven = place.head<2>();
    point.height = place.z();
    point.s = s;
    point.raised = raised;
    points.push_back(point);
  };
  double driven = 0;  // m, to places[i]
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const Eigen::Vector3d step = places[i + 1].at - places[i].at;
    const double length = step.head<2>().norm();
    for (;;) {
      const double s = static_cast<double>(points.size()) * kSpacing;
      if (s >= driven + length) break;
      add(places[i].at + (s - driven) / length * step, s, places[i].raised || places[i + 1].raised);
    }
    driven += length;
  }
  add(places.back().at, driven, places.back().raised);
  return points;
}

/// Sets the directions of the points; `fallback` where they cannot be computed.
void setDirections(std::vector<PathPoint>& points, Eigen::Vector2d fallback) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t before = i - std::min(i, kDirectionSpan);
    const std::size_t after = std::min(i + kDirectionSpan, points.size() - 1);
    const Eigen::Vector2d chord = points[after].driven - points[before].driven;
    if (chord.norm() > 0.3) fallback = chord.normalized();
    points[i].direction = fallback;
    points[i].centre =
        points[i].driven + StreetPlan::kLaneOffset * Eigen::Vector2d(-fallback.y(), fallback.x());
  }
}

/// Points straight on from an end of the path (`start`: its beginning), with a slope that fades
/// out; none if the route passes there itself.
std::vector<PathPoint> beyond(const std::vector<PathPoint>& points, bool start) {
  const std::size_t span = std::min<std::size_t>(5, points.size() - 1);
  const PathPoint& end = start ? points.front() : points.back();
  const PathPoint& inside = start ? points[span] : points[points.size() - 1 - span];
  const bool comes_along = std::any_of(points.begin(), points.end(),
                                       [&](const PathPoint& p) { return isSameStreet(p, end, 5); });
  if (comes_along) return {};
  const double sign = start ? -1 : 1;
  const double run = std::abs(end.s - inside.s);
  const double slope =  // outwards
      run > 1 ? std::clamp((end.height - inside.height) / run, -0.15, 0.15) : 0;
  constexpr double kFade = 20;  // m
  std::vector<PathPoint> more;
  for (double along = kSpacing; along <= kBeyondEnds; along += kSpacing) {
    PathPoint point = end;
    point.driven += sign * along * end.direction;
    point.centre += sign * along * end.direction;
    point.height += slope * kFade * (1 - std::exp(-along / kFade));
    point.s += sign * along;
    point.driven_over = false;
    more.push_back(point);
  }
  if (start) std::reverse(more.begin(), more.end());
  return more;
}

/// Collects the parts of the path that were not driven before.
class SectionFinder {
 public:
  explicit SectionFinder(const std::vector<PathPoint>& path) : path_(path), kept_(path.size()) {}

  std::vector<std::vector<std::size_t>> find() {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      if (path_[i].raised) {
        closeSection();
        known_run_.clear();
      } else if (isKnown(i)) {
        known_run_.push_back(i);
        if (known_run_.size() == kShortest) closeSection();
      } else {
        // A short interruption belongs to the street after it.
        if (known_run_.size() < kShortest && !section_.empty()) keepAll(known_run_);
        known_run_.clear();
        keepAll({i});
      }
    }
    closeSection();
    return std::move(found_);
  }

 private:
  bool isKnown(std::size_t index) const {
    const double reach = known_run_.empty() ? kJoins : kLeaves;
    const std::vector<std::size_t> candidates = grid_.near(path_[index].centre);
    return std::any_of(candidates.begin(), candidates.end(), [&](std::size_t other) {
      return kept_[other] && isSameStreet(path_[index], path_[other], reach);
    });
  }

  void keepAll(const std::vector<std::size_t>& indices) {
    for (const std::size_t index : indices) {
      section_.push_back(index);
      kept_[index] = true;
      grid_.add(path_[index].centre, index);
    }
  }

  void closeSection() {
    if (section_.size() >= kShortest) {
      found_.push_back(section_);
    } else {
      for (const std::size_t index : section_) kept_[index] = false;
    }
    section_.clear();
  }

  const std::vector<PathPoint>& path_;
  std::vector<bool> kept_;
  PointGrid grid_;
  std::vector<std::size_t> section_;
  std::vector<std::size_t> known_run_;
  std::vector<std::vector<std::size_t>> found_;
};

/// The centreline through the points, with s, without points that go backwards.
std::vector<StreetPoint> centreline(const std::vector<PathPoint>& path,
                                    const std::vector<std::size_t>& indices) {
  std::vector<StreetPoint> line;
  for (const std::size_t index : indices) {
    const PathPoint& point = path[index];
    double s = 0;
    if (!line.empty()) {
      const Eigen::Vector2d step = point.centre - line.back().position;
      if (step.dot(point.direction) < kSmallestStep) continue;
      s = line.back().s + step.norm();
    }
    line.push_back({point.centre, point.direction, s});
  }
  return line;
}

StreetSection everyMetre(const std::vector<StreetPoint>& line) {
  StreetSection section;
  std::size_t i = 0;
  for (double s = 0; s <= line.back().s; s += 1) {
    while (i + 2 < line.size() && line[i + 1].s <= s) ++i;
    const StreetPoint& a = line[i];
    const StreetPoint& b = line[i + 1];
    const double t = (s - a.s) / (b.s - a.s);
    section.points.push_back({a.position + t * (b.position - a.position),
                              (a.direction + t * (b.direction - a.direction)).normalized(), s});
  }
  return section;
}

}  // namespace

bool isOtherPass(const PathPoint& a, const PathPoint& b) {
  const double apart = std::abs(a.s - b.s);
  return apart > kOtherPass || (apart > kWayBack && a.direction.dot(b.direction) < -kSameDirection);
}

bool isSameStreet(const PathPoint& a, const PathPoint& b, double reach) {
  if (a.raised || b.raised) return false;
  return std::abs(a.direction.dot(b.direction)) >= kSameDirection && isOtherPass(a, b) &&
         (a.centre - b.centre).squaredNorm() < reach * reach;
}

std::vector<PathPoint> samplePath(const CameraRoute& route, double camera_height) {
  std::vector<PathPoint> points = everyMetre(progress(route));
  setDirections(points, heading(route.T_town_camera.front()));
  for (PathPoint& point : points) point.height -= camera_height;
  const std::vector<PathPoint> before = beyond(points, true);
  const std::vector<PathPoint> after = beyond(points, false);
  points.insert(points.begin(), before.begin(), before.end());
  points.insert(points.end(), after.begin(), after.end());
  return points;
}

std::vector<StreetSection> findSections(const std::vector<PathPoint>& path) {
  std::vector<StreetSection> sections;
  for (const std::vector<std::size_t>& indices : SectionFinder(path).find()) {
    const std::vector<StreetPoint> line = centreline(path, indices);
    if (line.size() >= 2 && line.back().s >= static_cast<double>(kShortest - 1)) {
      sections.push_back(everyMetre(line));
    }
  }
  return sections;
}

std::int64_t PointGrid::keyOf(const Eigen::Vector2d& place, int column, int row) const {
  const auto cellOf = [&](double coordinate) {
    return static_cast<std::int64_t>(std::floor(coordinate / reach_));
  };
  return (cellOf(place.x()) + column) * (std::int64_t{1} << 32) + cellOf(place.y()) + row;
}

void PointGrid::add(const Eigen::Vector2d& place, std::size_t index) {
  cells_[keyOf(place, 0, 0)].push_back(index);
}

std::vector<std::size_t> PointGrid::near(const Eigen::Vector2d& place) const {
  std::vector<std::size_t> found;
  for (int i = 0; i < 9; ++i) {
    const auto cell = cells_.find(keyOf(place, i % 3 - 1, i / 3 - 1));
    if (cell == cells_.end()) continue;
    found.insert(found.end(), cell->second.begin(), cell->second.end());
  }
  return found;
}

}  // namespace tolman::town
