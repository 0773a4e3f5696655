// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/place_scores.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace tolman::evaluation {
namespace {

/// A bin of a field, and its distance from the nearest wall, in bins.
double wallDistance(const RateMap& map, Eigen::Index i, Eigen::Index j) {
  const Eigen::Index across = std::min(i, map.rate.rows() - 1 - i);
  return static_cast<double>(std::min(across, std::min(j, map.rate.cols() - 1 - j)));
}

/// The largest share of one of the four walls that the field `number` covers.
double wallShare(const Eigen::MatrixXi& field, int number) {
  const auto share = [&](const auto& wall) {
    return static_cast<double>((wall.array() == number).count()) / static_cast<double>(wall.size());
  };
  return std::max({share(field.row(0)), share(field.row(field.rows() - 1)), share(field.col(0)),
                   share(field.col(field.cols() - 1))});
}

}  // namespace

std::optional<double> sparsity(const RateMap& map) {
  double mean = 0;
  double square = 0;
  for (Eigen::Index i = 0; i < map.rate.size(); ++i) {
    if (!(map.visits(i) > 0)) continue;
    mean += map.visits(i) * map.rate(i);
    square += map.visits(i) * map.rate(i) * map.rate(i);
  }
  if (!(square > 0)) return std::nullopt;
  return mean * mean / (square * map.visits.sum());
}

std::optional<double> coherence(const RateMap& map) {
  Correlation sums;
  for (Eigen::Index i = 0; i < map.rate.rows(); ++i) {
    for (Eigen::Index j = 0; j < map.rate.cols(); ++j) {
      double around = -map.rate(i, j);
      int count = -1;
      for (Eigen::Index a = std::max<Eigen::Index>(i - 1, 0);
           a <= std::min(i + 1, map.rate.rows() - 1); ++a) {
        for (Eigen::Index b = std::max<Eigen::Index>(j - 1, 0);
             b <= std::min(j + 1, map.rate.cols() - 1); ++b) {
          if (!(map.visits(a, b) > 0)) continue;
          around += map.rate(a, b);
          ++count;
        }
      }
      if (map.visits(i, j) > 0 && count > 0) sums.add(map.rate(i, j), around / count);
    }
  }
  const double r = sums.value();
  if (std::isnan(r)) return std::nullopt;
  return std::atanh(std::clamp(r, -1 + 1e-12, 1 - 1e-12));
}

std::optional<double> borderScore(const RateMap& map) {
  constexpr double kFires = 0.3;       // of the highest rate
  constexpr double kLeastArea = 0.02;  // m^2
  constexpr double kOpenField = 0.5;   // of the box
  const auto visited = static_cast<double>((map.visits.array() > 0).count());
  if (visited < kOpenField * static_cast<double>(map.rate.size())) return std::nullopt;
  const FieldBins found = fieldBins(map, kFires);
  double covered = 0;
  double distance = 0;
  double rates = 0;
  for (int number = 1; number <= found.count; ++number) {
    const auto bins = static_cast<double>((found.field.array() == number).count());
    if (bins * map.bin * map.bin < kLeastArea) continue;
    covered = std::max(covered, wallShare(found.field, number));
    for (Eigen::Index i = 0; i < map.rate.rows(); ++i) {
      for (Eigen::Index j = 0; j < map.rate.cols(); ++j) {
        if (found.field(i, j) != number) continue;
        distance += map.rate(i, j) * wallDistance(map, i, j);
        rates += map.rate(i, j);
      }
    }
  }
  const double farthest = 0.5 * static_cast<double>(std::min(map.rate.rows(), map.rate.cols()) - 1);
  if (!(rates > 0) || !(farthest > 0)) return std::nullopt;
  const double mean = distance / rates / farthest;
  return covered + mean > 0 ? std::optional((covered - mean) / (covered + mean)) : std::nullopt;
}

std::optional<double> speedScore(const std::vector<Sample>& samples) {
  Correlation sums;
  for (const Sample& sample : samples) {
    if (sample.seconds > 0) sums.add(sample.rate, sample.speed);
  }
  const double r = sums.value();
  return std::isnan(r) ? std::nullopt : std::optional(r);
}

void setTimes(RecordedUnits& units, const std::vector<std::int64_t>& stamps_ns, bool metric) {
  constexpr double kLongest = 5;       // median steps
  constexpr double kStanding = 0.025;  // m/s
  constexpr double kAnimal = 2;        // m/s
  std::vector<Sample>& walk = units.walk;
  std::vector<double> steps;
  for (std::size_t i = 1; i < walk.size(); ++i) {
    steps.push_back(1e-9 * static_cast<double>(stamps_ns[i] - stamps_ns[i - 1]));
  }
  if (steps.empty()) return;
  const double usual = errorFigures(steps)->median;
  std::vector<double> speeds;
  for (std::size_t i = 0; i < walk.size(); ++i) {
    const double step = i < steps.size() ? steps[i] : usual;
    walk[i].seconds = step > 0 && step <= kLongest * usual ? step : usual;
    const auto isJoined = [&](std::size_t k) {  // with the sample behind it
      return k < steps.size() && steps[k] <= kLongest * usual;
    };
    const std::size_t before = i > 0 && isJoined(i - 1) ? i - 1 : i;
    const std::size_t after = isJoined(i) ? i + 1 : i;
    const double time = 1e-9 * static_cast<double>(stamps_ns[after] - stamps_ns[before]);
    const double way = (walk[after].position - walk[before].position).norm();
    walk[i].speed = time > 0 ? way / time : 0;
    speeds.push_back(walk[i].speed);
  }
  const auto high = std::ranges::next(speeds.begin(), std::ssize(speeds) * 95 / 100);
  std::ranges::nth_element(speeds, high);
  if (!metric || *high > kAnimal) return;
  units.speed_limit = kStanding;
  for (Sample& sample : walk) sample.seconds = sample.speed < kStanding ? 0 : sample.seconds;
}

}  // namespace tolman::evaluation
