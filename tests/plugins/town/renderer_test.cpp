// SPDX-License-Identifier: BSD-3-Clause
// Geometry of images: projections, depth, textures without aliasing.
#include "renderer.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "small_town.hpp"
#include "tolman/context.hpp"
#include "world.hpp"

using namespace tolman;
using namespace tolman::town;
using town::test::SmallTown;

namespace {

constexpr double kGrey = 260;  // grey levels for a radiance of 1, about what the source takes

struct Sample {
  double value;
  double gradient_u;
};

/// Bilinear radiance at (u, v) where all four pixels have about the depth expected there.
std::optional<Sample> sampleAt(const RenderedImage& p, const RenderCamera& view, double u, double v,
                               double depth) {
  if (u < 1 || v < 1 || u >= view.width - 2 || v >= view.height - 2) return std::nullopt;
  const int c = static_cast<int>(u);
  const int r = static_cast<int>(v);
  const double fu = u - c;
  const double fv = v - r;
  const auto index = [&](int dc, int dr) {
    return static_cast<std::size_t>(r + dr) * static_cast<std::size_t>(view.width) +
           static_cast<std::size_t>(c + dc);
  };
  for (int dr = 0; dr < 2; ++dr) {
    for (int dc = 0; dc < 2; ++dc) {
      const double there = static_cast<double>(p.depth[index(dc, dr)]);
      if (there == 0 || std::abs(there - depth) > 0.03 * depth) return std::nullopt;
    }
  }
  const auto at = [&](int dc, int dr) { return static_cast<double>(p.radiance[index(dc, dr)]); };
  const double top = (1 - fu) * at(0, 0) + fu * at(1, 0);
  const double bottom = (1 - fu) * at(0, 1) + fu * at(1, 1);
  const double slope = (1 - fv) * (at(1, 0) - at(0, 0)) + fv * (at(1, 1) - at(0, 1));
  return Sample{kGrey * ((1 - fv) * top + fv * bottom), kGrey * slope};
}

/// Of many pixels in several pairs of pictures.
struct Residuals {
  std::vector<double> grey;    ///< absolute, grey levels
  std::vector<double> shifts;  ///< px, horizontal ones that would explain them, where it is steep

  static double quantile(std::vector<double> values, double q) {
    const auto nth = static_cast<std::ptrdiff_t>(q * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + nth, values.end());
    return values[static_cast<std::size_t>(nth)];
  }
  double median() const { return quantile(grey, 0.5); }
  double shift() const { return quantile(shifts, 0.5); }
};

/// Whether the eight neighbours of a pixel are on about the same surface: no silhouette runs there.
bool isSmooth(const RenderedImage& p, const RenderCamera& view, int column, int row) {
  if (column < 1 || row < 1 || column > view.width - 2 || row > view.height - 2) return false;
  const auto at = [&](int c, int r) {
    return p.depth[static_cast<std::size_t>(r * view.width + c)];
  };
  for (int dr = -1; dr <= 1; ++dr) {
    for (int dc = -1; dc <= 1; ++dc) {
      const float step = std::abs(at(column + dc, row + dr) - at(column, row));
      if (step > 0.1F * at(column, row)) return false;
    }
  }
  return true;
}

/// Carries every pixel of `a` into `b` by its true depth, and compares.
void reproject(const RenderedImage& a, const RenderCamera& view_a, const RenderedImage& b,
               const RenderCamera& view_b, Residuals& residuals) {
  const Eigen::Isometry3d T_b_a = view_b.T_town_camera.inverse() * view_a.T_town_camera;
  for (int row = 0; row < view_a.height; ++row) {
    for (int column = 0; column < view_a.width; ++column) {
      const auto i = static_cast<std::size_t>(row * view_a.width + column);
      const auto depth = static_cast<double>(a.depth[i]);
      if (depth == 0 || !isSmooth(a, view_a, column, row)) continue;
      const Eigen::Vector3d p = T_b_a * (depth * view_a.pinhole.ray({column, row}));
      if (p.z() < 1) continue;
      const Eigen::Vector2d q = view_b.pinhole.project(p);
      const auto sample = sampleAt(b, view_b, q.x(), q.y(), p.z());
      if (!sample) continue;
      const double residual = sample->value - kGrey * static_cast<double>(a.radiance[i]);
      residuals.grey.push_back(std::abs(residual));
      if (std::abs(sample->gradient_u) > 5) {
        residuals.shifts.push_back(residual / sample->gradient_u);
      }
    }
  }
}

RenderCamera moved(const RenderCamera& view, const Eigen::Vector3d& by) {
  RenderCamera result = view;
  result.T_town_camera = view.T_town_camera * Eigen::Translation3d(by);
  return result;
}

/// Residuals from the left to another picture, over the whole route. `other(k)` is its view.
template <class Other>
Residuals alongRoute(const SmallTown& town, const Other& other) {
  Residuals residuals;
  for (std::size_t k = 5; k + 1 < town.route.T_town_camera.size(); k += 45) {
    const RenderCamera left = SmallTown::view(town.route.T_town_camera[k]);
    const RenderCamera there = other(k, left);
    reproject(town.picture(left), left, town.picture(there), there, residuals);
  }
  REQUIRE(residuals.grey.size() > 200000);
  INFO("median " << residuals.median() << " grey levels, shift " << residuals.shift() << " px");
  CHECK(residuals.median() < 0.5);  // the sensor's noise is 1.5 in the mid tones
  CHECK(Residuals::quantile(residuals.grey, 0.8) < 1.5);
  return residuals;
}

}  // namespace

