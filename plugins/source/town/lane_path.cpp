// SPDX-License-Identifier: BSD-3-Clause
#include "lane_path.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace tolman::town {
namespace {

LanePosition along(const Eigen::Vector2d& start, double heading, double curvature, double length) {
  const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
  if (curvature == 0) return {start + length * direction, direction};
  const double end = heading + curvature * length;
  const Eigen::Vector2d left(-direction.y(), direction.x());
  const Eigen::Vector2d end_direction(std::cos(end), std::sin(end));
  const Eigen::Vector2d end_left(-end_direction.y(), end_direction.x());
  return {start + (left - end_left) / curvature, end_direction};
}

}  // namespace

LanePath& LanePath::ahead(double length) {
  ahead_ += length;
  return *this;
}

LanePath& LanePath::curve(double radius, double angle) {
  flush(0);
  // The lane is on the outer side of the centreline in a left bend, on the inner side in a right
  // one.
  const double driven = radius + (angle > 0 ? lane_offset_ : -lane_offset_);
  add(driven * std::abs(angle), (angle > 0 ? 1 : -1) / driven);
  return *this;
}

LanePath& LanePath::bulge(double radius, double angle) {
  return curve(radius, angle).curve(radius, -2 * angle).curve(radius, angle);
}

LanePath& LanePath::turnLeft(double driven_radius) {
  turn(driven_radius, kPi / 2, driven_radius - lane_offset_);
  return *this;
}

LanePath& LanePath::turnRight(double driven_radius) {
  turn(driven_radius, -kPi / 2, driven_radius + lane_offset_);
  return *this;
}

void LanePath::turn(double driven_radius, double angle, double along_street) {
  flush(along_street);
  add(driven_radius * std::abs(angle), (angle > 0 ? 1 : -1) / driven_radius);
  ahead_ = -along_street;
}

LanePath& LanePath::roundabout(double driven_radius, double entry_radius, double angle) {
  // The entry arc is tangent to the lane and, from outside, to the circle: its centre is
  // entry_radius to the right of the lane, and at the sum of both radii from the centre of the
  // island.
  const double across = lane_offset_ + entry_radius;
  const double between = driven_radius + entry_radius;
  if (across >= between) throw std::invalid_argument("roundabout: the island is too small");
  const double along_street = std::sqrt(between * between - across * across);
  const double entry_angle = std::acos(across / between);
  flush(along_street);
  add(entry_radius * entry_angle, -1 / entry_radius);
  add(driven_radius * (2 * entry_angle + angle), 1 / driven_radius);
  add(entry_radius * entry_angle, -1 / entry_radius);
  ahead_ = -along_street;
  return *this;
}

void LanePath::flush(double kept) {
  const double length = ahead_ - kept;
  if (length < -1e-9) throw std::invalid_argument("lane path: the street is too short to turn");
  if (length > 1e-9) add(length, 0);
  ahead_ = 0;
}

void LanePath::add(double length, double curvature) {
  Piece piece{0, length, curvature, Eigen::Vector2d::Zero(), kPi / 2};
  if (!pieces_.empty()) {
    const Piece& last = pieces_.back();
    piece.start_s = last.start_s + last.length;
    piece.position = along(last.position, last.heading, last.curvature, last.length).position;
    piece.heading = last.heading + last.curvature * last.length;
  }
  pieces_.push_back(piece);
}

double LanePath::length() const {
  const double driven = pieces_.empty() ? 0 : pieces_.back().start_s + pieces_.back().length;
  return driven + std::max(ahead_, 0.0);
}

const LanePath::Piece& LanePath::pieceAt(double s) const {
  const auto after = std::upper_bound(pieces_.begin(), pieces_.end(), s,
                                      [](double at, const Piece& p) { return at < p.start_s; });
  return after == pieces_.begin() ? *after : *std::prev(after);
}

LanePosition LanePath::at(double s) const {
  s = std::clamp(s, 0.0, length());
  if (pieces_.empty()) return along(Eigen::Vector2d::Zero(), kPi / 2, 0, s);
  const Piece& piece = pieceAt(s);
  const double inside = std::min(s - piece.start_s, piece.length);
  const LanePosition end = along(piece.position, piece.heading, piece.curvature, inside);
  const double rest = s - piece.start_s - inside;  // ahead() after the last piece
  return {end.position + rest * end.direction, end.direction};
}

double LanePath::curvature(double s) const {
  if (pieces_.empty()) return 0;
  const Piece& piece = pieceAt(std::clamp(s, 0.0, length()));
  return s <= piece.start_s + piece.length ? piece.curvature : 0;
}

}  // namespace tolman::town
