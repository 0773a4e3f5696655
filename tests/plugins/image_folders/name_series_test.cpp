// SPDX-License-Identifier: BSD-3-Clause
// Images of several cameras in one folder, and folders that only look like it.
#include "name_series.hpp"

#include <catch2/catch.hpp>

namespace tolman::image_folders {
namespace {

using Names = std::vector<std::filesystem::path>;

}  // namespace

TEST_CASE("two images of one number are found where the names are of two cameras") {
  const auto two = twoOfOneNumber({"cam0_1.png", "cam0_2.png", "cam1_1.png", "cam1_2.png"});
  REQUIRE(two);
  CHECK(two->first == "cam0_1.png");
  CHECK(two->second == "cam1_1.png");
  CHECK(twoOfOneNumber({"1_left.png", "1_right.png", "2_left.png", "2_right.png"}));
  CHECK(twoOfOneNumber({"a1.png", "a2.png", "a3.png", "b1.png", "b3.png", "c1.png", "c2.png"}));
}

TEST_CASE("one series, other numbers and names with times are of one camera") {
  for (const Names& names :
       {Names{}, Names{"1.png"}, Names{"1.png", "2.png", "3.png"},
        Names{"drive2_1.png", "drive2_2.png", "drive2_10.png"},
        Names{"a1.png", "a2.png", "b3.png", "b4.png"},  // one goes on
        Names{"1.png", "2.png", "3.png", "preview_1.png"}, Names{"left.png", "right.png"}}) {
    CHECK_FALSE(twoOfOneNumber(names));
  }
  Names times;
  for (int second = 10; second < 40; ++second) {
    for (const char* part : {"000", "500"}) {
      times.emplace_back("2024-01-02_10-00-" + std::to_string(second) + "." + part + ".png");
    }
  }
  CHECK_FALSE(twoOfOneNumber(times));
}

}  // namespace tolman::image_folders