TEST_CASE("left and right agree below the noise, without sub-pixel bias") {
  const SmallTown town;
  const Residuals residuals = alongRoute(town, [](std::size_t, const RenderCamera& left) {
    return moved(left, {0.5372, 0, 0});
  });
  CHECK(std::abs(residuals.shift()) < 0.01);
}

TEST_CASE("so do neighbouring frames as the car drives on") {
  const SmallTown town;
  const Residuals residuals = alongRoute(town, [&](std::size_t k, const RenderCamera&) {
    return SmallTown::view(town.route.T_town_camera[k + 1]);
  });
  CHECK(std::abs(residuals.shift()) < 0.01);
}

TEST_CASE("a wrong calibration would be noticed: the check of the check") {
  const SmallTown town;
  const RenderCamera left = SmallTown::view(town.route.T_town_camera[20]);
  const RenderCamera right = moved(left, {0.5372, 0, 0});
  RenderCamera wrong = right;
  wrong.pinhole.cx += 0.25;  // px
  Residuals residuals;
  reproject(town.picture(left), left, town.picture(right), wrong, residuals);
  CHECK(residuals.shift() == Approx(0.25).margin(0.05));
}

TEST_CASE("depth of the road is that of a plane below the camera") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[10]);
  const RenderedImage picture = town.picture(view, 0);
  int on_road = 0;
  for (int row = 95; row < view.height; ++row) {
    const Eigen::Vector3d ray = view.pinhole.ray({207, row});
    const auto depth =
        static_cast<double>(picture.depth[static_cast<std::size_t>(row * 414 + 207)]);
    const Eigen::Vector3d p = view.T_town_camera * (depth * ray);
    const double above = p.z() - town.plan.height(p.x(), p.y());
    REQUIRE(above > -0.03);
    on_road += above < 0.03;
  }
  CHECK(on_road > 25);
}

TEST_CASE("textures do not shimmer: a pixel at half size is about the mean of its four") {
  const SmallTown town;
  RenderCamera fine = SmallTown::view(town.route.T_town_camera[100]);
  RenderCamera coarse = fine;
  coarse.width /= 2;
  coarse.height /= 2;
  coarse.pinhole = {fine.pinhole.fx / 2, fine.pinhole.fy / 2, (fine.pinhole.cx - 0.5) / 2,
                    (fine.pinhole.cy - 0.5) / 2};
  const RenderedImage big = town.picture(fine, 8);
  const RenderedImage small = town.picture(coarse, 8);
  std::vector<double> differences;
  for (int row = 0; row < coarse.height; ++row) {
    for (int column = 0; column < coarse.width; ++column) {
      double mean = 0;
      for (const int k : {0, 1, 414, 415}) {
        mean += 0.25 * static_cast<double>(
                           big.radiance[static_cast<std::size_t>(2 * row * 414 + 2 * column + k)]);
      }
      const auto one = static_cast<double>(
          small.radiance[static_cast<std::size_t>(row * coarse.width + column)]);
      differences.push_back(kGrey * std::abs(one - mean));
    }
  }
  std::sort(differences.begin(), differences.end());
  CHECK(differences[differences.size() / 2] < 2);
  CHECK(differences[differences.size() * 9 / 10] < 12);
}

