// SPDX-License-Identifier: BSD-3-Clause
// Points joined along the path: their places after a motion of the camera, removal of old ones, and
// saved states.
#include "street_points.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "part_state.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

Eigen::Isometry3d ahead(double metres, double left_rad = 0) {
  return fromPlanar({metres, 0, left_rad});
}

/// Enough points for a grid, all at one place (m).
std::vector<CentimetrePoint> pile(double x, double z) {
  return std::vector<CentimetrePoint>(
      600, CentimetrePoint(static_cast<std::int16_t>(std::lround(100 * x)), 0,
                           static_cast<std::int16_t>(std::lround(100 * z))));
}

/// The cells with something in them, as (lateral, along), seen from above.
std::vector<std::pair<int, int>> filled(const StructureLevels& levels) {
  std::vector<std::pair<int, int>> cells;
  for (int i = 0; i < kLateral; ++i) {
    for (int j = 0; j < kAlong; ++j) {
      int sum = 0;
      for (int k = 0; k < kHeights; ++k) {
        sum += levels[static_cast<std::size_t>((i * kAlong + j) * kHeights + k)];
      }
      if (sum > 0) cells.emplace_back(i, j);
    }
  }
  return cells;
}

/// Drives straight on from 0 to `metres`; a pile at (x, z) is seen at the first metre alone.
StreetPoints driven(int metres, double x, double z) {
  StreetPoints street;
  street.add(pile(x, z), 0);
  for (int path = 1; path <= metres; ++path) {
    street.move(ahead(1));
    street.add({}, path);
  }
  return street;
}

std::string bytesOf(const StreetPoints& street) {
  return savedBytes([&](StateWriter& writer) { street.save(writer); });
}

bool takes(StreetPoints& street, const std::string& bytes) {
  StateReader reader = readerOf(bytes);
  return street.load(reader) && reader.complete();
}

using Filled = std::vector<std::pair<int, int>>;

}  // namespace

TEST_CASE("a point stays where it is in the world while the camera moves on") {
  // 20 m ahead at first, 3 m ahead after 17 m, 2 m behind after 22.
  CHECK(filled(*driven(17, 3.2, 20.2).levels()) == Filled{{12, 10}});
  CHECK(filled(*driven(22, 3.2, 20.2).levels()) == Filled{{12, 6}});
}

TEST_CASE("a camera that turned left has what was ahead on its right") {
  StreetPoints street;
  street.add(pile(0, 9), 0);
  street.move(ahead(0, std::numbers::pi / 2));
  street.add({}, 16);
  const Filled cells = filled(*street.levels());
  REQUIRE(cells.size() == 1);
  CHECK(cells[0].first == 16);  // 9 m to the right
  CHECK((cells[0].second == 7 || cells[0].second == 8));
}

TEST_CASE("the grid is turned about the camera, to the left for a positive yaw") {
  const StreetPoints street = driven(16, 0.2, 24.5);  // 8.5 m ahead
  CHECK(filled(*street.levels()) == Filled{{10, 13}});
  const Filled left = filled(*street.levels(0.4));
  const Filled right = filled(*street.levels(-0.4));
  REQUIRE((left.size() == 1 && right.size() == 1));
  CHECK(left[0] == std::pair(8, 13));
  CHECK(right[0] == std::pair(12, 13));
}

TEST_CASE("structure is known after 15 m, and forgotten after 30 m more") {
  CHECK_FALSE(StreetPoints().levels());
  CHECK_FALSE(driven(14, 0, 5).levels());
  CHECK(driven(15, 0, 20).levels());
  CHECK(driven(30, 0, 25).levels());
  CHECK_FALSE(driven(31, 0, 25).levels());  // the pile was all there was
  StreetPoints street = driven(20, 0, 20);
  street.restart();
  CHECK_FALSE(street.levels());
  CHECK(street.pose().matrix() == Eigen::Matrix4d::Identity());
}

TEST_CASE("hardly any points are no structure") {
  StreetPoints street;
  std::vector<CentimetrePoint> few = pile(0, 18);
  few.resize(400);
  street.add(few, 0);
  street.move(ahead(16));
  street.add({}, 16);
  CHECK_FALSE(street.levels());
}

TEST_CASE("points are wanted once a metre") {
  StreetPoints street;
  CHECK(street.wantsPoints(0));
  street.add({}, 3);
  CHECK_FALSE(street.wantsPoints(3.5));
  CHECK(street.wantsPoints(4));
}

TEST_CASE("a saved street goes on to the bit") {
  StreetPoints street = driven(17, 3.2, 20.2);
  StreetPoints loaded = driven(3, 1, 1);  // forgotten
  REQUIRE(takes(loaded, bytesOf(street)));
  for (StreetPoints* each : {&street, &loaded}) {
    each->move(ahead(1.3, 0.2));
    each->add(pile(-2, 6), 18.3);
  }
  CHECK(bytesOf(loaded) == bytesOf(street));
  CHECK(*loaded.levels(0.1) == *street.levels(0.1));
}

TEST_CASE("damaged streets are refused without asking for memory") {
  const std::string sound = bytesOf(driven(4, 0, 5));
  const auto isRefused = [](const std::string& bytes) {
    StreetPoints street;
    return !takes(street, bytes);
  };
  REQUIRE_FALSE(isRefused(sound));
  for (std::size_t length = 0; length < sound.size(); length += 13) {
    CAPTURE(length);
    REQUIRE(isRefused(sound.substr(0, length)));
  }
  constexpr std::size_t kPose = 16 * sizeof(double);
  CHECK(isRefused(overwritten(sound, 0, NAN * 1.0)));
  CHECK(isRefused(overwritten(sound, kPose, std::uint64_t{1} << 60U)));           // patches
  CHECK(isRefused(overwritten(sound, kPose + 8, double(INFINITY))));              // its path
  CHECK(isRefused(overwritten(sound, kPose + 8, 2.0)));                           // falls
  CHECK(isRefused(overwritten(sound, kPose + 16, double(NAN))));                  // its pose
  CHECK(isRefused(overwritten(sound, 2 * kPose + 16, std::uint64_t{1} << 60U)));  // its points
}
