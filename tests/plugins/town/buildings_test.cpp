// SPDX-License-Identifier: BSD-3-Clause
// Plots, houses, trees in winter, the car park and the hall.
#include "buildings.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "drawn_route.hpp"
#include "objects.hpp"
#include "probe.hpp"
#include "small_town.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::town;
using tolman::town::test::SmallTown;

namespace {

bool contains(const Plot& plot, const Eigen::Vector2d& p) {
  const Eigen::Vector2d d = p - plot.centre;
  return std::abs(d.dot(plot.axis)) <= plot.half_length &&
         std::abs(d.dot(plot.across())) <= plot.half_depth;
}

/// Whether any of many points of `a` lies in `b`.
bool overlapBySampling(const Plot& a, const Plot& b) {
  constexpr int kSteps = 60;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const double along = a.half_length * (2.0 * i / kSteps - 1);
      const double over = a.half_depth * (2.0 * j / kSteps - 1);
      if (contains(b, a.point(along, over))) return true;
    }
  }
  return false;
}

Plot randomPlot(RandomStream& random) {
  const double angle = random.uniform(0, 7);
  return {{random.uniform(-6, 6), random.uniform(-6, 6)},
          {std::cos(angle), std::sin(angle)},
          random.uniform(0.5, 4),
          random.uniform(0.5, 4)};
}

}  // namespace

TEST_CASE("overlap of rectangles agrees with sampling") {
  RandomStream random(11);
  int apart = 0;
  for (int i = 0; i < 1500; ++i) {
    const Plot a = randomPlot(random);
    const Plot b = randomPlot(random);
    const bool sampled = overlapBySampling(a, b) || overlapBySampling(b, a);
    REQUIRE(overlap(a, b) == overlap(b, a));
    if (sampled) REQUIRE(overlap(a, b));
    // What sampling misses is a sliver: shrunk a little, the plots are apart.
    Plot smaller = a;
    smaller.half_length *= 0.9;
    smaller.half_depth *= 0.9;
    if (!sampled) REQUIRE_FALSE(overlap(smaller, b));
    apart += !sampled;
  }
  CHECK(apart > 200);
  CHECK(apart < 1300);
}

TEST_CASE("the book keeps plots apart and streets free") {
  const town::test::SmallTown town;
  PlotBook book(town.plan);
  const StreetPoint& on_street = town.plan.sections().front().points[20];
  Plot plot;
  plot.half_length = plot.half_depth = 2;
  plot.centre = on_street.position;
  CHECK_FALSE(book.enter(plot, 3));
  const Eigen::Vector2d left(-on_street.direction.y(), on_street.direction.x());
  plot.axis = on_street.direction;
  plot.centre = on_street.position + 9 * left;
  CHECK(book.enter(plot, 3));
  CHECK_FALSE(book.enter(plot, 3));  // taken
  plot.centre += 2.5 * on_street.direction;
  CHECK_FALSE(book.enter(plot, 3));  // partly taken
  plot.centre += 2.5 * on_street.direction;
  CHECK(book.enter(plot, 3));
}

