// SPDX-License-Identifier: BSD-3-Clause
// A straight street between houses with fronts at random distances and of random heights, rendered
// for a stereo pair that looks along it in either direction.
#pragma once

#include <cmath>
#include <numbers>
#include <optional>

#include "tolman/context.hpp"
#include "tolman/records.hpp"

namespace tolman::view_sequences::test {

inline CameraRig houseRig() {
  CameraRig rig;
  rig.width = 400;
  rig.height = 128;
  rig.calibrated = true;
  rig.pinhole = {200, 200, 199.5, 63.5};
  rig.baseline = 0.5;
  return rig;
}

class HouseStreet {
 public:
  explicit HouseStreet(std::uint64_t seed) : seed_(seed) {}

  /// At `z` m along the street and `x` m to its right, looking along it or, turned, back.
  static Eigen::Isometry3d poseAt(double z, double x, bool turned) {
    Eigen::Isometry3d T = fromPlanar({z, -x, turned ? std::numbers::pi : 0});
    return T;
  }
  Frame frameAt(const Eigen::Isometry3d& T_street_camera) const {
    Frame frame;
    frame.left = imageAt(T_street_camera);
    frame.right = imageAt(T_street_camera * Eigen::Translation3d(houseRig().baseline, 0, 0));
    return frame;
  }

 private:
  static constexpr double kHouse = 4;  // m along the street
  static constexpr double kEye = 1.65;

  double chance(std::int64_t a, std::int64_t b, std::int64_t c = 0) const {
    RandomStream random(seed_ * 7919 +
                        static_cast<std::uint64_t>(a * 1000003 + b * 10007 + c * 31));
    return random.uniform();
  }
  double frontOf(std::int64_t house, int side) const { return 5 + 6 * chance(house, side); }
  double heightOf(std::int64_t house, int side) const { return 2 + 7 * chance(house, side, 5); }

  /// Distance along the ray to the first house, and which it is; none within 60 m.
  struct Hit {
    double s;
    std::int64_t house;
    int side;
  };
  std::optional<Hit> firstHouse(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) const {
    const int side = ray.x() < 0 ? 0 : 1;
    const double way = side == 0 ? -1 : 1;
    const std::int64_t onwards = ray.z() < 0 ? -1 : 1;
    auto house = static_cast<std::int64_t>(std::floor(origin.z() / kHouse));
    double entered = 0;
    for (int i = 0; i < 16; ++i, house += onwards) {
      const double front = frontOf(house, side);
      if (entered > 0 && way * (origin.x() + entered * ray.x()) > front)
        return Hit{entered, house, side};
      const double edge = kHouse * static_cast<double>(onwards > 0 ? house + 1 : house);
      const double left = (edge - origin.z()) / ray.z();
      const double reached = std::abs(ray.x()) > 1e-9 ? (way * front - origin.x()) / ray.x() : 1e9;
      if (reached > 0 && reached <= left) return Hit{reached, house, side};
      entered = left;
    }
    return {};
  }

  Image imageAt(const Eigen::Isometry3d& T) const {
    const CameraRig rig = houseRig();
    return Image::create(rig.width, rig.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
      for (int u = 0; u < rig.width; ++u) {
        const Eigen::Vector3d ray = T.linear() * rig.pinhole.ray({u, 0});
        const auto hit = firstHouse(T.translation(), {ray.x(), 0, ray.z()});
        for (int v = 0; v < rig.height; ++v) {
          const double slope = rig.pinhole.ray({u, v}).y();
          data[v * rig.width + u] = shade(T.translation(), {ray.x(), slope, ray.z()}, hit);
        }
      }
    });
  }

  /// Patches of 0.2 m, blurred by nothing: block matching needs no more.
  std::uint8_t shade(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray,
                     const std::optional<Hit>& hit) const {
    const double to_ground = ray.y() > 1e-6 ? kEye / ray.y() : 1e9;
    const double s = std::min(to_ground, hit ? hit->s : 1e9);
    if (s > 60) return 200;
    const Eigen::Vector3d p = origin + s * ray;
    if (hit && s == hit->s && kEye - p.y() > heightOf(hit->house, hit->side)) return 200;
    const auto cell = [](double metres) {
      return static_cast<std::int64_t>(std::floor(5 * metres));
    };
    RandomStream random(seed_ + static_cast<std::uint64_t>(cell(p.x() + 1e-6) * 73856093 +
                                                           cell(p.y()) * 19349663 +
                                                           cell(p.z() + 1e-6) * 83492791));
    return static_cast<std::uint8_t>(30 + 200 * random.uniform());
  }

  std::uint64_t seed_;
};

}  // namespace tolman::view_sequences::test
