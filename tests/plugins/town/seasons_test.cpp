// SPDX-License-Identifier: BSD-3-Clause
// Bare trees and other cars are at the places of the usual ones.
#include "seasons.hpp"

#include <algorithm>
#include <catch2/catch.hpp>

#include "small_town.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

namespace {

World worldOf(std::string_view name) {
  const CameraRoute route = builtInRoute(name, {}).value();
  return buildWorld(StreetPlan::grow(route, 1.65).value(), {});
}

std::size_t leavesOf(const World& world, std::uint32_t prototype) {
  const auto& surfaces = world.prototypes[prototype].surfaces;
  return static_cast<std::size_t>(std::count_if(surfaces.begin(), surfaces.end(), [&](auto s) {
    return world.surfaces[s].material == Material::Leaves;
  }));
}

}  // namespace

TEST_CASE("every broadleaved tree has a bare one in its place, evergreens have none") {
  World world = worldOf("block");
  const std::size_t before = world.instances.size();
  const Exchange trees = addBareTrees(world);
  REQUIRE(trees.usual.size() == trees.other.size());
  REQUIRE(trees.usual.size() > 20);
  CHECK(world.instances.size() == before + trees.other.size());
  for (std::size_t i = 0; i < trees.usual.size(); ++i) {
    const MeshInstance& leafy = world.instances[trees.usual[i]];
    const MeshInstance& bare = world.instances[trees.other[i]];
    CHECK(leavesOf(world, leafy.prototype) > 0);
    CHECK(leavesOf(world, bare.prototype) == 0);
    CHECK_FALSE(world.prototypes[bare.prototype].triangles.empty());
    CHECK(norm(leafy.placement.position - bare.placement.position) == 0);
    CHECK(std::count(world.evergreens.begin(), world.evergreens.end(), leafy.prototype) == 0);
  }
}

TEST_CASE("on another day about two of three places have a car, others than usual") {
  World world = worldOf("eights");
  const Exchange cars = addOtherCars(world, 7);
  REQUIRE(cars.usual.size() > 10);
  const double share =
      static_cast<double>(cars.other.size()) / static_cast<double>(cars.usual.size());
  CHECK(share > 0.4);
  CHECK(share < 0.9);
  for (const std::size_t i : cars.other) {
    const MeshInstance& other = world.instances[i];
    float nearest = 1e9F;
    for (const std::size_t usual : cars.usual) {
      CHECK(world.instances[usual].seed != other.seed);
      nearest = std::min(
          nearest, norm(world.instances[usual].placement.position - other.placement.position));
    }
    CHECK(nearest <= 0.41F);
  }
}

TEST_CASE("hidden instances are not seen until shown") {
  const SmallTown town;
  World world = worldOf("block");
  const Exchange trees = addBareTrees(world);
  Scene scene(std::move(world));
  const RenderCamera view = SmallTown::view(town.route.T_town_camera[30]);
  const auto picture = [&] {
    RenderedImage image;
    Renderer(scene, town.plan, town.light, 0).render(view, image);
    return image.depth;
  };
  const auto show = [&](const std::vector<std::size_t>& instances, bool shown) {
    for (const std::size_t i : instances) scene.show(i, shown);
  };
  show(trees.other, false);
  scene.commit();
  CHECK(picture() == town.picture(view, 0).depth);
  show(trees.usual, false);
  show(trees.other, true);
  scene.commit();
  const std::vector<float> bare = picture();
  const std::vector<float> leafy = town.picture(view, 0).depth;
  double farther = 0;
  double nearer = 0;
  for (std::size_t i = 0; i < bare.size(); ++i) {
    const auto depth = [](float d) { return d > 0 ? d : 1e4F; };
    farther += depth(bare[i]) > 1.05F * depth(leafy[i]);
    nearer += depth(bare[i]) < 0.95F * depth(leafy[i]);
  }
  CHECK(farther > 5 * nearer);
  CHECK(farther > 500);
}
