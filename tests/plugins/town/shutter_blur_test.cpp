// SPDX-License-Identifier: BSD-3-Clause
// Blur from depth: samples between pixels, paths of surfaces, means along them.
#include "shutter_blur.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "small_town.hpp"
#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

TEST_CASE("bilinear interpolation is exact on planes, and constant outside") {
  std::vector<float> plane;
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 7; ++column) {
      plane.push_back(static_cast<float>(2 * column - 3 * row));
    }
  }
  const ImageSamples samples{plane, 7, 5};
  CHECK(samples.at(2.25F, 1.5F) == Approx(0.0F));
  CHECK(samples.at(6, 4) == Approx(0.0F));
  CHECK(samples.at(-5, 0) == Approx(0.0F));
  CHECK(samples.at(90, -1) == Approx(12.0F));
}

TEST_CASE("box means are those of the pixels in the box, less at the border") {
  RandomStream random(5);
  constexpr int kWidth = 37;  // whole groups of lines and single ones
  constexpr int kHeight = 11;
  std::vector<float> image;
  for (int i = 0; i < kWidth * kHeight; ++i) {
    image.push_back(static_cast<float>(random.uniform(0, 10)));
  }
  for (const int radius : {1, 3, 20}) {
    const std::vector<float> blurred = boxBlur(image, kWidth, kHeight, radius);
    for (int row = 0; row < kHeight; ++row) {
      for (int column = 0; column < kWidth; ++column) {
        double sum = 0;
        int count = 0;
        for (int r = std::max(row - radius, 0); r <= std::min(row + radius, kHeight - 1); ++r) {
          for (int c = std::max(column - radius, 0); c <= std::min(column + radius, kWidth - 1);
               ++c) {
            sum += static_cast<double>(image[static_cast<std::size_t>(r * kWidth + c)]);
            ++count;
          }
        }
        CAPTURE(radius, row, column);
        REQUIRE(static_cast<double>(blurred[static_cast<std::size_t>(row * kWidth + column)]) ==
                Approx(sum / count).epsilon(1e-5));
      }
    }
  }
}

namespace {

RenderCamera cameraAt(const Eigen::Isometry3d& T_town_camera) {
  RenderCamera view;
  view.T_town_camera = T_town_camera;
  view.width = 40;
  view.height = 20;
  view.pinhole = {100, 110, 18, 9};
  return view;
}

/// Depth grows along rows; every third column belongs to instance 7, the last row is sky.
RenderedImage slope(const RenderCamera& view) {
  RenderedImage picture;
  for (int row = 0; row < view.height; ++row) {
    for (int column = 0; column < view.width; ++column) {
      picture.depth.push_back(row + 1 == view.height ? 0 : 4 + 0.5F * static_cast<float>(column));
      picture.instance.push_back(column % 3 == 0 ? 7 : column % 3 == 1 ? 2 : kNoInstance);
      picture.radiance.push_back(0);
    }
  }
  return picture;
}

ShutterMotion motionOf(const Vector6d& twist) {
  return {expSe3(0.5 * twist), expSe3(-0.5 * twist)};
}

Eigen::Vector2d projected(const Pinhole& k, const Eigen::Vector3d& p) {
  return {k.fx * p.x() / p.z() + k.cx, k.fy * p.y() / p.z() + k.cy};
}

}  // namespace

