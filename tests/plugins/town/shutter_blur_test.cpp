// SPDX-License-Identifier: BSD-3-Clause
// Blur from depth, compared with the mean of many images rendered during the motion.
#include "shutter_blur.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "small_town.hpp"
#include "tolman/geometry.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

namespace {

double difference(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += static_cast<double>(std::abs(a[i] - b[i]));
  return sum / static_cast<double>(a.size());
}

}  // namespace

TEST_CASE("a camera that stands does not blur") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[60]);
  const RenderedImage sharp = town.picture(view);
  CHECK(shutterBlur(view, sharp.radiance, sharp.depth, Eigen::Isometry3d::Identity()) ==
        sharp.radiance);
}

TEST_CASE("blur is the mean of the pictures while the shutter is open") {
  const SmallTown town;
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[60]);
  for (const auto& [ahead, turn] :
       {std::pair{0.25, 0.0}, std::pair{0.0, 0.02}, std::pair{0.2, 0.01}}) {
    Vector6d motion = Vector6d::Zero();
    motion[2] = ahead;
    motion[4] = turn;
    std::vector<float> mean(static_cast<std::size_t>(view.width * view.height), 0);
    constexpr int kPictures = 16;
    for (int i = 0; i < kPictures; ++i) {
      RenderCamera moved = view;
      moved.T_town_camera = view.T_town_camera * expSe3(((i + 0.5) / kPictures - 0.5) * motion);
      const RenderedImage picture = town.picture(moved);
      for (std::size_t p = 0; p < mean.size(); ++p) mean[p] += picture.radiance[p] / kPictures;
    }
    const RenderedImage sharp = town.picture(view);
    const auto blurred = shutterBlur(view, sharp.radiance, sharp.depth,
                                     expSe3(0.5 * motion).inverse() * expSe3(-0.5 * motion));
    CAPTURE(ahead, turn);
    const double before = difference(sharp.radiance, mean);
    // Where the camera moves ahead, crowns of trees cover each other in new ways.
    CHECK(difference(blurred, mean) < (ahead > 0 ? 0.75 : 0.4) * before);
    CHECK(before > 0.002);
  }
}