namespace {

constexpr double kGround = 31;

House houseOf(RoofShape roof, int storeys, std::uint32_t seed) {
  RandomStream random(seed);
  const double angle = random.uniform(0, 6.28);
  House house;
  house.plot = {{random.uniform(-50, 50), random.uniform(-50, 50)},
                {std::cos(angle), std::sin(angle)},
                random.uniform(3, 12),
                random.uniform(3, 7)};
  house.ground = kGround;
  house.storeys = storeys;
  house.roof = roof;
  house.seed = seed;
  return house;
}

World built(const House& house) {
  World world;
  addHouse(world, house);
  return world;
}

Eigen::Vector3d corner(const World& world, std::size_t triangle, std::size_t k) {
  const Mesh::Vertex& v = world.fixed.vertices[world.fixed.triangles[triangle][k]];
  return Eigen::Vector3f(v.x, v.y, v.z).cast<double>();
}

Eigen::Vector3d normal(const World& world, std::size_t triangle) {
  const Eigen::Vector3d a = corner(world, triangle, 0);
  return (corner(world, triangle, 1) - a).cross(corner(world, triangle, 2) - a).normalized();
}

Material materialOf(const World& world, std::size_t triangle) {
  return world.surfaces[world.fixed.surfaces[triangle]].material;
}

/// Z of the highest triangle above (x, y), or -infinity: brute force over the whole house.
double roofAbove(const World& world, const Eigen::Vector2d& place) {
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
    const Eigen::Vector3d a = corner(world, i, 0);
    Eigen::Matrix2d edges;
    edges << (corner(world, i, 1) - a).head<2>(), (corner(world, i, 2) - a).head<2>();
    if (std::abs(edges.determinant()) < 1e-3) continue;  // a wall
    const Eigen::Vector2d share = edges.inverse() * (place - a.head<2>());
    if (share.minCoeff() < -1e-4 || share.sum() > 1 + 1e-4) continue;
    highest = std::max(highest, a.z() + share[0] * (corner(world, i, 1) - a).z() +
                                    share[1] * (corner(world, i, 2) - a).z());
  }
  return highest;
}

constexpr std::array<RoofShape, 3> kRoofs = {RoofShape::AlongStreet, RoofShape::ToStreet,
                                             RoofShape::Flat};

}  // namespace

TEST_CASE("four walls stand on the edges of the plot and face outwards") {
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    const House house = houseOf(kRoofs[seed % 3], 2, seed);
    const World world = built(house);
    std::vector<double> widths;
    for (const Surface& surface : world.surfaces) {
      if (surface.material != Material::Facade) continue;
      widths.push_back(static_cast<double>(surface.width));
      CHECK(norm(surface.axis_u) == Approx(1).margin(1e-5));
      CHECK(surface.axis_u.z == 0);
      CHECK(surface.seed == house.seed);
    }
    std::sort(widths.begin(), widths.end());
    REQUIRE(widths.size() == 4);
    const auto [shorter, longer] = std::minmax(house.plot.half_length, house.plot.half_depth);
    CHECK(widths[0] == Approx(2 * shorter).epsilon(1e-4));
    CHECK(widths[1] == Approx(2 * shorter).epsilon(1e-4));
    CHECK(widths[3] == Approx(2 * longer).epsilon(1e-4));
    for (std::size_t i = 0; i < world.fixed.triangles.size(); ++i) {
      if (materialOf(world, i) != Material::Facade) continue;
      const Eigen::Vector2d out = corner(world, i, 0).head<2>() - house.plot.centre;
      REQUIRE(normal(world, i).head<2>().dot(out) > 1);
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector2d d = corner(world, i, k).head<2>() - house.plot.centre;
        REQUIRE(std::abs(d.dot(house.plot.axis)) < house.plot.half_length + 1e-3);
        REQUIRE(std::abs(d.dot(house.plot.across())) < house.plot.half_depth + 1e-3);
      }
    }
  }
}

TEST_CASE("no place of the plot is open to the sky, under any roof") {
  for (std::uint32_t seed = 1; seed <= 24; ++seed) {
    const House house = houseOf(kRoofs[seed % 3], 2, seed);
    const World world = built(house);
    const double eaves = kGround + 2 * 2.9;
    for (double u = -0.97; u < 1; u += 0.194) {
      for (double v = -0.97; v < 1; v += 0.194) {
        const Eigen::Vector2d place =
            house.plot.point(u * house.plot.half_length, v * house.plot.half_depth);
        CAPTURE(seed, u, v);
        REQUIRE(roofAbove(world, place) > eaves);
      }
    }
  }
}

namespace {

World worldOf(std::string_view name) {
  const CameraRoute route = builtInRoute(name, {}).value();
  return buildWorld(StreetPlan::grow(route, 1.65).value(), {});
}

}  // namespace

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