TEST_CASE("paths are those of projected points, of the fixed town and of objects") {
  const Eigen::Isometry3d T_town_camera =
      Eigen::Translation3d(3, -2, 1) *
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  const RenderCamera view = cameraAt(T_town_camera);
  const RenderedImage picture = slope(view);
  const OpenShutter shutter = {motionOf((Vector6d() << 0.02, 0, 0.3, 0, 0.02, 0.01).finished()),
                               {{}, motionOf((Vector6d() << 0.2, 0.1, 0, 0, 0, 0.1).finished())},
                               6};
  const PixelPaths paths = pixelPaths(view, picture, shutter);
  for (const auto& [column, row] : {std::pair{0, 0}, {3, 5}, {4, 5}, {5, 5}, {39, 18}, {10, 19}}) {
    CAPTURE(column, row);
    const auto i = static_cast<std::size_t>(row * view.width + column);
    const double z = row == 19 ? 1e4 : static_cast<double>(picture.depth[i]);
    const Eigen::Vector3d point((column - 18.0) / 100 * z, (row - 9.0) / 110 * z, z);
    const ShutterMotion object = column % 3 == 0 ? shutter.objects[1] : ShutterMotion{};
    const auto seen = [&](const Eigen::Isometry3d& camera, const Eigen::Isometry3d& town) {
      return projected(view.pinhole,
                       camera * (T_town_camera.inverse() * (town * (T_town_camera * point))));
    };
    const Eigen::Vector2d way = seen(shutter.camera.T_end_middle, object.T_end_middle) -
                                seen(shutter.camera.T_begin_middle, object.T_begin_middle);
    CHECK(static_cast<double>(paths.u[i]) == Approx(way.x()).margin(0.02));
    CHECK(static_cast<double>(paths.v[i]) == Approx(way.y()).margin(0.02));
  }
}

TEST_CASE("paths are bounded, and none where a surface passes the camera") {
  const RenderCamera view = cameraAt(Eigen::Isometry3d::Identity());
  RenderedImage picture = slope(view);
  picture.depth[0] = 0.2F;
  const Eigen::Isometry3d half(Eigen::Translation3d(0, 0, 1));
  const PixelPaths ahead = pixelPaths(view, picture, {{half, half.inverse()}, {}, 0});
  CHECK(ahead.at(0).square() == 0);
  CHECK(ahead.at(5).square() > 1);
  const Eigen::Isometry3d aside(Eigen::Translation3d(-9, 0, 0));
  const PixelPaths swift = pixelPaths(view, picture, {{aside.inverse(), aside}, {}, 0});
  CHECK(static_cast<double>(swift.u[1]) == Approx(-static_cast<double>(kLongestPath)));
}

namespace {

using Pixels = std::vector<float>;

double difference(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(std::abs(a[i] - b[i]));
  return sum / static_cast<double>(a.size());
}

/// Mean radiance of 32 pictures of a camera that moves by `twist`, in its own axes.
Pixels meanOfPictures(const SmallTown& town, const RenderCamera& view, const Vector6d& twist) {
  Pixels mean(static_cast<std::size_t>(view.width * view.height), 0);
  constexpr int kPictures = 32;
  for (int i = 0; i < kPictures; ++i) {
    RenderCamera moved = view;
    moved.T_town_camera = view.T_town_camera * expSe3(((i + 0.5) / kPictures - 0.5) * twist);
    const RenderedImage picture = town.picture(moved);
    for (std::size_t p = 0; p < mean.size(); ++p) mean[p] += picture.radiance[p] / kPictures;
  }
  return mean;
}

/// Pixels at whose distance of up to 6 px nothing is nearer or farther by more than a quarter.
std::vector<std::size_t> awayFromSilhouettes(const RenderCamera& view, const Pixels& depth) {
  constexpr int kReach = 6;
  std::vector<std::size_t> found;
  for (int row = kReach; row < view.height - kReach; ++row) {
    for (int column = kReach; column < view.width - kReach; ++column) {
      float least = 1e9F;
      float most = 0;
      for (int r = row - kReach; r <= row + kReach; ++r) {
        for (int c = column - kReach; c <= column + kReach; ++c) {
          const float z = depth[static_cast<std::size_t>(r * view.width + c)];
          least = std::min(least, z);
          most = std::max(most, z);
        }
      }
      if (least > 0 && most < 1.25F * least) {
        found.push_back(static_cast<std::size_t>(row * view.width + column));
      }
    }
  }
  return found;
}

constexpr int kPostWidth = 120;
constexpr int kPostHeight = 48;

RenderCamera smallCamera() {
  RenderCamera view;
  view.width = kPostWidth;
  view.height = kPostHeight;
  view.pinhole = {100, 100, 60, 24};
  return view;
}

/// A dark post of instance 4, 5 m away, from column 50 to 70 in front of a bright wall at 100 m.
RenderedImage post() {
  RenderedImage picture;
  for (int i = 0; i < kPostWidth * kPostHeight; ++i) {
    const bool is_post = i % kPostWidth >= 50 && i % kPostWidth < 70;
    picture.radiance.push_back(is_post ? 0 : 1);
    picture.depth.push_back(is_post ? 5 : 100);
    picture.instance.push_back(is_post ? 4 : kNoInstance);
  }
  return picture;
}

/// Brightest difference from a wall of which the post covers a share that falls linearly over
/// `path` px about its edges.
double worstShare(const Pixels& blurred, double path) {
  double worst = 0;
  for (int column = 10; column < kPostWidth - 10; ++column) {
    const double inside = std::min(column - 49.5, 69.5 - column);  // px from the nearer edge
    const double covered = std::clamp(0.5 + inside / std::max(path, 1e-6), 0.0, 1.0);
    const auto i = static_cast<std::size_t>(20 * kPostWidth + column);
    worst = std::max(worst, std::abs(1 - covered - static_cast<double>(blurred[i])));
  }
  return worst;
}

}  // namespace

