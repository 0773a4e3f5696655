// SPDX-License-Identifier: BSD-3-Clause
// The grid of edges: what changes it and what hardly does, and its packing.
#include "edge_grid.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "edge_map.hpp"
#include "random_views.hpp"
#include "support/gray_images.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;
using namespace tolman::test;

namespace {

constexpr int kCellPx = 48;  // of the pictures below: four times those of the grid
constexpr int kWide = kColumns * kCellPx;
constexpr int kHigh = kRows * kCellPx;

/// Rectangles of grey levels 60 to 180 and soft waves, endless in x; `kind` selects the scene.
double scene(int kind, int x, int y) {
  const int block_x = x / 20;
  const int block_y = y / 26;
  RandomStream random(static_cast<std::uint64_t>(kind * 1'000'003 + block_x * 1009 + block_y));
  return 70 + 80 * random.uniform() + 15 * (1 + std::sin(0.11 * x + 0.07 * y + kind));
}

Image picture(int kind, int first_x, auto&& change) {
  return gray(kWide, kHigh,
              [&](int x, int y) { return std::lround(change(scene(kind, first_x + x, y))); });
}

Image picture(int kind, int first_x = 0) {
  return picture(kind, first_x, [](double value) { return value; });
}

EdgeValues gridOf(const Image& image) {
  EdgeValues values{};
  REQUIRE(edgeGrid(image, values));
  return values;
}

/// Mean over twelve scenes: what all pictures here have in common.
const EdgeValues& usual() {
  static const EdgeValues mean = [] {
    EdgeValues sum{};
    for (int kind = 1; kind <= 12; ++kind) {
      const EdgeValues grid = gridOf(picture(kind));
      for (std::size_t i = 0; i < kValues; ++i) sum[i] += grid[i] / 12;
    }
    return sum;
  }();
  return mean;
}

/// 1 - cosine between the deviations from what is usual: 0 to 2.
double change(const EdgeValues& a, const EdgeValues& b) {
  double product = 0;
  double of_a = 0;
  double of_b = 0;
  for (std::size_t i = 0; i < kValues; ++i) {
    const double x = a[i] - usual()[i];
    const double y = b[i] - usual()[i];
    product += x * y;
    of_a += x * x;
    of_b += y * y;
  }
  return 1 - product / std::sqrt(of_a * of_b);
}

/// Stripes whose brightness rises in the direction of `degrees` (0: right, 90: down).
Image stripes(double degrees) {
  const double angle = degrees * std::numbers::pi / 180;
  return gray(kWide, kHigh, [&](int x, int y) {
    return 120 + 60 * std::sin(0.1 * (x * std::cos(angle) + y * std::sin(angle)));
  });
}

int strongestDirection(const EdgeValues& grid) {
  std::array<double, kDirections> sums{};
  for (std::size_t i = 0; i < kValues; ++i) sums[i % kDirections] += grid[i];
  return static_cast<int>(std::ranges::max_element(sums) - sums.begin());
}

}  // namespace

/// The definition, in double precision and pixel by pixel, of a picture that needs no reduction.
std::vector<double> byDefinition(const Image& image) {
  const auto light = [&](int x, int y) {
    constexpr double kDark = landmarks::kDarkLevel;
    return (100 + kDark) / 255 * std::log(image.row(y)[x] + kDark);
  };
  std::vector<double> sums(kValues);
  std::vector<double> weights(kValues);
  const auto overlap = [](double a, double b) { return std::max(0.0, 1 - std::abs(a - b)); };
  for (int y = 1; y < image.height() - 1; ++y) {
    for (int x = 1; x < image.width() - 1; ++x) {
      const double across = light(x + 1, y) - light(x - 1, y);
      const double down = light(x, y + 1) - light(x, y - 1);
      const double direction = std::atan2(down, across) / std::numbers::pi * kDirections;
      for (std::size_t i = 0; i < kValues; ++i) {
        const auto at = static_cast<int>(i);
        const double weight = overlap((x + 0.5) / 12 - 0.5, at / (kRows * kDirections)) *
                              overlap((y + 0.5) / 12 - 0.5, at / kDirections % kRows);
        weights[i] += weight;
        const double middle = at % kDirections + 0.5;
        for (const int turn : {-2, -1, 0, 1, 2}) {  // directions repeat after half a turn
          sums[i] +=
              weight * std::hypot(across, down) * overlap(direction + turn * kDirections, middle);
        }
      }
    }
  }
  for (std::size_t i = 0; i < kValues; ++i) sums[i] /= weights[i];
  return sums;
}

TEST_CASE("the grid is that of its definition") {
  RandomStream random(8);
  const Image image = noise(kColumns * 12, kRows * 12, random);
  const EdgeValues grid = gridOf(image);
  const std::vector<double> means = byDefinition(image);
  for (int c = 0; c < kColumns; ++c) {
    for (int r = 0; r < kRows; ++r) {
      double energy = 0;
      int cells = 0;
      for (int i = std::max(0, c - 1); i <= std::min(kColumns - 1, c + 1); ++i) {
        for (int j = std::max(0, r - 1); j <= std::min(kRows - 1, r + 1); ++j, ++cells) {
          for (int k = 0; k < kDirections; ++k) {
            energy +=
                std::pow(means[static_cast<std::size_t>((i * kRows + j) * kDirections + k)], 2);
          }
        }
      }
      for (int k = 0; k < kDirections; ++k) {
        const auto at = static_cast<std::size_t>((c * kRows + r) * kDirections + k);
        const double value = std::sqrt(means[at] / (std::sqrt(energy / cells) + 0.01));
        REQUIRE(grid[at] == Approx(value).epsilon(1e-4));
      }
    }
  }
}

