// SPDX-License-Identifier: BSD-3-Clause
// Images of planes, edges and shadows whose position is known in closed form.
#include <catch2/catch.hpp>
#include <cmath>

#include "renderer.hpp"
#include "shapes.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;

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

TEST_CASE("the share of an edge's pixel is about what the surface covers of it") {
  // A dark board before a bright wall; its upper edge is level with the camera, or a little higher.
  const Light light = evenLight();
  for (const double shift : {0.0, 0.2, 0.4, 0.6, 0.8}) {
    World world;
    const auto top = static_cast<float>(2 + 0.1 * shift);
    const std::uint32_t dark = addTone(world, 0.05F);
    const std::uint32_t bright = addTone(world, 0.8F);
    addQuad(world.fixed,
            {Vec3{-90, 10, -40}, Vec3{90, 10, -40}, Vec3{90, 10, top}, Vec3{-90, 10, top}}, dark);
    addQuad(world.fixed,
            {Vec3{-90, 11, -40}, Vec3{90, 11, -40}, Vec3{90, 11, 60}, Vec3{-90, 11, 60}}, bright);
    const RenderCamera view = viewAt();
    const Picture picture(std::move(world), light, view);
    const double edge = view.pinhole.project({0, 2 - static_cast<double>(top), 10}).y();
    const int row = static_cast<int>(std::lround(edge));
    const double covered = 0.5 - (edge - row);  // by the dark plane, which is below
    double share = 0;
    for (int column = 0; column < kWidth; ++column) {
      const double above = picture.radiance(column, row - 3);
      const double below = picture.radiance(column, row + 3);
      share += (above - picture.radiance(column, row)) / (above - below) / kWidth;
    }
    CAPTURE(shift, edge, covered);
    CHECK(share == Approx(covered).margin(0.15));  // nine samples a pixel
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
