// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>

#include "row_alignment.hpp"
#include "textured_pair.hpp"

using namespace tolman::direct_sparse;
using tolman::test::Texture;

namespace {

constexpr int kShiftWidth = 250;  // no multiple of a block
constexpr int kShiftHeight = 90;

SmoothField constantField(double pixels) {
  SmoothField field;
  field.coefficients[0] = pixels;
  return field;
}

}  // namespace

TEST_CASE("without a field rows stay as they are") {
  const GrayLevel before = Texture(3).image(kShiftWidth, kShiftHeight);
  GrayLevel image = before;
  RowShift().apply(image);
  CHECK(image.pixels == before.pixels);
  RowShift shift;
  shift.set(constantField(0.7), kShiftWidth, kShiftHeight);
  shift.setNone();
  shift.apply(image);
  CHECK(image.pixels == before.pixels);
  CHECK(shift.at(20, 20) == 0);
}

TEST_CASE("whole rows are moved exactly, and the outermost row is repeated") {
  const GrayLevel before = Texture(4).image(kShiftWidth, kShiftHeight);
  for (const int rows : {-3, 0, 2}) {
    GrayLevel image = before;
    RowShift shift;
    shift.set(constantField(rows), kShiftWidth, kShiftHeight);
    shift.apply(image);
    int wrong = 0;
    for (int v = 0; v < kShiftHeight; ++v) {
      const int from = std::clamp(v + rows, 0, kShiftHeight - 1);
      for (int u = 0; u < kShiftWidth; ++u) wrong += image.row(v)[u] != before.row(from)[u] ? 1 : 0;
    }
    CAPTURE(rows);
    CHECK(wrong == 0);
  }
}

TEST_CASE("an image displaced by a field becomes the image without displacement") {
  const Texture texture(5);
  SmoothField field;
  field.coefficients << 0.2, -0.4, 0.1, 0.05, 0.6, 0.9, -0.1, -0.2, 0.1, 0.1;
  GrayLevel image = texture.displaced(kShiftWidth, kShiftHeight, [&](double u, double v) {
    return field.at(u, v, kShiftWidth, kShiftHeight);
  });
  const GrayLevel straight = texture.image(kShiftWidth, kShiftHeight);
  RowShift shift;
  shift.set(field, kShiftWidth, kShiftHeight);
  shift.apply(image);
  double squares = 0;
  int count = 0;
  for (int v = 4; v < kShiftHeight - 4; ++v) {
    for (int u = 0; u < kShiftWidth; ++u) {
      squares += std::pow(image.row(v)[u] - straight.row(v)[u], 2);
      ++count;
    }
  }
  // Displacements vary within blocks and from pixel to pixel; the texture has a deviation of 36.
  CHECK(std::sqrt(squares / count) < 1.5);
  CHECK(std::abs(shift.at(100, 40) - field.at(100, 40, kShiftWidth, kShiftHeight)) < 0.1);
}

TEST_CASE("absurd fields do not read outside of the image") {
  GrayLevel image = Texture(6).image(kShiftWidth, kShiftHeight);
  RowShift shift;
  shift.set(constantField(1e9), kShiftWidth, kShiftHeight);
  shift.apply(image);
  CHECK(shift.at(0, 0) == 8);
  CHECK(shift.at(-1e6, 1e6) == 8);
}