TEST_CASE("a rolling shutter takes each row where the camera is at its time") {
  const SmallTown town;
  const Eigen::Isometry3d start = town.route.T_town_camera[60];
  RenderCamera rolling = SmallTown::view(start);
  const auto poseOf = [&](int row) {
    return start * Eigen::Translation3d(0, 0, 0.004 * row) *
           Eigen::AngleAxisd(2e-4 * row, Eigen::Vector3d::UnitY());
  };
  for (int row = 0; row < rolling.height; ++row) rolling.T_town_rows.push_back(poseOf(row));
  const RenderedImage rolled = town.picture(rolling, 0);
  for (const int row : {0, 31, 62, 124}) {
    const RenderedImage still = town.picture(SmallTown::view(poseOf(row)), 0);
    int same = 0;
    for (int column = 0; column < rolling.width; ++column) {
      const auto at = static_cast<std::size_t>(row * rolling.width + column);
      same += std::abs(rolled.depth[at] - still.depth[at]) <= 1e-3F * still.depth[at];
    }
    CAPTURE(row);
    CHECK(same > 0.97 * rolling.width);
  }
}

namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;

/// A camera 2 m above the origin that looks along Y, turned by `yaw` to the left and `pitch` down.
RenderCamera viewAt(double yaw = 0, double pitch = 0) {
  RenderCamera view;
  Eigen::Matrix3d forward;
  forward << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  view.T_town_camera =
      Eigen::Translation3d(0, 0, 2) * Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
      Eigen::Isometry3d(forward) * Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitX());
  view.width = kWidth;
  view.height = kHeight;
  view.pinhole = {110, 105, 77.3, 61.8};
  return view;
}

std::uint32_t addTone(World& world, float tone) {
  Surface surface;
  surface.tone = tone;
  return world.addSurface(surface);
}

void addGround(World& world, float tone) {
  addQuad(world.fixed,
          {Vec3{-500, -500, 0}, Vec3{500, -500, 0}, Vec3{500, 500, 0}, Vec3{-500, 500, 0}},
          addTone(world, tone));
}

struct Picture {
  Picture(World world, const Light& light, const RenderCamera& of, int edge_samples = 8)
      : view(of) {
    const Scene scene(std::move(world));
    Renderer(scene, StreetPlan(), light, edge_samples).render(view, image);
  }
  double at(const std::vector<float>& values, int column, int row) const {
    return static_cast<double>(values[static_cast<std::size_t>(row * kWidth + column)]);
  }
  double radiance(int column, int row) const { return at(image.radiance, column, row); }
  double depth(int column, int row) const { return at(image.depth, column, row); }

  RenderCamera view;
  RenderedImage image;
};

/// Overcast: the same light on everything of one facing, and no shadows.
Light evenLight() {
  Light light;
  light.sun = 0;
  light.sky = 1;
  light.clouds = 0;
  return light;
}

}  // namespace

TEST_CASE("depth is that of planes in any attitude of the camera") {
  RandomStream random(41);
  for (int round = 0; round < 10; ++round) {
    const RenderCamera view = viewAt(random.uniform(-0.5, 0.5), random.uniform(0.1, 0.5));
    const double wall = random.uniform(8, 25);
    World world;
    addGround(world, 0.3F);
    const auto y = static_cast<float>(wall);
    addQuad(world.fixed, {Vec3{-400, y, -1}, Vec3{400, y, -1}, Vec3{400, y, 90}, Vec3{-400, y, 90}},
            addTone(world, 0.6F));
    const Picture picture(std::move(world), evenLight(), view, 0);
    const Eigen::Vector3d eye = view.T_town_camera.translation();
    int walls = 0;
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        const Eigen::Vector3d d = view.T_town_camera.linear() * view.pinhole.ray({column, row});
        const double to_ground = d.z() < 0 ? -eye.z() / d.z() : 1e9;
        const double to_wall = wall / d.y();
        CAPTURE(round, column, row);
        REQUIRE(picture.depth(column, row) == Approx(std::min(to_ground, to_wall)).epsilon(1e-4));
        walls += to_wall < to_ground;
      }
    }
    CHECK(walls > 500);
    CHECK(walls < kWidth * kHeight);
  }
}

