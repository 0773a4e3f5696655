// SPDX-License-Identifier: BSD-3-Clause
// Images of existing configurations do not change: mean grey levels of eight tiles of the left
// image, as of November 2026. Another compiler or processor changes single pixels on edges, so the
// tolerance is a third of a grey level; on one machine bytes can be compared with `tolman dataset
// render` before and after a change.
#include <array>
#include <catch2/catch.hpp>

#include "support/context.hpp"
#include "town_source.hpp"

using namespace tolman;
using namespace tolman::town;

namespace {

constexpr int kColumns = 4;
constexpr int kRows = 2;
using Tiles = std::array<double, kColumns * kRows>;

Tiles tilesOf(ParameterValues values, std::int64_t frame) {
  values["scale"] = 0.2;
  values["noise"] = 0.0;
  values["first"] = values["last"] = frame;
  tolman::test::TestContext context(values);
  TownSource source;
  REQUIRE(source.configure(context).isOk());
  Frame picture;
  REQUIRE(source.next(picture).isOk());
  const Image& image = picture.left;
  Tiles tiles{};
  const int width = image.width() / kColumns;
  const int height = image.height() / kRows;
  for (int row = 0; row < kRows * height; ++row) {
    for (int column = 0; column < kColumns * width; ++column) {
      tiles[static_cast<std::size_t>(row / height * kColumns + column / width)] +=
          static_cast<double>(image.row(row)[column]) / (width * height);
    }
  }
  return tiles;
}

void checkTiles(const Tiles& found, const Tiles& known) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    CAPTURE(i);
    CHECK(found[i] == Approx(known[i]).margin(0.33));
  }
}

}  // namespace

TEST_CASE("the district by day is as it was") {
  checkTiles(tilesOf({{"route", std::string("district")}}, 300),
             {187.7, 211.3, 111.8, 148.5, 87.0, 110.7, 110.4, 81.9});
}

TEST_CASE("traffic, dusk, haze and repeated fronts are as they were") {
  checkTiles(tilesOf({{"route", std::string("district")},
                      {"aliasing", 0.5},
                      {"hour", 18.0},
                      {"haze", 0.004},
                      {"traffic", 20.0}},
                     900),
             {71.9, 185.7, 99.3, 106.7, 83.5, 90.4, 93.4, 93.1});
}

TEST_CASE("a wet night with bad cameras is as it was") {
  checkTiles(tilesOf({{"conditions", std::string("all = night rain")},
                      {"warp_rms_px", 2.0},
                      {"exposure_time_ms", 3.0},
                      {"bloom", 0.05}},
                     150),
             {138.3, 35.1, 97.0, 29.9, 80.9, 117.0, 130.6, 50.7});
}

TEST_CASE("snow, bare trees and other parked cars are as they were") {
  checkTiles(tilesOf({{"conditions", std::string("all = snow bare exchanged overcast")}}, 60),
             {83.7, 118.3, 56.1, 79.4, 57.0, 83.3, 97.4, 83.9});
}
