// SPDX-License-Identifier: BSD-3-Clause
#include "report/axes.hpp"

#include <catch2/catch.hpp>

using namespace tolman::report;

TEST_CASE("ticks are round numbers within the range") {
  CHECK(ticks({0, 10}, 5) == std::vector<double>{0, 2, 4, 6, 8, 10});
  CHECK(ticks({0, 1}, 4) == std::vector<double>{0, 0.5, 1});
  CHECK(ticks({-7, 12}, 4) == std::vector<double>{-5, 0, 5, 10});
  CHECK(ticks({3, 3}, 4) == std::vector<double>{3});
}

TEST_CASE("ticks of any range: some, none outside, equally far apart") {
  for (const double length : {1e-6, 0.37, 1.0, 12.5, 99.0, 1e5}) {
    for (const double low : {-1e3, 0.0, 0.123}) {
      const Range range{low, low + length};
      const auto values = ticks(range, 5);
      REQUIRE(values.size() >= 2);
      CHECK(values.size() <= 13);
      for (const double value : values) {
        CHECK(value >= range.low - 1e-6 * length);
        CHECK(value <= range.high + 1e-6 * length);
      }
    }
  }
}

TEST_CASE("texts of ticks are as short as the step allows") {
  CHECK(tickText(0.25, 0.25) == "0.2");  // a step of 0.25 never comes: 1, 2 and 5 do
  CHECK(tickText(1500, 500) == "1500");
  CHECK(tickText(0.002, 0.001) == "0.002");
  CHECK(tickText(-1e-18, 0.5) == "0.0");  // no "-0"
  CHECK(tickText(3, std::numeric_limits<double>::infinity()) == "0");
  CHECK(tickText(0, 1e-300) == "0.000000000");
}

TEST_CASE("values come to the right pixels") {
  Svg svg(200, 200);
  const Axes axes(svg, {"", "x", "y", {0, 10}, {-1, 1}, frame(50, 20, 150, 120)});
  CHECK(axes.at(0, -1).isApprox(Eigen::Vector2d(50, 120)));
  CHECK(axes.at(10, 1).isApprox(Eigen::Vector2d(150, 20)));
  CHECK(axes.at(5, 0).isApprox(Eigen::Vector2d(100, 70)));
  CHECK(axes.pixelsX(1) == Approx(10));
}

TEST_CASE("equal axes have one scale, and the frame shrinks to it") {
  Svg svg(400, 400);
  AxesPlan plan{"", "x", "y", {0, 10}, {0, 5}, frame(0, 0, 300, 300)};
  plan.equal = true;
  const Axes axes(svg, plan);
  CHECK((axes.at(1, 1) - axes.at(0, 0)).isApprox(axes.pixelsX(1) * Eigen::Vector2d(1, -1)));
  CHECK(axes.box().sizes().isApprox(Eigen::Vector2d(300, 150)));
}

TEST_CASE("lines do not leave the frame, and a range of nothing is no division by zero") {
  Svg svg(200, 200);
  Axes axes(svg, {"", "x", "y", {0, 0}, {0, 1}, frame(50, 20, 150, 120)});
  axes.polyline({0, 1}, {-100, 100}, kBlue);
  const std::string text = svg.take();
  CHECK(text.find("points=\"50.0,120.0 150.0,20.0 \"") != std::string::npos);
  CHECK(text.find("nan") == std::string::npos);
  CHECK(text.find("inf") == std::string::npos);
}
