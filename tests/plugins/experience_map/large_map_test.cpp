// SPDX-License-Identifier: BSD-3-Clause
// The last correction of a map with 100,000 experiences and about 8,700 loops. The hidden case
// measures its CPU time, in the plane and in space; the other checks a smaller one of the same
// kind against the truth.
#include <cmath>
#include <ctime>
#include <iostream>
#include <tolman/context.hpp>

#include "map_fixture.hpp"

namespace tolman::experience_map {
namespace {

/// A way with places that are visited again.
struct Route {
  std::vector<Eigen::Isometry3d> truth;  ///< every 5 m
  /// Of each pose: the earlier one at the same place; itself where the place is new.
  std::vector<std::size_t> earlier;
};

/// Hills of 10 m, so that the way is not planar.
Eigen::Isometry3d onHills(double x, double y, double heading) {
  Eigen::Isometry3d T = fromPlanar({x, y, heading});
  T.translation().y() = -5 * std::sin(x / 300) - 5 * std::cos(y / 400);
  return T;
}

/// The same circuit of `places` poses again and again; every 12th pose closes a loop to the first
/// lap.
Route laps(int places, int count) {
  Route route;
  const double radius = 5.0 * places / (2 * std::numbers::pi);
  for (int k = 0; k < places * count; ++k) {
    const double angle = 2 * std::numbers::pi * k / places;
    const auto place = static_cast<std::size_t>(k % places);
    const bool visits = k >= places && k % 12 == 0;
    route.truth.push_back(
        onHills(radius * std::sin(angle), radius - radius * std::cos(angle), angle));
    route.earlier.push_back(visits ? place : static_cast<std::size_t>(k));
  }
  return route;
}

/// Drives one behind the other that share no place, each a circuit with a second lap over its
/// first 79 places, as copies of KITTI 00 are.
Route copies(int count) {
  constexpr int kPlaces = 839;
  constexpr int kVisits = 79;
  Route route;
  for (int copy = 0; copy < count; ++copy) {
    const std::size_t first = route.truth.size();
    for (int k = 0; k < kPlaces + kVisits; ++k) {
      const double angle = 2 * std::numbers::pi * k / kPlaces;
      const double radius = 5.0 * kPlaces / (2 * std::numbers::pi);
      const double x = 10.0 * copy + radius * std::sin(angle);
      route.truth.push_back(onHills(x, radius - radius * std::cos(angle), angle));
      const auto place = static_cast<std::size_t>(k % kPlaces);
      route.earlier.push_back(first + place);
    }
  }
  return route;
}

/// All rows of a grid of streets, to and fro, then all columns: a loop at each crossing.
Route streets(int lines) {
  constexpr int kBlock = 6;  // poses from crossing to crossing
  const int length = kBlock * (lines - 1) + 1;
  Route route;
  std::vector<std::size_t> crossing(static_cast<std::size_t>(lines) * lines);
  for (const bool column : {false, true}) {
    for (int line = 0; line < lines; ++line) {
      const int at = column ? lines - 1 - line : line;
      for (int k = 0; k < length; ++k) {
        // The columns begin where the rows end: lines is odd, so at the far end of the last row.
        const bool back = line % 2 == 1;
        const int along = column != back ? length - 1 - k : k;
        const double across = 5.0 * kBlock * at;
        const double heading =
            (column ? std::numbers::pi / 2 : 0) + (column != back ? std::numbers::pi : 0);
        route.truth.push_back(column ? onHills(across, 5.0 * along, heading)
                                     : onHills(5.0 * along, across, heading));
        route.earlier.push_back(route.truth.size() - 1);
        if (along % kBlock != 0) continue;
        std::size_t& first = crossing[static_cast<std::size_t>(
            column ? along / kBlock * lines + at : at * lines + along / kBlock)];
        if (column) route.earlier.back() = first;
        first = route.truth.size() - 1;
      }
    }
  }
  return route;
}

struct Finished {
  std::size_t experiences = 0;
  std::size_t loops = 0;
  std::size_t rejected = 0;
  double cpu_s = 0;  ///< of finish()
  double rmse = 0;   ///< m, in space
  double odometry = 0;
};

Eigen::Isometry3d noise(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? metres : radians) * random.normal();
  return expSe3(twist);
}

/// Odometry sinks by 0.05 % of the way. Every `false_every`th loop has a wrong place; 0: none.
Finished drive(const Route& route, const char* geometry, int false_every) {
  Fixture fixture({{"space", std::string(geometry)}, {"interval", std::int64_t{5000}}});
  fixture.covariance = isotropic(0.01, 0.00005);
  RandomStream random(3);
  std::vector<std::int64_t> experience(route.truth.size());
  std::vector<Eigen::Isometry3d> odometry = {Eigen::Isometry3d::Identity()};
  fixture.create(Eigen::Isometry3d::Identity());
  Finished result;
  for (std::size_t k = 1; k < route.truth.size(); ++k) {
    Eigen::Isometry3d step = route.truth[k - 1].inverse() * route.truth[k];
    step = step * noise(random, 0.01, 0.00005);
    step.translation().y() += 0.0005 * step.translation().norm();
    odometry.push_back(odometry.back() * step);
    std::size_t there = route.earlier[k];
    if (there == k) {
      experience[k] = fixture.created;
      fixture.create(step);
      continue;
    }
    ++result.loops;
    const Eigen::Isometry3d offset = route.truth[there].inverse() * route.truth[k];
    const bool lies = false_every > 0 && result.loops % static_cast<std::size_t>(false_every) == 0;
    if (lies) there = there / 2;
    while (there > 0 && route.earlier[there] != there) --there;
    fixture.closeMeasured(step, experience[there], offset * noise(random, 0.1, 0.01), 0.1);
  }
  const std::clock_t begin = std::clock();
  REQUIRE(fixture.map.finish({}).isOk());
  result.cpu_s = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  result.experiences = fixture.graph().experiences.size();
  result.rejected = fixture.graph().rejected.size();
  const Eigen::Isometry3d& start = route.truth.front();
  for (std::size_t k = 0; k < route.truth.size(); ++k) {
    const Eigen::Isometry3d T = start.inverse() * route.truth[k];
    const double share = 1.0 / static_cast<double>(route.truth.size());
    result.rmse += share * std::pow(distance(fixture.poseOf(static_cast<std::int64_t>(k)), T), 2);
    result.odometry += share * std::pow(distance(odometry[k], T), 2);
  }
  result.rmse = std::sqrt(result.rmse);
  result.odometry = std::sqrt(result.odometry);
  return result;
}

}  // namespace

