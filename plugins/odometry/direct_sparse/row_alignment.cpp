// SPDX-License-Identifier: BSD-3-Clause
#include "row_alignment.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "patch_match.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr int kRowPatchRadius = 3;     // px; chosen, not tuned
constexpr double kCornerSigma = 0.25;  // px, of one corner; chosen, not tuned
/// Share of a corner's information that is new: the same corner is seen by several keyframes.
/// Chosen, not tuned.
constexpr double kNewShare = 0.3;
/// Keyframes after which what was learnt has lost most of its weight, because a rig changes with
/// temperature. Chosen, not tuned.
constexpr double kMemory = 1000;

}  // namespace

void RowAlignment::configure(int width, int height, double sigma) {
  width_ = width;
  height_ = height;
  sigma_ = sigma;
  reset();
}

void RowAlignment::reset() {
  field_ = SmoothField();
  information_ = isOn() ? prior() : Information::Zero();
  information_vector_.setZero();
  shift_.setNone();
}

/// Higher terms are expected to be smaller, by their degree.
RowAlignment::Information RowAlignment::prior() const {
  Information prior = Information::Zero();
  for (int k = 0; k < SmoothField::kTerms; ++k) {
    const double sigma = sigma_ / (1 + SmoothField::kDegrees[static_cast<std::size_t>(k)]);
    prior(k, k) = 1 / (sigma * sigma);
  }
  return prior;
}

void RowAlignment::observe(const GrayLevel& left, const GrayLevel& right,
                           const std::vector<RowCorner>& corners, float gain) {
  if (!isOn()) return;
  errors_.assign(corners.size(), std::nullopt);
  tbb::parallel_for(std::size_t{0}, corners.size(), [&](std::size_t i) {
    const RowCorner& corner = corners[i];
    const auto v = static_cast<float>(corner.v);
    const auto match =
        matchPatch(left, corner.u, corner.v, right,
                   {static_cast<float>(corner.u) - corner.disparity, v}, gain, kRowPatchRadius);
    if (match) errors_[i] = match->y() - v;
  });
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!errors_[i]) continue;
    Measurement m;
    const double u = static_cast<double>(corners[i].u) - static_cast<double>(corners[i].disparity);
    m.terms = SmoothField::termsAt(u, corners[i].v, width_, height_);
    m.below = shift_.at(u, corners[i].v) + static_cast<double>(*errors_[i]);
    measurements.push_back(m);
  }
  learn(measurements);
  if (isSignificant()) {
    shift_.set(field_, width_, height_);
  } else {
    shift_.setNone();
  }
}

/// Somewhere the field is larger than 0.1 px and three standard deviations; chosen, not tuned.
bool RowAlignment::isSignificant() const {
  constexpr int kGrid = 5;  // places each way
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int column = i % kGrid;
    const int row = i / kGrid;
    const double u = column * (width_ - 1.0) / (kGrid - 1);
    const double v = row * (height_ - 1.0) / (kGrid - 1);
    const double shift = std::fabs(field_.at(u, v, width_, height_));
    if (shift > 0.1 && shift > 3 * sigmaAt(u, v)) return true;
  }
  return false;
}

void RowAlignment::learn(const std::vector<Measurement>& measurements) {
  const Information before = prior() + (1 - 1 / kMemory) * (information_ - prior());
  const SmoothField::Terms vector_before = (1 - 1 / kMemory) * information_vector_;
  // Weights depend on the fit and the fit on weights; three rounds are chosen, not tuned.
  for (int round = 0; round < 3; ++round) {
    information_ = before;
    information_vector_ = vector_before;
    for (const Measurement& m : measurements) {
      const double error = std::fabs(m.below - field_.coefficients.dot(m.terms));
      const double limit = 1.5 * kCornerSigma;  // Huber's, chosen, not tuned
      const double weight =
          kNewShare / (kCornerSigma * kCornerSigma) * std::min(1.0, limit / error);
      information_.noalias() += weight * m.terms * m.terms.transpose();
      information_vector_ += weight * m.below * m.terms;
    }
    field_.coefficients = information_.ldlt().solve(information_vector_);
  }
}

double RowAlignment::sigmaAt(double u, double v) const {
  if (!isOn()) return 0;
  const SmoothField::Terms terms = SmoothField::termsAt(u, v, width_, height_);
  return std::sqrt(std::max(0.0, terms.dot(information_.ldlt().solve(terms))));
}

}  // namespace tolman::direct_sparse
