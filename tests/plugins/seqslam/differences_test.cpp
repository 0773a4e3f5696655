// SPDX-License-Identifier: BSD-3-Clause
// Local contrast enhancement, against numbers by hand and its bounds.
#include <catch2/catch.hpp>
#include <cmath>

#include "line_search.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::seqslam;

TEST_CASE("each difference is measured against those around it") {
  const std::vector<float> differences = {1, 2, 3, 10, 3};
  const std::vector<float> enhanced = enhancedContrast(differences, 2);
  REQUIRE(enhanced.size() == 5);
  CHECK(enhanced[0] == Approx(-1));                                     // of 1, 2
  CHECK(enhanced[1] == Approx(0).margin(1e-6));                         // of 1, 2, 3
  CHECK(enhanced[2] == Approx((3 - 5) / std::sqrt(38.0 / 3)));          // of 2, 3, 10
  CHECK(enhanced[3] == Approx((10 - 16.0 / 3) / std::sqrt(98.0 / 9)));  // of 3, 10, 3
  CHECK(enhanced[4] == Approx(-1));                                     // of 10, 3
}

TEST_CASE("values that are all alike, and single ones, are 0") {
  CHECK(enhancedContrast({}, 10).empty());
  CHECK(enhancedContrast(std::vector<float>{0.7F}, 10) == std::vector<float>{0});
  CHECK(enhancedContrast(std::vector<float>(30, 0.3F), 10) == std::vector<float>(30, 0));
}

TEST_CASE("nothing is below minus the root of the window, and one that stands out reaches it") {
  RandomStream random(1);
  for (const int window : {2, 3, 10, 40}) {
    std::vector<float> differences;
    for (int i = 0; i < 200; ++i) differences.push_back(static_cast<float>(random.uniform()));
    differences[100] = -1000;
    const std::vector<float> enhanced = enhancedContrast(differences, window);
    const double bound = -std::sqrt(2.0 * (window / 2));
    for (const float value : enhanced) CHECK(value >= bound - 1e-5);
    CHECK(enhanced[100] == Approx(bound).epsilon(1e-3));
  }
}
