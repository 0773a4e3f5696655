// SPDX-License-Identifier: BSD-3-Clause
// Views compared with a naive computation that shares no code with them.
#include "view_maker.hpp"

#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

/// Pixel of an image, 0 to 1; colour is the mean of its channels.
double pixel(const Image& image, int x, int y) {
  const int channels = bytesPerPixel(image.format());
  double sum = 0;
  for (int c = 0; c < channels; ++c) sum += image.row(y)[x * channels + c];
  return sum / channels / 255;
}

double naiveBlock(const Image& image, int x0, int y0, int width, int height) {
  double sum = 0;
  for (int y = y0; y < y0 + height; ++y) {
    for (int x = x0; x < x0 + width; ++x) sum += pixel(image, x, y);
  }
  return sum / (width * height);
}

double naivePatch(const std::vector<float>& cells, int columns, int rows, int x, int y,
                  int radius) {
  std::vector<double> window;
  for (int v = y - radius; v <= y + radius; ++v) {
    for (int u = x - radius; u <= x + radius; ++u) {
      const int cu = std::min(std::max(u, 0), columns - 1);
      const int cv = std::min(std::max(v, 0), rows - 1);
      window.push_back(cells[static_cast<std::size_t>(cv * columns + cu)]);
    }
  }
  double mean = 0;
  for (const double value : window) mean += value / static_cast<double>(window.size());
  double variance = 0;
  for (const double value : window) {
    variance += (value - mean) * (value - mean) / static_cast<double>(window.size());
  }
  const double v = cells[static_cast<std::size_t>(y * columns + x)];
  return std::clamp(((v - mean) / std::sqrt(variance) + 3) / 6, 0.0, 1.0);
}

}  // namespace

TEST_CASE("blocks are averaged over integer sizes, the remainder is ignored") {
  RandomStream random(1);
  const Image image = noise(103, 47, random);
  std::vector<float> cells(999, -1.0F);  // rubbish of the frame before must not survive
  averageBlocks(image, 3, 2, 9, 4, 11, 10, cells);
  REQUIRE(cells.size() == 110);
  for (int r = 0; r < 10; ++r) {
    for (int c = 0; c < 11; ++c) {
      CHECK(cells[static_cast<std::size_t>(r * 11 + c)] ==
            Approx(naiveBlock(image, 3 + 9 * c, 2 + 4 * r, 9, 4)).margin(1e-6));
    }
  }
}

TEST_CASE("colour counts as the mean of its channels, and rows may be padded") {
  RandomStream random(2);
  std::vector<std::uint8_t> bytes(20 * 100);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  const Image image(bytes.data(), 30, 20, 100, PixelFormat::Bgr8, nullptr);
  std::vector<float> cells;
  averageBlocks(image, 0, 0, 10, 5, 3, 4, cells);
  CHECK(cells[4] == Approx(naiveBlock(image, 10, 5, 10, 5)).margin(1e-6));
  CHECK(cells[11] == Approx(naiveBlock(image, 20, 15, 10, 5)).margin(1e-6));
}

TEST_CASE("global normalisation sets the mean and clamps") {
  std::vector<float> cells = {0.1F, 0.2F, 0.3F, 0.2F};  // mean 0.2; factor 2
  normaliseMean(0.4, cells);
  CHECK(cells[0] == Approx(0.2));
  CHECK(cells[2] == Approx(0.6));
  std::vector<float> spike = {0, 0, 0, 0.4F};  // mean 0.1, factor 4: 1.6 is clamped
  normaliseMean(0.4, spike);
  CHECK(spike[3] == 1.0F);
  std::vector<float> black = {0, 0};
  normaliseMean(0.4, black);
  CHECK(black[0] == 0.0F);
}

TEST_CASE("patch normalisation agrees with the naive one, borders repeated") {
  RandomStream random(3);
  std::vector<float> source(12 * 7);
  for (float& cell : source) cell = static_cast<float>(random.uniform());
  std::vector<float> cells;
  const int radius = GENERATE(1, 2, 5);
  normalisePatches(12, radius, source, cells);
  for (int y = 0; y < 7; ++y) {
    for (int x = 0; x < 12; ++x) {
      CHECK(cells[static_cast<std::size_t>(y * 12 + x)] ==
            Approx(naivePatch(source, 12, 7, x, y, radius)).margin(1e-5));
    }
  }
}

TEST_CASE("patches without contrast become 0.5") {
  const std::vector<float> flat(20, 0.3F);
  std::vector<float> cells;
  normalisePatches(5, 2, flat, cells);
  CHECK(cells == std::vector<float>(20, 0.5F));
}

TEST_CASE("the default crop is KITTI's, to the pixel") {
  const ViewTemplates::Parameters p;
  const LocalViewSettings settings = {60, 10, p.crop[0], p.crop[1], p.crop[2], p.crop[3]};
  RandomStream random(4);
  const Image image = noise(1241, 376, random);
  LocalView view;
  REQUIRE(ViewMaker(settings).make(image, view).isOk());
  CHECK(view.cell_width_px == 17);  // (1150 - 100) / 60 = 17.5
  CHECK(view.cells[0] == Approx(naiveBlock(image, 100, 50, 17, 25)).margin(1e-6));
  CHECK(view.cells[599] ==
        Approx(naiveBlock(image, 100 + 59 * 17, 50 + 9 * 25, 17, 25)).margin(1e-6));
}

TEST_CASE("a crop with fewer pixels than cells says so") {
  RandomStream random(5);
  LocalView view;
  const Status status = ViewMaker({60, 10, 0, 0.5, 0, 1}).make(noise(80, 40, random), view);
  CHECK(status.code() == StatusCode::InvalidParameter);
  CHECK(status.message() ==
        "the crop of the 80x40 image has 40x40 pixels, too few for a template of 60x10 cells; make "
        "`columns` and `rows` smaller or the crop larger");
}
