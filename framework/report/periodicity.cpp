// SPDX-License-Identifier: BSD-3-Clause
#include "report/periodicity.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/core.hpp>

namespace tolman::report {
namespace {

using evaluation::RateMap;

constexpr double kLeastBins = 4;
constexpr double kLeastPeriods = 1.5;  // along the shorter side
constexpr double kFiner = 1.02;        // from one spacing to the next
constexpr int kDirections = 45;        // of a quarter turn
constexpr int kPadding = 4;            // bins of the spectrum for each of the map

double sumOfRates(const RateMap& map) { return (map.visits.array() > 0).select(map.rate, 0).sum(); }

/// Rates minus their mean in visited bins, divided by their sum, and zero-padded.
cv::Mat_<float> paddedShares(const RateMap& map) {
  const double sum = sumOfRates(map);
  const double mean = 1 / static_cast<double>((map.visits.array() > 0).count());
  const auto longest = static_cast<int>(std::max(map.rate.rows(), map.rate.cols()));
  const int size = cv::getOptimalDFTSize(kPadding * longest);
  cv::Mat_<float> shares(size, size, 0.0F);
  for (int i = 0; i < map.rate.rows(); ++i) {
    for (int j = 0; j < map.rate.cols(); ++j) {
      if (map.visits(i, j) > 0) shares(i, j) = static_cast<float>(map.rate(i, j) / sum - mean);
    }
  }
  return shares;
}

/// Magnitude |F(k)| of their Fourier transform.
class Spectrum {
 public:
  explicit Spectrum(const RateMap& map) {
    const cv::Mat_<float> shares = paddedShares(map);
    size_ = shares.rows;
    cv::Mat_<cv::Vec2f> transform;
    cv::dft(shares, transform, cv::DFT_COMPLEX_OUTPUT, static_cast<int>(map.rate.rows()));
    cv::Mat_<float> parts[2];
    cv::split(transform, parts);
    cv::magnitude(parts[0], parts[1], magnitude_);
  }

  /// At `k` cycles per bin, by bilinear interpolation.
  double at(const Eigen::Vector2d& k) const {
    const Eigen::Vector2d place = k * size_;
    const Eigen::Vector2d low = place.array().floor();
    const Eigen::Vector2d part = place - low;
    const int i = wrapped(low.x());
    const int j = wrapped(low.y());
    const int next_i = (i + 1) % size_;
    const int next_j = (j + 1) % size_;
    return (1 - part.x()) * ((1 - part.y()) * magnitude_(i, j) + part.y() * magnitude_(i, next_j)) +
           part.x() *
               ((1 - part.y()) * magnitude_(next_i, j) + part.y() * magnitude_(next_i, next_j));
  }

 private:
  int wrapped(double index) const {
    const int rest = static_cast<int>(index) % size_;
    return rest < 0 ? rest + size_ : rest;
  }
  int size_ = 0;
  cv::Mat_<float> magnitude_;
};

}  // namespace

std::optional<Periodicity> squarePeriodicity(const RateMap& map) {
  const auto shorter = static_cast<double>(std::min(map.rate.rows(), map.rate.cols()));
  if (shorter < kLeastPeriods * kLeastBins || !(sumOfRates(map) > 0)) return std::nullopt;
  const Spectrum spectrum(map);
  Periodicity best;
  for (double bins = kLeastBins; bins <= shorter / kLeastPeriods; bins *= kFiner) {
    for (int d = 0; d < kDirections; ++d) {
      const double direction = d * std::numbers::pi / (2 * kDirections);
      const Eigen::Vector2d k = Eigen::Vector2d(std::cos(direction), std::sin(direction)) / bins;
      const double score = std::min(spectrum.at(k), spectrum.at({-k.y(), k.x()}));
      if (score > best.score) best = {score, bins * map.bin, direction};
    }
  }
  return best;
}

}  // namespace tolman::report
