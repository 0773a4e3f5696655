// SPDX-License-Identifier: BSD-3-Clause
#include "lamp_light.hpp"

#include <algorithm>
#include <cmath>

#include "noise.hpp"

namespace tolman::town {
namespace {

// All chosen, not tuned.
constexpr float kLampReach = 30;  ///< m; also the size of the cells of the grid; bounds the time
constexpr float kIntensity = 9;   ///< m^2: 0.25 on the road 6 m below
constexpr float kHeadRadius = 0.55F;  ///< m about the middle of a lamp's head
constexpr float kBeam = 50;           ///< m^2, straight ahead
constexpr float kBeamWidth = 0.4F;    ///< rad to either side
constexpr float kBeamDepth = 0.08F;   ///< rad below the horizon

std::int64_t cellKey(std::int64_t column, std::int64_t row) { return column * 1'000'003 + row; }

std::int64_t cellOf(float coordinate) {
  return static_cast<std::int64_t>(std::floor(coordinate / kLampReach));
}

}  // namespace

StreetLamps::StreetLamps(const std::vector<Vec3>& heads) : heads_(heads) {
  for (std::uint32_t i = 0; i < heads.size(); ++i) {
    for (std::int64_t dx = -1; dx <= 1; ++dx) {
      for (std::int64_t dy = -1; dy <= 1; ++dy) {
        cells_[cellKey(cellOf(heads[i].x) + dx, cellOf(heads[i].y) + dy)].push_back(i);
      }
    }
  }
}

const std::vector<std::uint32_t>* StreetLamps::near(const Vec3& point) const {
  const auto found = cells_.find(cellKey(cellOf(point.x), cellOf(point.y)));
  return found == cells_.end() ? nullptr : &found->second;
}

float StreetLamps::onto(const Vec3& point, const Vec3& n) const {
  const std::vector<std::uint32_t>* lamps = near(point);
  if (lamps == nullptr) return 0;
  float sum = 0;
  for (const std::uint32_t i : *lamps) {
    const Vec3 to_lamp = heads_[i] - point;
    const float squared = std::max(dot(to_lamp, to_lamp), 0.25F);
    if (squared > kLampReach * kLampReach) continue;
    const float distance = std::sqrt(squared);
    const float facing = std::max(0.0F, dot(n, to_lamp) / distance);
    const float downwards = smoothstep(-0.05F, 0.35F, to_lamp.z / distance);
    const float fade = 1 - smoothstep(0.6F * kLampReach, kLampReach, distance);
    sum += kIntensity * facing * downwards * fade / squared;
  }
  return sum;
}

bool StreetLamps::isHead(const Vec3& point) const {
  const std::vector<std::uint32_t>* lamps = near(point);
  return lamps != nullptr && std::any_of(lamps->begin(), lamps->end(), [&](std::uint32_t i) {
           const Vec3 away = point - heads_[i];
           return dot(away, away) < kHeadRadius * kHeadRadius;
         });
}

float headlightsOnto(const Headlights& beams, const Vec3& point, const Vec3& n) {
  const Vec3 ray = point - beams.from;
  const float distance = norm(ray);
  if (distance < 0.5F) return 0;
  const Vec3 way = ray * (1 / distance);
  const float ahead = dot(way, beams.ahead);
  if (ahead <= 0.2F) return 0;
  const Vec3 side = normalised(cross(beams.ahead, {0, 0, 1}));
  const float azimuth = dot(way, side) / ahead;
  const float above = way.z - beams.ahead.z;
  const float across = std::exp(-azimuth * azimuth / (kBeamWidth * kBeamWidth));
  const float below = above > 0 ? std::exp(-above / 0.015F) : std::exp(above / kBeamDepth);
  const float facing = std::max(0.0F, -dot(n, way));
  return kBeam * across * (0.03F + 0.97F * below) * facing / (distance * distance);
}

float carLamps(const Vec3& point, const Vec3& normal) {
  constexpr float kFront = 25;  // radiance; chosen, not tuned
  constexpr float kRear = 1;    // chosen, not tuned
  const float aside = std::abs(point.y);
  const bool at_lamp =
      point.z > 0.52F && point.z < 0.7F && aside > 0.42F && std::abs(normal.x) > 0.3F;
  if (!at_lamp) return 0;
  return point.x > 0 ? kFront : kRear;
}

}  // namespace tolman::town