namespace {

constexpr double kParkCamera = 1.65;

struct CarParkTown {
  CameraRoute route = town::test::builtIn("car_park", 3);
  StreetPlan plan = StreetPlan::grow(route, kParkCamera).value();
  World world = build();

  World build() const {
    World made = buildWorld(plan, {1, 0.15, 1, false, {carParkPlot()}});
    addCarPark(made, -kParkCamera, 7);
    return made;
  }
  bool holds(const Vec3& p) const {
    return p.x > -9.01F && p.x < 41.01F && p.y > 56 && p.y < 108.01F;
  }
};

}  // namespace

TEST_CASE("a ramp rises by a storey without a kink") {
  CHECK(CarPark::rampHeight(0) == 0);
  CHECK(CarPark::rampHeight(CarPark::kRampLength) == Approx(CarPark::kStorey));
  double steepest = 0;
  for (double t = 0.05; t < CarPark::kRampLength; t += 0.1) {
    const double slope = (CarPark::rampHeight(t + 1e-4) - CarPark::rampHeight(t - 1e-4)) / 2e-4;
    CHECK(CarPark::rampSlope(t) == Approx(slope).margin(1e-6));
    CHECK(CarPark::rampHeight(t) + CarPark::rampHeight(CarPark::kRampLength - t) ==
          Approx(CarPark::kStorey));
    steepest = std::max(steepest, slope);
  }
  CHECK(steepest < 0.15);
}

TEST_CASE("the drive climbs to the fifth floor and comes down, twice") {
  const CameraRoute route = town::test::builtIn("car_park");
  int tops = 0;
  bool was_top = false;
  double length = 0;
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    const double z = route.T_town_camera[i].translation().z();
    CHECK(z > -1e-9);
    CHECK(z < 12 + 1e-9);
    const bool is_top = z > 12 - 1e-6;
    tops += is_top && !was_top;
    was_top = is_top;
    if (i == 0) continue;
    const Eigen::Vector3d step =
        route.T_town_camera[i].translation() - route.T_town_camera[i - 1].translation();
    CHECK(step.norm() < 0.55);
    length += step.norm();
    // The camera looks where it goes, up and down, too.
    if (step.norm() > 0.1) {
      CHECK(step.normalized().dot(route.T_town_camera[i].linear().col(2)) > 0.98);
    }
  }
  CHECK(tops == 2);
  CHECK(length == Approx(2300).margin(250));
  CHECK(std::abs(route.T_town_camera.back().translation().z()) < 1e-9);
  CHECK_FALSE(route.isRaised(0));
  CHECK_FALSE(route.isRaised(route.T_town_camera.size() - 1));
}

TEST_CASE("floors and ramps lie below the cameras at their height, and nothing stands in the way") {
  const CarParkTown building;
  const Scene scene(building.world);
  for (std::size_t i = 0; i < building.route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d& T = building.route.T_town_camera[i];
    const Eigen::Vector3d camera = T.translation();
    CAPTURE(i, camera.transpose());
    REQUIRE(town::test::distanceTo(scene, camera, -Eigen::Vector3d::UnitZ()) ==
            Approx(kParkCamera).margin(0.03));
    for (const double side : {-1.0, 1.0}) {  // a car is 1.8 m wide
      const Eigen::Vector3d over = side * T.linear().col(0);
      REQUIRE(town::test::distanceTo(scene, camera - Eigen::Vector3d(0, 0, 1), over) > 0.95);
    }
    REQUIRE(town::test::distanceTo(scene, camera, T.linear().col(2)) > 2);
  }
}

TEST_CASE("all floors are alike: the same cars at the same places") {
  const CarParkTown building;
  std::vector<std::vector<std::array<float, 4>>> floors(CarPark::kFloors);
  for (const MeshInstance& car : building.world.instances) {
    const Vec3& p = car.placement.position;
    if (!building.holds(p)) continue;
    const double level = (static_cast<double>(p.z) + kParkCamera) / CarPark::kStorey;
    REQUIRE(level == Approx(std::round(level)).margin(1e-5));
    floors.at(static_cast<std::size_t>(std::lround(level)))
        .push_back({p.x, p.y, car.placement.cosine, static_cast<float>(car.prototype)});
  }
  CHECK(floors[0].size() > 15);
  for (const auto& floor : floors) CHECK(floor == floors[0]);
}