TEST_CASE("an upright edge is in the pixel of its projection, which it shares as it should") {
  RandomStream random(42);
  for (int round = 0; round < 12; ++round) {
    const auto x = static_cast<float>(random.uniform(-3, 3));
    World world;
    const std::uint32_t dark = addTone(world, 0.05F);
    const std::uint32_t bright = addTone(world, 0.8F);
    addQuad(world.fixed, {Vec3{-90, 12, -40}, Vec3{x, 12, -40}, Vec3{x, 12, 40}, Vec3{-90, 12, 40}},
            dark);
    addQuad(world.fixed, {Vec3{x, 12, -40}, Vec3{90, 12, -40}, Vec3{90, 12, 40}, Vec3{x, 12, 40}},
            bright);
    const RenderCamera view = viewAt();
    const Picture picture(std::move(world), evenLight(), view);
    const double edge = view.pinhole.project({static_cast<double>(x), 0, 12}).x();
    const int column = static_cast<int>(std::lround(edge));
    double share = 0;  // of the dark side, a pixel reaching half a pixel to either side
    for (int row = 0; row < kHeight; ++row) {
      const double left = picture.radiance(column - 2, row);
      const double right = picture.radiance(column + 2, row);
      share += (right - picture.radiance(column, row)) / (right - left) / kHeight;
    }
    CAPTURE(round, edge);
    CHECK(share == Approx(edge - column + 0.5).margin(0.15));  // nine samples a pixel
  }
}

TEST_CASE("a wall's shadow ends on the ground where the sun says") {
  Light light = evenLight();
  light.sun = 1;
  light.sky = 0.2F;
  for (const double height : {1.0, 1.7, 2.6}) {
    // The sun stands behind the wall, 45 degrees high: the shadow is as long as the wall is high.
    light.to_sun = normalised({0, 1, 1});
    World world;
    addGround(world, 0.4F);
    const auto top = static_cast<float>(height);
    addQuad(world.fixed,
            {Vec3{-300, 12, -1}, Vec3{300, 12, -1}, Vec3{300, 12, top}, Vec3{-300, 12, top}},
            addTone(world, 0.4F));
    const RenderCamera view = viewAt(0, 0.1);
    const Picture picture(std::move(world), light, view);
    const Eigen::Isometry3d T_camera_town = view.T_town_camera.inverse();
    const auto rowOf = [&](double y) {
      return view.pinhole.project(T_camera_town * Eigen::Vector3d(0, y, 0)).y();
    };
    const auto column = static_cast<int>(std::lround(view.pinhole.cx));
    const auto grey = [&](double y) {
      return picture.radiance(column, static_cast<int>(std::lround(rowOf(y))));
    };
    CAPTURE(height);
    const double lit = grey(5);
    const double shaded = grey(12 - 0.5 * height);
    CHECK(shaded < 0.3 * lit);
    const double middle = 0.5 * (lit + shaded);
    const double end = rowOf(12 - height);
    CHECK(picture.radiance(column, static_cast<int>(std::floor(end - 1))) < middle);
    CHECK(picture.radiance(column, static_cast<int>(std::ceil(end + 1))) > middle);
  }
}

TEST_CASE("a moved principal point and focal length move and stretch the picture, no more") {
  World world;
  addGround(world, 0.3F);
  addBox(world.fixed, {-2, 9, 0}, {Vec3{3, 0, 0}, Vec3{0, 2, 0}, Vec3{0, 0, 3}},
         addTone(world, 0.7F));
  const RenderCamera view = viewAt();
  RenderCamera shifted = view;
  shifted.pinhole.cx += 7;
  shifted.pinhole.cy -= 4;
  const Picture a(world, evenLight(), view);
  const Picture b(world, evenLight(), shifted);
  for (int row = 5; row < kHeight - 1; ++row) {
    for (int column = 1; column < kWidth - 8; ++column) {
      REQUIRE(b.depth(column + 7, row - 4) == Approx(a.depth(column, row)).epsilon(1e-4));
    }
  }
  RenderCamera wide = view;  // half the focal length: every second ray
  wide.pinhole = {55, 52.5, 77.3 / 2, 61.8 / 2};
  const Picture c(world, evenLight(), wide, 0);
  for (int row = 0; row < kHeight / 2; ++row) {
    for (int column = 0; column < kWidth / 2; ++column) {
      REQUIRE(c.depth(column, row) == Approx(a.depth(2 * column, 2 * row)).epsilon(1e-4));
    }
  }
}
