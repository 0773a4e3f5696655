// SPDX-License-Identifier: BSD-3-Clause
// Vertical errors of a rectification: what is estimated from pairs that are displaced by a known
// field, and what is not.
#include "row_alignment.hpp"

#include <catch2/catch.hpp>
#include <cmath>

#include "textured_pair.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;
using tolman::test::Texture;

namespace {

constexpr int kPairWidth = 400;
constexpr int kPairHeight = 160;
constexpr int kDisparity = 12;

/// Errors as rows of KITTI's images have them: up to 1.5 px in the corners.
SmoothField distortedRows() {
  SmoothField field;
  field.coefficients << -0.15, 0.08, 0.06, 0, -0.2, 1.4, 0, -0.1, -0.13, 0.08;
  return field;
}

std::vector<RowCorner> cornerGrid(int step) {
  std::vector<RowCorner> corners;
  for (int v = 8; v < kPairHeight - 8; v += step) {
    for (int u = kDisparity + 8; u < kPairWidth - 8; u += step)
      corners.push_back({u, v, kDisparity});
  }
  return corners;
}

/// A drive past new texture: each keyframe is corrected and observed as the mapper does it. Every
/// `outlier`-th corner has a disparity of another place.
void driveRows(RowAlignment& rows, const SmoothField& truth, int keyframes,
               std::size_t outlier = 0) {
  for (int k = 0; k < keyframes; ++k) {
    const Texture texture(static_cast<std::uint64_t>(100 + k));
    const GrayLevel left = texture.image(kPairWidth, kPairHeight);
    GrayLevel right = test::levelOf(kPairWidth, kPairHeight, [&](int u, int v) {
      const double below = truth.at(u, v, kPairWidth, kPairHeight);
      return std::lround(std::clamp(texture.at(u + kDisparity, v - below), 0.0, 255.0));
    });
    rows.correct(right);
    std::vector<RowCorner> corners = cornerGrid(20);
    for (std::size_t i = 0; outlier > 0 && i < corners.size(); i += outlier) {
      corners[i].disparity += 9;
    }
    rows.observe(left, right, corners, 1);
  }
}

/// Where there are corners.
double largestError(const RowAlignment& rows, const SmoothField& truth) {
  double largest = 0;
  for (int v = 8; v < kPairHeight - 8; v += 8) {
    for (int u = 8; u < kPairWidth - 20; u += 8) {
      largest = std::max(largest, std::abs(rows.field().at(u, v, kPairWidth, kPairHeight) -
                                           truth.at(u, v, kPairWidth, kPairHeight)));
    }
  }
  return largest;
}

}  // namespace

TEST_CASE("the vertical error of a rectification is estimated, and its deviation is honest") {
  RowAlignment rows;
  rows.configure(kPairWidth, kPairHeight, 1);
  const double before = rows.sigmaAt(0, 0);
  driveRows(rows, distortedRows(), 12);
  CHECK(largestError(rows, distortedRows()) < 0.1);
  CHECK(rows.sigmaAt(0, 0) < 0.2 * before);
  CHECK(largestError(rows, distortedRows()) < 4 * rows.sigmaAt(0, 0));
  GrayLevel right = Texture(3).displaced(kPairWidth, kPairHeight, [](double u, double v) {
    return distortedRows().at(u, v, kPairWidth, kPairHeight);
  });
  const GrayLevel left = Texture(3).image(kPairWidth, kPairHeight);
  rows.correct(right);
  int farthest = 0;
  for (int v = 6; v < kPairHeight - 6; ++v) {
    for (int u = 0; u < kPairWidth; ++u) {
      farthest = std::max(farthest, std::abs(right.row(v)[u] - left.row(v)[u]));
    }
  }
  CHECK(farthest < 20);  // the images differ by up to 150 grey levels without correction
}

TEST_CASE("wrong matches do not move the estimate") {
  RowAlignment rows;
  rows.configure(kPairWidth, kPairHeight, 1);
  driveRows(rows, distortedRows(), 12, 4);
  CHECK(largestError(rows, distortedRows()) < 0.12);
}

TEST_CASE("images of an exactly rectified pair are not touched") {
  RowAlignment rows;
  rows.configure(kPairWidth, kPairHeight, 1);
  driveRows(rows, SmoothField(), 12);
  CHECK(rows.field().rms() < 0.02);
  const GrayLevel before = Texture(3).image(kPairWidth, kPairHeight);
  GrayLevel image = before;
  rows.correct(image);
  CHECK(image.pixels == before.pixels);
}

TEST_CASE("what is not seen stays at zero and unsure") {
  RowAlignment rows;
  rows.configure(kPairWidth, kPairHeight, 1);
  const double before = rows.sigmaAt(kPairWidth - 1, 0);
  const Texture texture(20);
  rows.observe(texture.image(kPairWidth, kPairHeight), texture.image(kPairWidth, kPairHeight), {},
               1);
  CHECK(rows.field().coefficients.isZero(0));
  CHECK(rows.sigmaAt(kPairWidth - 1, 0) == Approx(before));
}

TEST_CASE("reset forgets the estimate, and a sigma of zero estimates nothing") {
  RowAlignment rows;
  rows.configure(kPairWidth, kPairHeight, 1);
  driveRows(rows, distortedRows(), 3);
  CHECK(rows.field().rms() > 0.3);
  rows.reset();
  CHECK(rows.field().coefficients.isZero(0));
  RowAlignment off;
  off.configure(kPairWidth, kPairHeight, 0);
  driveRows(off, distortedRows(), 2);
  CHECK(off.field().coefficients.isZero(0));
  CHECK(off.sigmaAt(0, 0) == 0);
}
