// SPDX-License-Identifier: BSD-3-Clause
// The hall as triangles, and the path of the hand-held camera.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "buildings.hpp"
#include "noise.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

constexpr auto kWestWall = static_cast<float>(Hall::kWest);
constexpr auto kEastWall = static_cast<float>(Hall::kEast);
constexpr auto kSouthWall = static_cast<float>(Hall::kSouth);
constexpr auto kNorthWall = static_cast<float>(Hall::kNorth);
constexpr auto kTop = static_cast<float>(Hall::kCeiling);
constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kWalk = 0.8;  // m/s

class HallBuilder {
 public:
  HallBuilder(World& world, double floor, std::uint32_t seed)
      : world_(world), floor_(static_cast<float>(floor)), seed_(seed) {}

  void build() {
    plate(floor_, {Material::Road, 0.3F});
    plate(kTop, {Material::Kerb, 0.5F});
    wall({kWestWall, kSouthWall}, {kEastWall, kSouthWall});
    wall({kEastWall, kSouthWall}, {kEastWall, kNorthWall});
    wall({kEastWall, kNorthWall}, {kWestWall, kNorthWall});
    wall({kWestWall, kNorthWall}, {kWestWall, kSouthWall});
    tables();
    shelves();
    chests();
    for (const auto& [x, y] :
         {Corner{-3, -1.9F}, {-3, 1.9F}, {kWestWall + 0.6F, kSouthWall + 0.6F}}) {
      box({x - 0.2F, y - 0.2F}, {x + 0.2F, y + 0.2F}, floor_, kTop, {Material::Wood, 0.35F});
    }
  }

 private:
  struct Corner {
    float x, y;
  };
  struct Finish {
    Material material;
    float tone;
  };

  std::uint32_t next() { return hash(seed_, number_++, 311); }
  float random(float low, float high) { return between(next(), low, high); }

  std::uint32_t surface(const Finish& finish, const Vec3& origin = {},
                        const Vec3& along = {1, 0, 0}) {
    return world_.addSurface({.material = finish.material,
                              .seed = next(),
                              .tone = finish.tone,
                              .origin = origin,
                              .axis_u = along});
  }
  void plate(float z, const Finish& finish) {
    addQuad(world_.fixed,
            {Vec3{kWestWall, kSouthWall, z},
             {kEastWall, kSouthWall, z},
             {kEastWall, kNorthWall, z},
             {kWestWall, kNorthWall, z}},
            surface(finish));
  }
  void box(const Corner& low, const Corner& high, float bottom, float top, const Finish& finish) {
    const Vec3 corner = {low.x, low.y, bottom};
    addBox(world_.fixed, corner,
           {Vec3{high.x - low.x, 0, 0}, Vec3{0, high.y - low.y, 0}, Vec3{0, 0, top - bottom}},
           surface(finish, corner, {0.8F, 0.6F, 0}));
  }

  /// A panelled wall with posters of many sizes.
  void wall(const Corner& a, const Corner& b) {
    const Vec3 from = {a.x, a.y, floor_};
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    const Vec3 along = {(b.x - a.x) / length, (b.y - a.y) / length, 0};
    const Vec3 inward = {-along.y, along.x, 0};
    addQuad(world_.fixed,
            {from, Vec3{b.x, b.y, floor_}, Vec3{b.x, b.y, kTop}, Vec3{a.x, a.y, kTop}},
            surface({Material::Wood, 0.5F}, from, along));
    for (float at = 0.5F; at < length - 1.8F;) {
      Surface poster = {.material = Material::Board,
                        .seed = next(),
                        .tone = random(0.15F, 0.6F),
                        .axis_u = along,
                        .width = random(0.6F, 1.7F),
                        .height = random(0.6F, 1.5F)};
      poster.origin = from + along * at + inward * 0.03F + Vec3{0, 0, random(1.0F, 2.2F)};
      const Vec3 right = along * poster.width;
      const Vec3 up = {0, 0, poster.height};
      const Vec3& low = poster.origin;
      addQuad(world_.fixed, {low, low + right, low + right + up, low + up},
              world_.addSurface(poster));
      at += poster.width + random(0.3F, 1.1F);
    }
  }

  // Draws in the order in which the arguments of calls have always been evaluated: from the last.

  /// Tables in the middle, round which the camera is carried, with objects on them.
  void tables() {
    for (const float y : {-1.0F, 0.8F}) {
      const float top = floor_ + 0.78F;
      box({-4.2F, y}, {-1.9F, y + 0.9F}, top - 0.05F, top, {Material::Wood, 0.45F});
      for (const float x : {-4.1F, -2.1F}) {
        box({x, y + 0.1F}, {x + 0.08F, y + 0.8F}, floor_, top - 0.05F, {Material::Wood, 0.25F});
      }
      for (float x = -4.1F; x < -2.2F; x += random(0.3F, 0.6F)) {
        const float size = random(0.12F, 0.3F);
        const float back = y + random(0.05F, 0.55F);
        const float tone = random(0.15F, 0.8F);
        box({x, back}, {x + size, back + size}, top, top + random(0.1F, 0.45F),
            {Material::Board, tone});
      }
    }
  }

