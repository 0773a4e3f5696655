// SPDX-License-Identifier: BSD-3-Clause
// Geometry of images: with true depth and poses one image maps to another within a small part of a
// pixel, and textures have no aliasing.
#include "renderer.hpp"

#include <oneapi/tbb/global_control.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <optional>

#include "small_town.hpp"

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

TEST_CASE("the picture does not depend on the number of threads, nor on the call") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[50]);
  const RenderedImage many = town.picture(view);
  const oneapi::tbb::global_control one(oneapi::tbb::global_control::max_allowed_parallelism, 1);
  const RenderedImage single = town.picture(view);
  CHECK(many.radiance == single.radiance);
  CHECK(many.depth == single.depth);
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

TEST_CASE("edges are smoothed where asked") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[100]);
  const RenderedImage jagged = town.picture(view, 0);
  const RenderedImage smooth = town.picture(view, 4);
  CHECK(jagged.depth == smooth.depth);
  std::size_t changed = 0;
  for (std::size_t i = 0; i < jagged.radiance.size(); ++i) {
    changed += jagged.radiance[i] != smooth.radiance[i];
  }
  CHECK(changed > jagged.radiance.size() / 100);
  CHECK(changed < jagged.radiance.size() / 2);
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
