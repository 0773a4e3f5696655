// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/firing_rate.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman::evaluation {

namespace {

/// Gives the bins of the connected field around bin (r, c), which are -1, the number of the field.
void numberField(Eigen::MatrixXi& field, Eigen::Index r, Eigen::Index c, int number) {
  std::vector<std::pair<Eigen::Index, Eigen::Index>> open{{r, c}};
  while (!open.empty()) {
    const auto [i, j] = open.back();
    open.pop_back();
    if (i < 0 || j < 0 || i >= field.rows() || j >= field.cols() || field(i, j) >= 0) continue;
    field(i, j) = number;
    for (Eigen::Index di = -1; di <= 1; ++di) {
      for (Eigen::Index dj = -1; dj <= 1; ++dj) open.emplace_back(i + di, j + dj);
    }
  }
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
    map.rate(right, forward) += sample.rate * sample.seconds;
    map.visits(right, forward) += sample.seconds;
  }
  map.rate = map.rate.binaryExpr(map.visits, [](double sum, double count) {
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
  });
  return map;
}

RateMap smoothed(const RateMap& map, double sigma) {
  const auto reach = static_cast<Eigen::Index>(std::ceil(3 * sigma));
  const auto along = [&](const Eigen::MatrixXd& values) {  // sums over the columns' neighbours
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(values.rows(), values.cols());
    for (Eigen::Index d = -reach; d <= reach; ++d) {
      const Eigen::Index count = values.cols() - std::abs(d);
      if (count <= 0) continue;
      const double weight = std::exp(-0.5 * static_cast<double>(d * d) / (sigma * sigma));
      sum.middleCols(std::max<Eigen::Index>(-d, 0), count) +=
          weight * values.middleCols(std::max<Eigen::Index>(d, 0), count);
    }
    return sum;
  };
  const auto spread = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return along(along(values).transpose()).transpose();
  };
  const Eigen::ArrayXXd activity = (map.visits.array() > 0).select(map.rate.array(), 0);
  RateMap result = map;
  const Eigen::ArrayXXd time = spread(map.visits).array();
  result.rate = (map.visits.array() > 0)
                    .select(spread(activity * map.visits.array()).array() / time, map.rate.array());
  return result;
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
    const auto bin = std::min(static_cast<std::size_t>(wrapPeriod(sample.heading, kRadiansOfTurn) /
                                                       kRadiansOfTurn * bins),
                              size - 1);
    curve.rate[bin] += sample.rate * sample.seconds;
    visits[bin] += sample.seconds;
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
  curve.preferred = wrapPeriod(std::arg(sum), kRadiansOfTurn);
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

FieldBins fieldBins(const RateMap& map, double share) {
  const double highest = highestRate(map);
  FieldBins found;
  found.field = map.rate.unaryExpr(
      [&](double rate) { return highest > 0 && rate > share * highest ? -1 : 0; });
  for (Eigen::Index i = 0; i < found.field.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.field.cols(); ++j) {
      if (found.field(i, j) < 0) numberField(found.field, i, j, ++found.count);
    }
  }
  return found;
}

std::vector<Eigen::Vector2d> fields(const RateMap& map, double share) {
  const FieldBins found = fieldBins(map, share);
  std::vector<Eigen::Vector3d> sums(static_cast<std::size_t>(found.count), Eigen::Vector3d::Zero());
  for (Eigen::Index i = 0; i < found.field.rows(); ++i) {
    for (Eigen::Index j = 0; j < found.field.cols(); ++j) {
      if (found.field(i, j) == 0) continue;
      sums[static_cast<std::size_t>(found.field(i, j) - 1)] +=
          map.rate(i, j) * Eigen::Vector3d(static_cast<double>(i), static_cast<double>(j), 1);
    }
  }
  std::vector<Eigen::Vector2d> centres;
  for (const Eigen::Vector3d& sum : sums) {
    const Eigen::Vector2d place = sum.head<2>() / sum.z() + Eigen::Vector2d::Constant(0.5);
    centres.emplace_back(map.corner + map.bin * place);
  }
  return centres;
}

void Correlation::add(double x, double y, double weight) {
  n += weight;
  a += weight * x;
  b += weight * y;
  aa += weight * x * x;
  bb += weight * y * y;
  ab += weight * x * y;
}

double Correlation::value() const {
  const double spread = (n * aa - a * a) * (n * bb - b * b);
  return spread > 1e-12 * n * aa * n * bb ? (n * ab - a * b) / std::sqrt(spread)
                                          : std::numeric_limits<double>::quiet_NaN();
}

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

}  // namespace tolman::evaluation
