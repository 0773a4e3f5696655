// SPDX-License-Identifier: BSD-3-Clause
// Cells of edge directions for images whose edges are known.
#include <catch2/catch.hpp>
#include <numbers>

#include "harness.hpp"
#include "view_maker.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

constexpr int kColumns = 6;
constexpr int kRows = 4;
constexpr int kWidth = kColumns * kSamplesPerCell;
constexpr int kHeight = kRows * kSamplesPerCell;

std::vector<float> samples(auto&& value) {
  std::vector<float> result;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) result.push_back(static_cast<float>(value(x, y)));
  }
  return result;
}

float cellAt(const std::vector<float>& cells, int direction, int column, int row) {
  return cells[static_cast<std::size_t>((direction * kRows + row) * kColumns + column)];
}

/// Brightness that grows along `angle`, and the direction that is strongest in the middle.
int strongest(double angle, double strength = 0.01) {
  std::vector<float> cells;
  gradientCells(samples([&](int x, int y) {
                  return 0.5 + strength * (x * std::cos(angle) + y * std::sin(angle));
                }),
                kColumns, kRows, cells);
  int best = 0;
  for (int k = 1; k < kDirections; ++k) {
    if (cellAt(cells, k, 2, 2) > cellAt(cells, best, 2, 2)) best = k;
  }
  return best;
}

std::vector<float> cellsOf(const std::vector<float>& grey) {
  std::vector<float> cells;
  gradientCells(grey, kColumns, kRows, cells);
  return cells;
}

double texture(int x, int y) {
  return 0.5 + 0.2 * std::sin(0.7 * x + 0.2 * y) + 0.1 * std::sin(0.3 * x - 0.9 * y);
}

}  // namespace

TEST_CASE("the strongest direction is that of the gradient, whichever side is bright") {
  constexpr double kWide = std::numbers::pi / kDirections;
  for (int k = 0; k < kDirections; ++k) {
    const double middle = (k + 0.5) * kWide;
    CHECK(strongest(middle) == strongest(middle + std::numbers::pi));
    CHECK(strongest(middle + 0.4 * kWide) == strongest(middle));
    CHECK(strongest(middle + kWide) == (strongest(middle) + 1) % kDirections);
  }
}

TEST_CASE("flat and almost flat pictures have hardly any cells") {
  for (const float cell : cellsOf(samples([](int, int) { return 0.3; }))) CHECK(cell == 0);
  const auto faint = cellsOf(samples([](int x, int) { return 0.3 + 1e-5 * x; }));
  CHECK(*std::max_element(faint.begin(), faint.end()) < 0.1F);
}

TEST_CASE("twice the contrast and other light change cells little") {
  const auto plain = cellsOf(samples(texture));
  const auto bright = cellsOf(samples([](int x, int y) { return 0.3 + texture(x, y); }));
  const auto contrasty = cellsOf(samples([](int x, int y) { return 2 * texture(x, y); }));
  for (std::size_t i = 0; i < plain.size(); ++i) {
    CHECK(bright[i] == Approx(plain[i]).margin(1e-3));
    CHECK(contrasty[i] == Approx(plain[i]).margin(0.1));
    CHECK(plain[i] >= 0);
    CHECK(plain[i] <= 1);
  }
}

TEST_CASE("blocks of rounded size fill the crop: against plain means") {
  RandomStream random(3);
  const Image image = noise(47, 31, random);
  const Crop crop{5, 3, 37, 26};
  std::vector<float> averages;
  averageCrop(image, crop, 8, 5, averages);
  REQUIRE(averages.size() == 40);
  double all = 0;
  double counted = 0;
  for (int r = 0; r < 5; ++r) {
    const auto edge = [](int i, int n, int size) { return (i * size + n / 2) / n; };
    for (int c = 0; c < 8; ++c) {
      double sum = 0;
      int count = 0;
      for (int y = edge(r, 5, 26); y < edge(r + 1, 5, 26); ++y) {
        for (int x = edge(c, 8, 37); x < edge(c + 1, 8, 37); ++x, ++count) {
          sum += image.row(3 + y)[5 + x] / 255.0;
        }
      }
      CHECK(averages[static_cast<std::size_t>(r * 8 + c)] == Approx(sum / count));
      all += sum;
      counted += count;
    }
  }
  CHECK(counted == 37 * 26);  // no pixel is left out or counted twice
  CHECK(all > 0);
}

TEST_CASE("gradients: a view is known again in other light, grey takes it for another") {
  const auto scene = [](double gain, double offset) {
    return gray(200, 120, [=](int x, int y) {
      const double value =
          80 + 40 * std::sin(0.11 * x + 0.0007 * x * y) + 30 * std::cos(0.17 * y + 0.002 * x * x);
      return std::lround(std::clamp(gain * value + offset, 0.0, 255.0));
    });
  };
  const auto recognises = [&](const ParameterValues& parameters) {
    ViewTemplates plugin;
    REQUIRE(configure(plugin, parameters).isOk());
    observe(plugin, scene(1, 0));
    return observe(plugin, scene(0.6, 90), 1).recognition == Recognition::Familiar;
  };
  CHECK(recognises({{"cells", std::string("gradients")},
                    {"columns", std::int64_t{16}},
                    {"rows", std::int64_t{8}},
                    {"shift", std::int64_t{2}}}));
  CHECK_FALSE(recognises({{"normalisation", 0.0}}));
}

TEST_CASE("gradients: a turn is measured as with grey cells") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {{"cells", std::string("gradients")},
                             {"columns", std::int64_t{20}},
                             {"rows", std::int64_t{8}},
                             {"shift", std::int64_t{3}},
                             {"threshold", 0.2},
                             {"field_of_view", 80.0}})
              .isOk());
  const double focal = 160 / std::tan(40 * std::numbers::pi / 180);
  observe(plugin, pinholeView(320, 160, focal, 0.5));
  const PlaceObservation seen = observe(plugin, pinholeView(320, 160, focal, 0.58), 1);
  REQUIRE(seen.recognition == Recognition::Familiar);
  CHECK(seen.relative_yaw == Approx(0.08).margin(0.03));
}

TEST_CASE("gradients: too small an image is refused in words") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {{"cells", std::string("gradients")}}).isOk());
  Frame frame;
  frame.left = gray(200, 100, [](int, int) { return 9; });
  PlaceObservation observation;
  CHECK(plugin.observe(frame, nullptr, observation).message() ==
        "the crop of the 200x100 image has 169x67 pixels, too few for a template of 60x10 cells of "
        "8x8 pixels; make `columns` and `rows` smaller or the crop larger");
}
