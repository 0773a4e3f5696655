// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/firing_rate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

namespace tolman::evaluation {
namespace {

double wrapped(double angle) {
  const double rest = std::fmod(angle, kRadiansOfTurn);
  return rest < 0 ? rest + kRadiansOfTurn : rest;
}

/// Removes the connected field around bin (r, c) from `fires` and returns its centre.
Eigen::Vector2d takeField(const RateMap& map, Eigen::MatrixXi& fires, Eigen::Index r,
                          Eigen::Index c) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> open{{r, c}};
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double rates = 0;
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (i < 0 || j < 0 || i >= fires.rows() || j >= fires.cols() || fires(i, j) == 0) continue;
    fires(i, j) = 0;
    sum += map.rate(i, j) * Eigen::Vector2d(static_cast<double>(i), static_cast<double>(j));
    rates += map.rate(i, j);
    for (Eigen::Index di = -1; di <= 1; ++di) {
      for (Eigen::Index dj = -1; dj <= 1; ++dj) open.emplace_back(i + di, j + dj);
    }
  }
  return map.corner + map.bin * (sum / rates + Eigen::Vector2d::Constant(0.5));
}

/// Rates of a circle of bins; bins without visits are interpolated between their neighbours.
std::vector<double> interpolated(const std::vector<double>& rate,
                                 const std::vector<double>& visits) {
  const std::size_t size = rate.size();
  const auto nearest = [&](std::size_t from, std::size_t step) {
    std::size_t away = 0;
    while (!(visits[(from + away * step) % size] > 0)) ++away;
    return away;
  };
  std::vector<double> whole = rate;
  for (std::size_t i = 0; i < size; ++i) {
    if (visits[i] > 0) continue;
    const std::size_t after = nearest(i, 1);
    const std::size_t before = nearest(i, size - 1);
    const double share = static_cast<double>(before) / static_cast<double>(before + after);
    whole[i] =
        (1 - share) * rate[(i + before * (size - 1)) % size] + share * rate[(i + after) % size];
  }
  return whole;
}

/// Number of bins from the peak to where the curve falls to half of it; `step` is the direction.
double binsToHalf(const std::vector<double>& rate, std::size_t peak, std::size_t step) {
  const double half = 0.5 * rate[peak];
  double last = rate[peak];
  for (std::size_t away = 1; away <= rate.size() / 2; ++away) {
    const double here = rate[(peak + away * step) % rate.size()];
    if (here < half) return static_cast<double>(away) - (half - here) / (last - here);
    last = here;
  }
  return static_cast<double>(rate.size()) / 2;
}

std::optional<double> halfWidth(const TuningCurve& curve, const std::vector<double>& visits) {
  const auto visited = std::ranges::count_if(visits, [](double count) { return count > 0; });
  const std::size_t size = visits.size();
  if (2 * static_cast<std::size_t>(visited) < size) return std::nullopt;
  const std::vector<double> rate = interpolated(curve.rate, visits);
  const auto peak = static_cast<std::size_t>(std::ranges::max_element(rate) - rate.begin());
  if (!(rate[peak] > 0)) return std::nullopt;
  const double bins = 0.5 * (binsToHalf(rate, peak, 1) + binsToHalf(rate, peak, size - 1));
  return bins * kRadiansOfTurn / static_cast<double>(size);
}

}  // namespace

RateMap rateMap(const std::vector<Sample>& samples, int bins_on_the_long_side) {
  RateMap map;
  Eigen::AlignedBox2d box;
  for (const Sample& sample : samples) box.extend(sample.position);
  if (box.isEmpty() || !box.sizes().allFinite()) return map;
  map.corner = box.min();
  map.bin = std::max(box.sizes().maxCoeff() / bins_on_the_long_side, 1e-6);
  const auto bins = [&](double length) { return static_cast<Eigen::Index>(length / map.bin) + 1; };
  map.rate = Eigen::MatrixXd::Zero(bins(box.sizes().x()), bins(box.sizes().y()));
  map.visits = map.rate;
  for (const Sample& sample : samples) {
    const Eigen::Vector2d place = (sample.position - map.corner) / map.bin;
    const auto right = static_cast<Eigen::Index>(place.x());
    const auto forward = static_cast<Eigen::Index>(place.y());
    map.rate(right, forward) += sample.rate;
    map.visits(right, forward) += 1;
  }
  map.rate = map.rate.binaryExpr(map.visits, [](double sum, double count) {
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
  });
  return map;
}

double highestRate(const RateMap& map) {
  double highest = 0;
  for (const double rate : map.rate.reshaped())
    highest = std::isnan(rate) ? highest : std::max(highest, rate);
  return highest;
}

TuningCurve tuningCurve(const std::vector<Sample>& samples, int bins) {
  TuningCurve curve;
  const auto size = static_cast<std::size_t>(bins);
  curve.rate.assign(size, 0);
  std::vector<double> visits(size, 0);
  for (const Sample& sample : samples) {
    const auto bin = std::min(
        static_cast<std::size_t>(wrapped(sample.heading) / kRadiansOfTurn * bins), size - 1);
    curve.rate[bin] += sample.rate;
    visits[bin] += 1;
  }
  std::complex<double> sum = 0;
  double total = 0;
  for (std::size_t i = 0; i < size; ++i) {
    if (visits[i] > 0) curve.rate[i] /= visits[i];
    const double centre = (static_cast<double>(i) + 0.5) / bins * kRadiansOfTurn;
    sum += std::polar(1.0, centre) * curve.rate[i];
    total += curve.rate[i];
  }
  if (total > 0) curve.mean_vector_length = std::abs(sum) / total;
  curve.preferred = wrapped(std::arg(sum));
  curve.half_width = halfWidth(curve, visits);
  return curve;
}

double spatialInformation(const RateMap& map) {
  const double visits = map.visits.sum();
  if (!(visits > 0)) return 0;
  double mean = 0;
  for (Eigen::Index i = 0; i < map.rate.size(); ++i) {
    if (map.visits(i) > 0) mean += map.visits(i) / visits * map.rate(i);
  }
  if (!(mean > 0)) return 0;
  double bits = 0;
  for (Eigen::Index i = 0; i < map.rate.size(); ++i) {
    const double ratio = map.visits(i) > 0 ? map.rate(i) / mean : 0;
    if (ratio > 0) bits += map.visits(i) / visits * ratio * std::log2(ratio);
  }
  return bits;
}

std::vector<Eigen::Vector2d> fields(const RateMap& map, double share) {
  const double highest = highestRate(map);
  if (!(highest > 0)) return {};
  Eigen::MatrixXi fires =
      map.rate.unaryExpr([&](double rate) { return rate > share * highest ? 1 : 0; });
  std::vector<Eigen::Vector2d> centres;
  for (Eigen::Index i = 0; i < fires.rows(); ++i) {
    for (Eigen::Index j = 0; j < fires.cols(); ++j) {
      if (fires(i, j) != 0) centres.push_back(takeField(map, fires, i, j));
    }
  }
  return centres;
}

}  // namespace tolman::evaluation
