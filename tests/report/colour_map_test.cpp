// SPDX-License-Identifier: BSD-3-Clause
#include "report/colour_map.hpp"

#include <catch2/catch.hpp>
#include <limits>

using namespace tolman::report;

namespace {

/// Rec. 709 weights of the sRGB values: enough for an order.
double brightness(const std::string& colour) {
  const auto part = [&](std::size_t at) { return std::stoi(colour.substr(at, 2), nullptr, 16); };
  return 0.2126 * part(1) + 0.7152 * part(3) + 0.0722 * part(5);
}

}  // namespace

TEST_CASE("the ends are the published ones, and what is outside takes them") {
  CHECK(rateColour(0) == "#440154");
  CHECK(rateColour(1) == "#fde725");
  CHECK(rateColour(-3) == rateColour(0));
  CHECK(rateColour(7) == rateColour(1));
  CHECK(rateColour(std::numeric_limits<double>::quiet_NaN()) == rateColour(0));
}

TEST_CASE("more is brighter, without exception: the map works in grey too") {
  for (int i = 0; i < 100; ++i) {
    CHECK(brightness(rateColour(i / 100.0)) < brightness(rateColour((i + 1) / 100.0)));
  }
}

TEST_CASE("a colour bar runs from dark to bright, between its labels") {
  Svg svg(200, 20);
  colourBar(svg, {100, 10}, "none", "most");
  const std::string text = svg.take();
  const auto place = [&](const std::string& part) { return text.find(part); };
  CHECK(place(rateColour(0)) < place(rateColour(1)));
  CHECK(place("none") != std::string::npos);
  CHECK(place("most") != std::string::npos);
}

TEST_CASE("rates become pixels: right is right, up is up, unknown is transparent") {
  Eigen::MatrixXd rates(2, 3);  // right, up
  rates << 0, NAN, 2, 0, 1, 0;
  const Pixels pixels = ratePixels(rates, 2);
  REQUIRE((pixels.rows() == 3 && pixels.cols() == 2));
  CHECK(pixels(2, 0) == 0xff440154);
  CHECK(pixels(1, 0) == 0);
  CHECK(pixels(0, 0) == 0xfffde725);
  CHECK(pixels(1, 1) == 0xff21908d);
}