TEST_CASE("blur is the mean of the pictures while the shutter is open") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[60]);
  const RenderedImage sharp = town.picture(view);
  const std::vector<std::size_t> inner = awayFromSilhouettes(view, sharp.depth);
  REQUIRE(inner.size() > 5000);
  const double grey = 110 / (0.2 * static_cast<double>(town.light.level()));  // as in TownSource
  for (const auto& [ahead, turn] :
       {std::pair{0.25, 0.0}, std::pair{0.0, 0.02}, std::pair{0.2, 0.01}}) {
    Vector6d twist = Vector6d::Zero();
    twist[2] = ahead;
    twist[4] = turn;
    const Pixels mean = meanOfPictures(town, view, twist);
    const Pixels blurred = shutterBlur(view, sharp, {motionOf(twist), {}, 0});
    CAPTURE(ahead, turn);
    const double before = difference(sharp.radiance, mean);
    // Where the camera moves ahead, crowns of trees cover each other in new ways.
    CHECK(difference(blurred, mean) < (ahead > 0 ? 0.65 : 0.3) * before);
    CHECK(before > 0.002);
    const auto partOf = [&](const Pixels& image) {
      Pixels part;
      for (const std::size_t i : inner) part.push_back(image[i]);
      return part;
    };
    const double error = grey * difference(partOf(blurred), partOf(mean));
    const double sharp_error = grey * difference(partOf(sharp.radiance), partOf(mean));
    CAPTURE(error, sharp_error);
    CHECK(error < 1);
    CHECK(error < 0.6 * sharp_error);
  }
}

TEST_CASE("a post that passes a far wall covers it for a share of the time") {
  const RenderCamera view = smallCamera();
  for (const double metres : {0.2, 0.6}) {  // 20 px for each metre
    Vector6d twist = Vector6d::Zero();
    twist[0] = metres;
    CAPTURE(metres);
    const Pixels blurred = shutterBlur(view, post(), {motionOf(twist), {}, 0});
    CHECK(worstShare(blurred, 20 * metres) < 0.15);
  }
}

TEST_CASE("an object that moves with the camera stays sharp, one that moves by itself blurs") {
  const RenderCamera view = smallCamera();
  Vector6d twist = Vector6d::Zero();
  twist[0] = 0.6;
  const ShutterMotion camera = motionOf(twist);
  const ShutterMotion along = {camera.T_begin_middle.inverse(), camera.T_end_middle.inverse()};
  const Pixels sharp = shutterBlur(view, post(), {camera, {along}, 4});
  CHECK(worstShare(sharp, 0) < 0.15);
  const Pixels moving = shutterBlur(view, post(), {{}, {{}, along}, 3});
  CHECK(worstShare(moving, 12) < 0.15);
  const Pixels another = shutterBlur(view, post(), {{}, {along}, 5});
  CHECK(another == post().radiance);
}