TEST_CASE("brightness, contrast and gamma hardly change the grid, another scene does") {
  const EdgeValues plain = gridOf(picture(1));
  const auto changed = [&](auto&& by) { return change(plain, gridOf(picture(1, 0, by))); };
  CHECK(changed([](double v) { return v + 40; }) < 0.06);
  CHECK(changed([](double v) { return v - 60; }) < 0.12);
  CHECK(changed([](double v) { return 0.7 * v; }) < 0.01);
  CHECK(changed([](double v) { return 0.2 * v; }) < 0.06);
  CHECK(changed([](double v) { return 1.3 * v; }) < 0.01);
  CHECK(changed([](double v) { return 255 * std::pow(v / 255, 0.6); }) < 0.15);
  CHECK(changed([](double v) { return 255 * std::pow(v / 255, 1.6); }) < 0.15);
  CHECK(change(plain, gridOf(picture(2))) > 0.8);
}

TEST_CASE("a negative has the same edges: the sign of a gradient does not count") {
  const auto negative = [](double v) { return 250 - v; };
  CHECK(change(gridOf(picture(1)), gridOf(picture(1, 0, negative))) < 0.08);
}

TEST_CASE("a lamp that lights a part of the scene hardly changes the grid") {
  const Image day = picture(1);
  const Image night = gray(kWide, kHigh, [&](int x, int y) {
    const double lamp = 0.1 + 0.9 * std::exp(-std::pow((x - 0.3 * kWide) / (0.3 * kWide), 2));
    return lamp * day.row(y)[x];
  });
  CHECK(change(gridOf(day), gridOf(night)) < 0.2);
}

TEST_CASE("a picture moved by a cell moves the grid by a column") {
  const EdgeValues here = gridOf(picture(3));
  for (const int cells : {1, 2, 3}) {
    const EdgeValues moved = gridOf(picture(3, cells * kCellPx));
    double largest = 0;
    // The outer columns have other neighbours.
    for (int c = 2; c < kColumns - 2 - cells; ++c) {
      for (int i = 0; i < kColumnValues; ++i) {
        const auto at = static_cast<std::size_t>(c * kColumnValues + i);
        const auto from = static_cast<std::size_t>((c + cells) * kColumnValues + i);
        largest = std::max<double>(largest, std::abs(moved[at] - here[from]));
      }
    }
    CAPTURE(cells);
    CHECK(largest < 1e-4);
    CHECK(change(here, moved) > 0.5);
  }
}

TEST_CASE("each direction of 30 degrees has a value of its own") {
  for (int direction = 0; direction < kDirections; ++direction) {
    CAPTURE(direction);
    CHECK(strongestDirection(gridOf(stripes(30 * direction + 15))) == direction);
    CHECK(strongestDirection(gridOf(stripes(30 * direction + 195))) == direction);
  }
}

TEST_CASE("colour with equal channels is grey") {
  CHECK(change(gridOf(picture(4)), gridOf(coloured(picture(4)))) < 0.01);
}

TEST_CASE("a blank, black or nearly flat picture is refused, and the values stay as they were") {
  RandomStream random(3);
  const auto isRefused = [](const Image& image) {
    EdgeValues values;
    values.fill(7);
    const bool refused = !edgeGrid(image, values);
    return refused && std::ranges::all_of(values, [](float v) { return v == 7; });
  };
  CHECK(isRefused(gray(640, 480, [](int, int) { return 0; })));
  CHECK(isRefused(gray(640, 480, [](int, int) { return 128; })));
  CHECK(isRefused(gray(640, 480, [](int, int) { return 255; })));
  CHECK(isRefused(gray(640, 480, [&](int, int) { return 30 + random.below(2); })));
  CHECK(isRefused(gray(640, 480, [](int x, int) { return 100 + x / 200; })));
  CHECK(isRefused(coloured(gray(64, 32, [](int, int) { return 90; }))));
  CHECK(isRefused(gray(1, 1, [](int, int) { return 90; })));
  CHECK_FALSE(isRefused(gray(640, 480, [&](int, int) { return 128 + random.below(60); })));
}

TEST_CASE("pictures of any size and shape have a grid of finite values") {
  const std::pair<int, int> sizes[] = {{64, 32},   {160, 120}, {156, 96},   {157, 97},
                                       {640, 480}, {960, 540}, {1241, 376}, {300, 900}};
  for (const auto& [width, height] : sizes) {
    CAPTURE(width, height);
    const EdgeValues grid = gridOf(gray(width, height, [&, w = width, h = height](int x, int y) {
      return scene(5, x * kWide / w, y * kHigh / h);
    }));
    CHECK(std::ranges::all_of(grid, [](float v) { return std::isfinite(v) && v >= 0 && v < 3; }));
    if (width >= 156) CHECK(change(gridOf(picture(5)), grid) < 0.4);
  }
}

TEST_CASE("packing keeps values to half a level and clips what is larger") {
  RandomStream random(1);
  EdgeValues values;
  for (float& value : values) value = static_cast<float>(random.uniform(-0.2, 1.9));
  const PackedView view = packed(values);
  std::array<std::int16_t, kValues> levels;
  unpack(view, levels);
  for (std::size_t i = 0; i < kValues; ++i) {
    const double expected = std::clamp(10.0 * values[i], 0.0, 15.0);
    REQUIRE(std::abs(levels[i] - expected) <= 0.5 + 1e-5);
  }
  // Whole levels come back as they are, and each has a place of its own.
  const EdgeValues whole = randomLevels(random);
  CHECK(levelsOf(packedLevels(whole)) == whole);
  for (std::size_t i = 0; i < kValues; i += 7) {
    EdgeValues one{};
    one[i] = 9;
    CHECK(levelsOf(packedLevels(one)) == one);
  }
}
