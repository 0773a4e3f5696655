// SPDX-License-Identifier: BSD-3-Clause
// Ray casting against four planes.
#include "support/street_scene.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::test {
namespace {

/// A fixed random number in [0, 1) for a lattice point.
double lattice(std::int64_t x, std::int64_t y, std::int64_t plane) {
  auto h = static_cast<std::uint64_t>(x * 73856093 + y * 19349663 + plane * 83492791);
  h = (h ^ (h >> 30U)) * 0xbf58476d1ce4e5b9ULL;
  h = (h ^ (h >> 27U)) * 0x94d049bb133111ebULL;
  return static_cast<double>((h ^ (h >> 31U)) >> 11U) * 0x1.0p-53;
}

double smooth(double t) { return t * t * (3 - 2 * t); }

double noise(double x, double y, std::int64_t plane) {
  const auto i = static_cast<std::int64_t>(std::floor(x));
  const auto j = static_cast<std::int64_t>(std::floor(y));
  const double a = smooth(x - double(i));
  const double b = smooth(y - double(j));
  return (1 - b) * ((1 - a) * lattice(i, j, plane) + a * lattice(i + 1, j, plane)) +
         b * ((1 - a) * lattice(i, j + 1, plane) + a * lattice(i + 1, j + 1, plane));
}

/// Octaves that are finer than a few pixels fade, or distance would alias.
double texture(double x, double y, std::int64_t plane, double metres_a_pixel) {
  double value = 0;
  double weight = 0;
  for (double wave = 0.15; wave < 3; wave *= 2) {
    const double visible = std::clamp(wave / (4 * metres_a_pixel) - 0.5, 0.0, 1.0);
    value += visible * noise(x / wave, y / wave, plane);
    weight += visible;
  }
  return weight > 0 ? value / weight : 0.5;
}

/// Where a ray meets the street: after `depth` times its direction, on a plane.
struct Hit {
  double depth = std::numeric_limits<double>::infinity();
  std::int64_t plane = -1;
  Eigen::Index axis = 0;  ///< of the plane's normal
};

Hit firstHit(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) {
  // axis of the normal, and its position
  constexpr double kPlanes[4][2] = {{1, 1.5}, {0, -5}, {0, 6}, {2, 60}};
  Hit hit;
  for (std::int64_t k = 0; k < 4; ++k) {
    const auto axis = static_cast<Eigen::Index>(kPlanes[k][0]);
    const double s = (kPlanes[k][1] - origin[axis]) / ray[axis];
    if (s > 0.1 && s < hit.depth) hit = {s, k, axis};
  }
  return hit;
}

std::uint8_t shade(const Eigen::Vector3d& origin, const Eigen::Vector3d& ray, double focal) {
  const Hit hit = firstHit(origin, ray);
  double value = 0.5;
  if (hit.plane >= 0) {
    const Eigen::Vector3d p = origin + hit.depth * ray;
    value = texture(p[(hit.axis + 1) % 3], p[(hit.axis + 2) % 3], hit.plane, hit.depth / focal);
  }
  return static_cast<std::uint8_t>(std::lround(20 + 215 * value));
}

Image render(const CameraRig& rig, const Eigen::Isometry3d& T_world_camera) {
  return Image::create(rig.width, rig.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    for (int v = 0; v < rig.height; ++v) {
      for (int u = 0; u < rig.width; ++u) {
        const Eigen::Vector3d ray = T_world_camera.linear() * rig.pinhole.ray({u, v});
        *data++ = shade(T_world_camera.translation(), ray, rig.pinhole.fx);
      }
    }
  });
}

}  // namespace

CameraRig streetRig() {
  CameraRig rig;
  rig.width = 480;
  rig.height = 200;
  rig.calibrated = true;
  rig.pinhole = {300, 300, 239.5, 99.5};
  rig.baseline = 0.5;
  return rig;
}

NamedArray streetDepth(const Eigen::Isometry3d& T_world_camera) {
  const CameraRig rig = streetRig();
  NamedArray depth{"depth.left", {rig.height, rig.width}, {}};
  for (int v = 0; v < rig.height; ++v) {
    for (int u = 0; u < rig.width; ++u) {
      const Eigen::Vector3d ray = T_world_camera.linear() * rig.pinhole.ray({u, v});
      const Hit hit = firstHit(T_world_camera.translation(), ray);
      depth.values.push_back(hit.plane < 0 ? 0 : static_cast<float>(hit.depth));
    }
  }
  return depth;
}

Frame streetFrame(std::int64_t index, const Eigen::Isometry3d& T_world_camera) {
  const CameraRig rig = streetRig();
  Eigen::Isometry3d right = T_world_camera;
  right.translate(Eigen::Vector3d(rig.baseline, 0, 0));
  Frame frame;
  frame.frame = index;
  frame.stamp_ns = index * 100'000'000;
  frame.left = render(rig, T_world_camera);
  frame.right = render(rig, right);
  return frame;
}

Frame again(const Frame& frame, std::int64_t index) {
  Frame copy = frame;
  copy.frame = index;
  copy.stamp_ns = index * 100'000'000;
  return copy;
}

Frame withPassersBy(const Frame& frame, std::int64_t index) {
  constexpr double kBaseline = 0.5;
  constexpr double kFocal = 300;
  const auto show = [&](const Image& image, std::int64_t camera) {
    return Image::create(image.width(), image.height(), PixelFormat::Gray8, [&](std::uint8_t* out) {
      for (int v = 0; v < image.height(); ++v) {
        for (int u = 0; u < image.width(); ++u) {
          double grey = image.row(v)[u];
          for (int person = 2; person >= 0; --person) {  // the nearest last
            const double depth = 3 + person;
            const double side = person == 1 ? -1 : 1;
            const double walked = 0.12 * static_cast<double>(index) * side + 2.5 * person;
            const double x = std::fmod(std::fmod(walked, 10) + 10, 10) - 5;
            const double along =
                u - 240 - kFocal * (x - kBaseline * static_cast<double>(camera)) / depth;
            const double across = v - 60;
            const bool covers = std::fabs(along) < 75 / depth && across > 0 && across < 480 / depth;
            if (covers) grey = 60 + 100 * noise(along / 12 + 50, across / 12, 7 + person);
          }
          const auto pixel = std::int64_t{v} * image.width() + u;
          double jitter = -2;  // of four uniform numbers: standard deviation 0.58
          for (std::int64_t k = 0; k < 4; ++k) jitter += lattice(pixel, 4 * index + k, 20 + camera);
          *out++ =
              static_cast<std::uint8_t>(std::clamp(std::lround(grey + 2.6 * jitter), 0L, 255L));
        }
      }
    });
  };
  Frame busy = again(frame, index);
  busy.left = show(frame.left, 0);
  busy.right = show(frame.right, 1);
  return busy;
}

Image changed(const Image& image, double gain, double offset) {
  return Image::create(image.width(), image.height(), PixelFormat::Gray8, [&](std::uint8_t* data) {
    for (int v = 0; v < image.height(); ++v) {
      for (int u = 0; u < image.width(); ++u) {
        const double value = std::clamp(gain * image.row(v)[u] + offset, 0.0, 255.0);
        *data++ = static_cast<std::uint8_t>(std::lround(value));
      }
    }
  });
}

Image filled(int grey) {
  const CameraRig rig = streetRig();
  return Image::create(rig.width, rig.height, PixelFormat::Gray8, [&](std::uint8_t* data) {
    std::fill_n(data, rig.width * rig.height, static_cast<std::uint8_t>(grey));
  });
}

}  // namespace tolman::test
