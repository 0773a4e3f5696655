// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of the field of disparity errors, and of the part of an offset that is compensated.
#include "disparity_field.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::direct_sparse;

namespace {

constexpr int kRigWidth = 1242;
constexpr int kRigHeight = 375;
constexpr double kFocal = 720;
constexpr double kFocalBaseline = 388;

DisparityField fieldAt(double distance) {
  DisparityField field;
  field.configure(kRigWidth, kRigHeight, kFocal, kFocalBaseline, distance);
  return field;
}

}  // namespace

TEST_CASE(
    "an offset that calibration left vanishes at its distance, apart from the share of turns") {
  DisparityField field = fieldAt(4);
  field.startFrom(0.1);
  const double share = field.calibrationShare(0.1);
  CHECK(field.at(300, 100, 0) == Approx(0.1));
  CHECK(field.at(300, 100, kFocalBaseline / 4) == Approx(0.1 * (1 - share)));
  CHECK(field.at(300, 100, kFocalBaseline / 8) == Approx(0.1 * (1 - share / 2)));
}

TEST_CASE("without a distance of calibration an offset is the same everywhere") {
  DisparityField field = fieldAt(0);
  field.startFrom(0.1);
  for (const double disparity : {0.0, 5.0, 100.0}) {
    CHECK(field.at(10, 10, disparity) == Approx(0.1));
  }
}

TEST_CASE("the share is the expectation over both causes") {
  const DisparityField field = fieldAt(4);
  for (const double offset : {0.0, 0.1, 0.3, 0.7, 1.5}) {
    // Of all (left, turned) with left + turned = offset: half of them without a turn.
    double weight = std::exp(-0.5 * offset * offset / 0.09) / 0.3;
    double sum = weight * offset;
    constexpr double kStep = 1e-3;
    for (double left = -3; left <= 3; left += kStep) {
      const double turned = offset - left;
      const double density = std::exp(-0.5 * (left * left / 0.09 + turned * turned)) / 0.3 /
                             std::sqrt(2 * 3.14159265358979) * kStep;
      weight += density;
      sum += density * left;
    }
    CHECK(field.calibrationShare(offset) * offset == Approx(sum / weight).margin(1e-4));
    CHECK(field.calibrationShare(-offset) == Approx(field.calibrationShare(offset)));
  }
  CHECK(field.calibrationShare(0.1) > 0.75);
  CHECK(field.calibrationShare(1) < 0.12);
}

TEST_CASE("the share depends on the angle, not on the size of images") {
  DisparityField half;
  half.configure(kRigWidth / 2, kRigHeight / 2, kFocal / 2, kFocalBaseline / 2, 4);
  CHECK(half.calibrationShare(0.2) == Approx(fieldAt(4).calibrationShare(0.4)));
}

TEST_CASE("the field is the sum of its terms; a new window forgets it") {
  DisparityField field = fieldAt(0);
  DisparityField::Terms step = DisparityField::Terms::Zero();
  step[0] = 0.2;
  step[4] = -0.5;  // linear in x
  field.move(step);
  field.move(step);
  CHECK(field.offset() == Approx(0.4));
  CHECK(field.at(kRigWidth - 0.5, 100, 7) == Approx(0.4 - 1));
  CHECK(field.at(-0.5, 100, 7) == Approx(0.4 + 1));
  field.clear();
  CHECK(field.at(-0.5, 100, 7) == 0);
}

TEST_CASE("a field that grows with disparity lies in the direction of a factor") {
  // Road: disparity is linear in y, the second term. A field 3 y is then the factor itself.
  ScaleMoments<double> moments;
  for (int v = 200; v < kRigHeight; v += 5) {
    for (int u = 0; u < kRigWidth; u += 20) {
      const auto B = SmoothField::termsAt(u, v, kRigWidth, kRigHeight);
      moments.add(2, 0.3 * (v - 190), B);
    }
  }
  const auto h = moments.factorDirection();
  CHECK(h.norm() == Approx(1));
  CHECK(h[0] == 0);
  CHECK(h[1] > 0.3);
  CHECK(ScaleMoments<double>().factorDirection().isZero());
}