TEST_CASE("laps and a grid of streets are mapped in space, with and without false loops") {
  for (const Route& route : {laps(220, 8), streets(11)}) {
    for (const int false_every : {0, 7}) {
      const Finished map = drive(route, "space", false_every);
      CAPTURE(map.loops, map.rejected, map.rmse, map.odometry);
      CHECK(map.loops > 100);
      CHECK(map.rejected == (false_every > 0 ? map.loops / 7 : 0));
      CHECK(map.rmse < 0.3);
    }
  }
}

TEST_CASE("drives that share no place are each mapped, and keep odometry's error between them") {
  for (const int false_every : {0, 7}) {
    const Finished map = drive(copies(3), "space", false_every);
    CAPTURE(map.loops, map.rejected, map.rmse, map.odometry);
    CHECK(map.loops == 237);
    CHECK(map.rejected == (false_every > 0 ? map.loops / 7 : 0));
    CHECK(map.rmse < 0.5 * map.odometry);
  }
}

namespace {

void measureLastCorrection(const char* name, const Route& route) {
  for (const int false_every : {0, 7}) {
    for (const char* geometry : {"plane", "space"}) {
      const Finished map = drive(route, geometry, false_every);
      std::cout << name << ", " << (false_every > 0 ? "one loop in seven false" : "all loops right")
                << ", " << geometry << ": " << map.experiences << " experiences, " << map.loops
                << " loops, " << map.rejected << " rejected, finish() " << map.cpu_s
                << " s CPU, RMSE " << map.rmse << " m (odometry " << map.odometry << ")"
                << std::endl;
    }
  }
}

}  // namespace

TEST_CASE("time of the last correction: copies", "[.][cost]") {
  measureLastCorrection("copies", copies(109));
}

TEST_CASE("time of the last correction: laps", "[.][cost]") {
  measureLastCorrection("laps", laps(1000, 109));
}

TEST_CASE("time of the last correction: streets", "[.][cost]") {
  measureLastCorrection("streets", streets(93));
}

}  // namespace tolman::experience_map