TEST_CASE("the ground is below the lowest floor, and no house stands in the building") {
  const CarParkTown building;
  for (double x = CarPark::kWest; x <= CarPark::kEast; x += 1.7) {
    for (double y = 56; y <= 108; y += 1.3) {
      REQUIRE(building.plan.height(x, y) + StreetPlan::kKerbHeight < -kParkCamera - 0.1);
    }
  }
  const World street = buildWorld(building.plan, {1, 0.15, 1, false, {carParkPlot()}});
  for (const MeshInstance& instance : street.instances) {
    CHECK_FALSE(building.holds(instance.placement.position));
  }
}

namespace {

constexpr double kHallCamera = 1.5;

CameraRoute walk() {
  RouteOptions options;
  options.rate = 10;
  options.camera_height = kHallCamera;
  return builtInRoute("hall", options).value();
}

Scene sceneAround(const CameraRoute& route) {
  const StreetPlan plan = StreetPlan::grow(streetBesideHall(route), kHallCamera).value();
  World world = buildWorld(plan, {1, 0.15, 1, false, {hallPlot()}});
  addHall(world, -kHallCamera, 7);
  return Scene(std::move(world));
}

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

}  // namespace

TEST_CASE("a hand carries the camera twice round, at a walking pace, and looks around") {
  const CameraRoute route = walk();
  CHECK(route.building == Building::Hall);
  CHECK(route.T_town_camera[0].translation().norm() < 1e-9);
  CHECK((route.T_town_camera[0].linear().col(2) - Eigen::Vector3d::UnitY()).norm() < 1e-9);
  double length = 0;
  double lowest = 0;
  double highest = 0;
  double steepest = 0;
  for (std::size_t i = 1; i < route.T_town_camera.size(); ++i) {
    const Eigen::Isometry3d step = route.T_town_camera[i - 1].inverse() * route.T_town_camera[i];
    REQUIRE(step.translation().norm() < 0.2);  // twice the pace
    REQUIRE(degrees(Eigen::AngleAxisd(step.linear()).angle()) < 8);
    length += step.translation().norm();
    const Eigen::Isometry3d& T = route.T_town_camera[i];
    lowest = std::min(lowest, T.translation().z());
    highest = std::max(highest, T.translation().z());
    steepest = std::max(steepest, degrees(std::asin(std::abs(T.linear()(2, 2)))));
  }
  CHECK(length == Approx(52).margin(6));
  CHECK(highest - lowest > 0.4);
  CHECK(steepest > 10);
}

TEST_CASE("the hall is closed, and nothing stands in the way of the camera") {
  const CameraRoute route = walk();
  const Scene scene = sceneAround(route);
  for (std::size_t i = 0; i < route.T_town_camera.size(); i += 3) {
    const Eigen::Vector3d camera = route.T_town_camera[i].translation();
    CAPTURE(i, camera.transpose());
    for (int k = 0; k < 16; ++k) {
      const double angle = 2 * std::numbers::pi * k / 16;
      const Eigen::Vector3d level(std::cos(angle), std::sin(angle), 0);
      const double wall = town::test::distanceTo(scene, camera, level);
      REQUIRE(wall > 0.4);
      REQUIRE(wall < 18);
      REQUIRE(town::test::distanceTo(scene, camera,
                                     (level + Eigen::Vector3d(0, 0, 1)).normalized()) < 18);
    }
    REQUIRE(town::test::distanceTo(scene, camera, -Eigen::Vector3d::UnitZ()) ==
            Approx(kHallCamera + camera.z()).margin(1e-3));
    REQUIRE(town::test::distanceTo(scene, camera, Eigen::Vector3d::UnitZ()) ==
            Approx(Hall::kCeiling - camera.z()).margin(1e-3));
  }
}