  /// Shelves along the western and the eastern wall, with boxes on their boards.
  void shelves() {
    for (const float x : {kWestWall + 0.05F, kEastWall - 0.45F}) {
      for (float y = kSouthWall + 1.2F; y < kNorthWall - 2.6F; y += random(2.3F, 3.2F)) {
        shelf({x, y}, random(1.2F, 1.9F));
      }
    }
  }

  void shelf(const Corner& at, float length) {
    for (int board = 0; board < 4; ++board) {
      const float z = floor_ + 0.1F + 0.45F * static_cast<float>(board);
      box(at, {at.x + 0.4F, at.y + length}, z, z + 0.03F, {Material::Wood, 0.4F});
      if (board == 3) break;
      for (float y = at.y + 0.03F; y < at.y + length - 0.35F; y += random(0.25F, 0.5F)) {
        const float tone = random(0.1F, 0.8F);
        const float top = z + random(0.15F, 0.38F);
        box({at.x + 0.05F, y}, {at.x + 0.35F, y + random(0.1F, 0.3F)}, z + 0.03F, top,
            {Material::Wood, tone});
      }
    }
  }

  /// Chests on the floor, beside the path.
  void chests() {
    constexpr std::array<Corner, 7> kPlaces = {
        Corner{-6.9F, kSouthWall + 0.3F}, {-4.4F, kSouthWall + 0.2F}, {-1.5F, kSouthWall + 0.4F},
        {0.6F, kNorthWall - 1.0F},        {-2.6F, kNorthWall - 1.1F}, {-5.4F, kNorthWall - 1.0F},
        {-7.6F, kNorthWall - 1.2F}};
    for (const Corner& place : kPlaces) {
      const Corner end = {place.x + random(0.5F, 1.0F), place.y + random(0.4F, 0.8F)};
      const float tone = random(0.15F, 0.7F);
      box(place, end, floor_, floor_ + random(0.4F, 1.2F), {Material::Wood, tone});
    }
  }

  World& world_;
  float floor_;
  std::uint32_t seed_;
  std::uint32_t number_ = 0;
};

double wave(double phase) { return std::sin(kTurn * phase); }

/// Pose at `angle` (rad) of the ellipse, `seconds` and `metres` after the start.
Eigen::Isometry3d handPose(double angle, double seconds, double metres) {
  const Eigen::Vector2d along(-Hall::kHalfAcross * std::sin(angle),
                              Hall::kHalfAlong * std::cos(angle));
  const double azimuth = std::atan2(along.x(), along.y()) + 0.35 * wave(seconds / 6.1);
  const double height = 0.25 * wave(metres / 9.4) + 0.015 * wave(1.7 * seconds);
  const double pitch = 0.2 * wave(seconds / 8.3) + 0.01 * wave(1.7 * seconds);
  const double roll = 0.17 * wave(seconds / 4.9);
  Eigen::Isometry3d pose = levelPose(azimuth);
  pose.translation() << Hall::kMiddleX + Hall::kHalfAcross * std::cos(angle) +
                            0.12 * wave(metres / 5.3),
      Hall::kHalfAlong * std::sin(angle), height;
  pose.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitX()));
  pose.rotate(Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitZ()));
  return pose;
}

}  // namespace

CameraRoute hallWalk(const RouteOptions& options) {
  const double step = std::min(options.speed, kWalk) / options.rate;
  CameraRoute route;
  route.building = Building::Hall;
  double angle = 0;
  for (int frame = 0; angle < Hall::kRounds * kTurn; ++frame) {
    const double seconds = frame / options.rate;
    route.stamps_ns.push_back(std::llround(1e9 * seconds));
    route.T_town_camera.push_back(handPose(angle, seconds, frame * step));
    // Constant speed: the step of the angle follows from the derivative of the ellipse.
    angle +=
        step / std::hypot(Hall::kHalfAcross * std::sin(angle), Hall::kHalfAlong * std::cos(angle));
  }
  route.pads.push_back({{Hall::kWest - 2, Hall::kSouth - 2},
                        {Hall::kEast + 2, Hall::kNorth + 2},
                        -(options.camera_height + 0.3)});
  return route;
}

CameraRoute streetBesideHall(const CameraRoute& walk) {
  constexpr double kLength = 80;
  constexpr double kAway = 32;
  CameraRoute street = walk;
  const auto frames = static_cast<double>(walk.T_town_camera.size());
  for (std::size_t i = 0; i < walk.T_town_camera.size(); ++i) {
    street.T_town_camera[i] = levelPose(0);
    street.T_town_camera[i].translation() << kAway,
        kLength * (static_cast<double>(i) / frames - 0.5), 0;
  }
  return street;
}

Plot hallPlot() {
  return {{(Hall::kWest + Hall::kEast) / 2, (Hall::kSouth + Hall::kNorth) / 2},
          Eigen::Vector2d::UnitX(),
          (Hall::kEast - Hall::kWest) / 2 + 2,
          (Hall::kNorth - Hall::kSouth) / 2 + 2};
}

void addHall(World& world, double floor, std::uint32_t seed) {
  HallBuilder(world, floor, seed).build();
}

}  // namespace tolman::town
