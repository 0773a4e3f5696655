// SPDX-License-Identifier: BSD-3-Clause
// Closed forms of the field of disparity errors, and of the part of an offset that is compensated.
#include "disparity_field.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::direct_sparse;

namespace {

constexpr int kRigWidth = 1242;
constexpr int kRigHeight = 375;
constexpr double kFocal = 720;
constexpr double kFocalBaseline = 388;

constexpr int kDownTerm = 2;    // P_2(y)
constexpr int kAcrossTerm = 7;  // P_2(x)

DisparityField fieldAt(double distance) {
  DisparityField field;
  field.configure(kRigWidth, kRigHeight, kFocal, kFocalBaseline, distance);
  return field;
}

SmoothField errors(double offset, double down, double across) {
  SmoothField field;
  field.coefficients[0] = offset;
  field.coefficients[kDownTerm] = down;
  field.coefficients[kAcrossTerm] = across;
  return field;
}

/// Column displacement (px) of a camera that has turned by `yaw` rad, at a column.
double byYaw(double yaw, double u) {
  const double x = u - (kRigWidth - 1) / 2.0;
  return yaw * (kFocal + x * x / kFocal);
}

/// Mean of byYaw() over the columns, which is the offset.
double meanByYaw(double yaw) {
  double sum = 0;
  for (int u = 0; u < kRigWidth; ++u) sum += byYaw(yaw, u);
  return sum / kRigWidth;
}

}  // namespace

TEST_CASE("while the field is off, an offset displaces columns as a yaw does, at all disparities") {
  const double yaw = 3e-4;
  DisparityField field = fieldAt(4);
  field.startFrom(meanByYaw(yaw));
  CHECK_FALSE(field.isOn());
  for (const double u : {0.0, 300.0, 620.0, 1241.0}) {
    for (const double disparity : {0.0, 5.0, 100.0}) {
      CHECK(field.at(u, 100, disparity) == Approx(byYaw(yaw, u)).margin(1e-4));
    }
  }
}

TEST_CASE("an offset that calibration left vanishes at its distance, as far as it is its share") {
  DisparityField field = fieldAt(4);
  DisparityField::Terms step = DisparityField::Terms::Zero();
  step[kDownTerm] = 0.3;
  step[kAcrossTerm] = 0.6;
  field.setOn(true);
  field.startFrom(0.3);
  field.move(step);
  const SmoothField there = field.atInfinity();
  const double at_infinity = field.at(300, 100, 0);
  CHECK(at_infinity == Approx(there.at(300, 100, kRigWidth, kRigHeight)));
  const double compensated = at_infinity - field.at(300, 100, kFocalBaseline / 4);
  CHECK(compensated > 0.8 * 0.3);
  CHECK(compensated <= 0.3);
  CHECK(at_infinity - field.at(300, 100, kFocalBaseline / 8) == Approx(compensated / 2));
}

TEST_CASE("without a distance of calibration an offset is that of a turn") {
  DisparityField field = fieldAt(0);
  field.setOn(true);
  field.move(DisparityField::Terms::Unit(kAcrossTerm));
  field.startFrom(0.1);
  CHECK(field.at(10, 10, 0) == Approx(field.at(10, 10, 100)));
}

TEST_CASE("the share is the expectation over both causes") {
  const DisparityField field = fieldAt(4);
  // Of a yaw whose mean over the image is 1 px.
  const double unit = meanByYaw(1);
  const double across_by_turn = (byYaw(1, kRigWidth - 0.5) - byYaw(1, (kRigWidth - 1) / 2.0)) /
                                1.5 / unit;  // P_2(1) - P_2(0) = 1.5
  for (const double offset : {0.2, 0.3, 0.5, 0.7, 1.5}) {
    const SmoothField seen = errors(offset, -0.3, 0.6);
    const double rms = std::sqrt(0.3 * 0.3 / 5 + 0.6 * 0.6 / 5);
    const auto rest_density = [&](double rest) {
      return std::exp(-0.5 * rest * rest / (0.25 * rms * rms)) / (0.5 * rms);
    };
    // A half of all cameras has not turned, the others by t ~ N(0, 1 px).
    double weight = rest_density(offset - (-0.3 + 0.6) / 3);
    double sum = weight * offset;
    constexpr double kStep = 1e-3;
    for (double turn = -5; turn <= 5; turn += kStep) {
      const double left = offset - turn;
      const double rest = left - (-0.3 + 0.6 - across_by_turn * turn) / 3;
      const double density = rest_density(rest) * std::exp(-0.5 * turn * turn) /
                             std::sqrt(2 * 3.14159265358979) * kStep;
      weight += density;
      sum += density * left;
    }
    const double expected = std::clamp(sum / weight / offset, 0.0, 1.0);
    CHECK(field.calibrationShare(seen) == Approx(expected).margin(1e-3));
    SmoothField mirrored = seen;
    mirrored.coefficients *= -1;
    CHECK(field.calibrationShare(mirrored) == Approx(field.calibrationShare(seen)));
  }
}

TEST_CASE("an offset without other terms, or with those of its own yaw, is a turn") {
  const DisparityField field = fieldAt(4);
  CHECK(field.calibrationShare(errors(0.3, 0, 0)) == 0);
  CHECK(field.calibrationShare(errors(0.3, 0.02, 0.02)) < 0.05);
  const double yaw = 1.5 / meanByYaw(1);
  const double across = (byYaw(yaw, kRigWidth - 0.5) - byYaw(yaw, (kRigWidth - 1) / 2.0)) / 1.5;
  CHECK(field.calibrationShare(errors(1.5, 0, across)) < 0.05);
  CHECK(field.calibrationShare(errors(0, 0.3, 0.3)) == 0);
}

TEST_CASE("the share depends on angles, not on the size of images") {
  DisparityField half;
  half.configure(kRigWidth / 2, kRigHeight / 2, kFocal / 2, kFocalBaseline / 2, 4);
  CHECK(half.calibrationShare(errors(0.2, 0.1, 0.2)) ==
        Approx(fieldAt(4).calibrationShare(errors(0.4, 0.2, 0.4))));
}

TEST_CASE("the field is the sum of its terms; a new window forgets it, and off is off") {
  DisparityField field = fieldAt(0);
  field.setOn(true);
  DisparityField::Terms step = DisparityField::Terms::Zero();
  step[4] = -0.5;  // linear in x
  field.move(step);
  field.move(step);
  CHECK(field.at(kRigWidth - 0.5, 100, 7) == Approx(-1));
  CHECK(field.at(-0.5, 100, 7) == Approx(1));
  step[0] = 0.2;
  field.move(step);
  CHECK(field.offset() == Approx(0.2));
  field.setOn(false);
  CHECK(field.offset() == Approx(0.2));
  CHECK(field.at(-0.5, 100, 7) == Approx(field.at(kRigWidth - 0.5, 100, 7)));
  field.setOn(true);
  field.clear();
  CHECK(field.at(-0.5, 100, 7) == 0);
  CHECK(field.isOn());
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
