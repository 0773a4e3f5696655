// SPDX-License-Identifier: BSD-3-Clause
#include "disparity_field.hpp"

#include <cmath>

namespace tolman::direct_sparse {

namespace {

constexpr int kDegree = SmoothField::kDegree;

/// P_0 to P_3 at x.
std::array<double, kDegree + 1> legendre(double x) {
  return {1, x, 0.5 * (3 * x * x - 1), 0.5 * (5 * x * x * x - 3 * x)};
}

/// Calls `use(term, i, j)` for each term P_i(x) P_j(y).
template <class Use>
void forEachTerm(Use use) {
  int term = 0;
  for (int i = 0; i <= kDegree; ++i) {
    for (int j = 0; i + j <= kDegree; ++j) use(term++, i, j);
  }
}

}  // namespace

SmoothField::Terms SmoothField::termsAt(double u, double v, int width, int height) {
  const auto across = legendre((2 * u + 1) / width - 1);
  const auto down = legendre((2 * v + 1) / height - 1);
  Terms terms;
  forEachTerm([&](int term, int i, int j) {
    terms[term] = across[static_cast<std::size_t>(i)] * down[static_cast<std::size_t>(j)];
  });
  return terms;
}

double SmoothField::rms() const { return std::hypot(coefficients[0], rmsWithoutOffset()); }

double SmoothField::rmsWithoutOffset() const {
  // Legendre polynomials are orthogonal; the mean of P_i^2 over [-1, 1] is 1 / (2 i + 1).
  double square = 0;
  forEachTerm([&](int term, int i, int j) {
    if (term == 0) return;
    square += coefficients[term] * coefficients[term] / ((2 * i + 1) * (2 * j + 1));
  });
  return std::sqrt(square);
}

namespace {

constexpr int kDown = 2;    // term P_2(y)
constexpr int kAcross = 7;  // term P_2(x)

// What simulated calibrations leave (docs/report/odometry.md): an offset of about a third of the
// sum of both terms of degree 2, and a rest, relative to the rms of the field without its offset.
// Weights were 0.23 to 0.42, the rest 0.4 to 0.55 with the constraint of the window on the field;
// within this range 0.5 was chosen on KITTI 06.
constexpr double kByTerm = 1.0 / 3;
constexpr double kRest = 0.5;
// Standard deviation of the offset of a turned camera: 1 px at a focal length of 720 px, which is
// the default of offset_sigma.
constexpr double kTurned = 1.0 / 720;

double density(double value, double variance) {
  return std::exp(-0.5 * value * value / variance) / std::sqrt(variance);
}

}  // namespace

void DisparityField::configure(int width, int height, double focal, double focal_baseline,
                               double distance) {
  width_ = width;
  height_ = height;
  focal_ = focal;
  by_disparity_ = distance / focal_baseline;
  const double wide = width / focal * (width / focal);
  across_by_yaw_ = (wide / 6) / (1 + wide / 12);
  on_ = false;
  clear();
}

void DisparityField::clear() {
  first_ = 0;
  change_.setZero();
  updateShares();
}

void DisparityField::setOn(bool on) {
  on_ = on;
  if (!on) change_.tail<SmoothField::kTerms - 1>().setZero();
  updateShares();
}

DisparityField::Terms DisparityField::termsAt(double u, double v, double disparity) const {
  Terms terms = SmoothField::termsAt(u, v, width_, height_);
  terms[0] = 1 + across_ * terms[kAcross] - compensated_ * disparity;
  return terms;
}

void DisparityField::move(const Terms& step) {
  change_ += step;
  updateShares();
}

void DisparityField::startFrom(double offset) {
  first_ = offset;
  updateShares();
}

SmoothField DisparityField::atInfinity() const {
  SmoothField field{change_};
  field.coefficients[0] = offset();
  field.coefficients[kAcross] += across_ * offset();
  return field;
}

double DisparityField::calibrationShare(const SmoothField& field) const {
  const double offset = field.coefficients[0];
  const double rms = field.rmsWithoutOffset();
  if (offset == 0 || rms == 0) return 0;
  // The offset is o = left + turn, where left = w (down + across - a turn) + rest: the second
  // term across, too, grows with a turn. So o - w (down + across) is rest + (1 - w a) turn.
  const double unexplained =
      offset - kByTerm * (field.coefficients[kDown] + field.coefficients[kAcross]);
  const double seen_of_turn = 1 - kByTerm * across_by_yaw_;
  const double sigma_turn = seen_of_turn * kTurned * focal_;
  const double rest = kRest * rms * kRest * rms;
  const double both = rest + sigma_turn * sigma_turn;
  // With and without a turn, which are equally likely before.
  const double still = density(unexplained, rest);
  const double turned = density(unexplained, both);
  const double gain = sigma_turn * sigma_turn / both / seen_of_turn;
  const double turn = turned / (still + turned) * gain * unexplained;
  return std::clamp(1 - turn / offset, 0.0, 1.0);
}

void DisparityField::updateShares() {
  const bool compensates = on_ && by_disparity_ > 0;
  const double share = compensates ? calibrationShare(atInfinity()) : 0;
  compensated_ = by_disparity_ * share;
  across_ = across_by_yaw_ * (1 - share);
}

}  // namespace tolman::direct_sparse
