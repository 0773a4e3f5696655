// SPDX-License-Identifier: BSD-3-Clause
// Mean and standard deviation of many numbers. Sums are in a fixed order on every machine.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

namespace tolman::view_sequences {

struct Sums {
  double count = 0;
  double sum = 0;
  double squares = 0;

  void add(const Sums& other) {
    count += other.count;
    sum += other.sum;
    squares += other.squares;
  }
  double mean() const { return count > 0 ? sum / count : 0; }
  double variance() const {
    return count > 0 ? std::max(0.0, squares / count - mean() * mean()) : 0;
  }
  /// Standard deviation with a prior: `deviation` counts as much as `views` numbers.
  double deviationWithPrior(double views, double deviation) const {
    return std::sqrt((count * variance() + views * deviation * deviation) / (count + views));
  }
};

inline Sums sumsOf(std::span<const float> values) {
  constexpr std::size_t kLanes = 8;
  std::array<double, kLanes> sum{};
  std::array<double, kLanes> squares{};
  const std::size_t whole = values.size() / kLanes * kLanes;
  for (std::size_t i = 0; i < whole; i += kLanes) {
    for (std::size_t k = 0; k < kLanes; ++k) {
      const double value = values[i + k];
      sum[k] += value;
      squares[k] += value * value;
    }
  }
  Sums sums;
  sums.count = static_cast<double>(values.size());
  for (std::size_t k = 0; k < kLanes; ++k) {
    sums.sum += sum[k];
    sums.squares += squares[k];
  }
  for (std::size_t i = whole; i < values.size(); ++i) {
    sums.sum += values[i];
    sums.squares += static_cast<double>(values[i]) * values[i];
  }
  return sums;
}

}  // namespace tolman::view_sequences
