// SPDX-License-Identifier: BSD-3-Clause
// Blur from depth, compared with the mean of many images rendered during the motion, and with
// coverages of a simple silhouette.
#include "shutter_blur.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "small_town.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

namespace {

using Pixels = std::vector<float>;

double difference(const Pixels& a, const Pixels& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(std::abs(a[i] - b[i]));
  return sum / static_cast<double>(a.size());
}

ShutterMotion motionOf(const Vector6d& twist) {
  return {expSe3(0.5 * twist), expSe3(-0.5 * twist)};
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

TEST_CASE("a camera that stands does not blur") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[60]);
  const RenderedImage sharp = town.picture(view);
  CHECK(shutterBlur(view, sharp, {}) == sharp.radiance);
}

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
