// SPDX-License-Identifier: BSD-3-Clause
#include "attractor_sheet.hpp"

#include <algorithm>
#include <array>
#include <complex>
#include <cstddef>
#include <numeric>

namespace tolman::can_sheet {
namespace {

constexpr double kPaperUnits = 90;  // number of units that the paper's constants hold for
constexpr int kStepsToRest = 60;    // steps that shape the bump at the start; chosen, not tuned
/// Units of a row that are summed at a time: as many as the registers of SSE2 hold.
constexpr std::size_t kTile = 20;
constexpr std::size_t kSmallTile = 4;  // units at a time in the rest of a row
/// If the total activity leaves these limits, it is replaced by a bump at rest. Keeps
/// the division by it finite.
constexpr double kMinTotal = 1e-6;
constexpr double kMaxTotal = 1e6;
constexpr double kStartWidth = 0.14;  // periods, also of injected bumps; chosen, not tuned

std::size_t unsignedOf(int value) { return static_cast<std::size_t>(value); }

/// Adds to kWidth units of a row their inputs from one row of units.
template <std::size_t kWidth>
void addRow(const float* activity, const float* weights, std::size_t units, float* input) {
  std::array<float, kWidth> sum{};
  for (std::size_t from = 0; from < units; ++from) {
    const float rate = activity[from];
    if (!(rate > 0)) continue;
    const float* weight = weights + units - from;
    for (std::size_t i = 0; i < kWidth; ++i) sum[i] += rate * weight[i];
  }
  for (std::size_t i = 0; i < kWidth; ++i) input[i] += sum[i];
}

}  // namespace

AttractorSheet::AttractorSheet(const SheetSettings& settings)
    : settings_(settings),
      activity_(unsignedOf(settings.units * settings.units)),
      input_(activity_.size()),
      weights_(2 * activity_.size()) {
  setBump(Phase::Zero());
  for (int i = 0; i < kStepsToRest; ++i) step(Phase::Zero());
}

double AttractorSheet::total() const {
  return std::accumulate(activity_.begin(), activity_.end(), 0.0);
}

void AttractorSheet::setBump(const Phase& place) {
  std::fill(activity_.begin(), activity_.end(), 0.0F);
  activity_[0] = 1;
  inject(place, 1);
  activity_[0] -= 1;
}

void AttractorSheet::inject(const Phase& place, double share) {
  const int n = settings_.units;
  std::vector<double> bump(activity_.size());
  for (std::size_t i = 0; i < bump.size(); ++i) {
    const Phase unit = Phase(i % unsignedOf(n), i / unsignedOf(n)) / n;
    bump[i] = std::exp(-shortest(unit - place).squaredNorm() / (kStartWidth * kStartWidth));
  }
  const double factor = share * total() / std::accumulate(bump.begin(), bump.end(), 0.0);
  for (std::size_t i = 0; i < bump.size(); ++i) {
    activity_[i] += static_cast<float>(factor * bump[i]);
  }
}

// Equation 4: w_ij = I exp(-|c_i - c_j + alpha R v|^2 / sigma^2) - T.
void AttractorSheet::setWeights(const Phase& motion) {
  const int n = settings_.units;
  const double scale = kPaperUnits / (n * n);
  const double variance = settings_.width * settings_.width;
  for (int v = 0; v < n; ++v) {
    float* row = &weights_[unsignedOf(2 * v * n)];
    for (int u = 0; u < n; ++u) {
      const Phase difference = Phase(u, v) / n - motion;
      const double gauss = std::exp(-shortest(difference).squaredNorm() / variance);
      row[u] = row[u + n] =
          static_cast<float>(scale * (settings_.intensity * gauss - settings_.inhibition));
    }
  }
}

// Equation 2: B_i = sum of A_j w_ji.
void AttractorSheet::addInputs() {
  const std::size_t n = unsignedOf(settings_.units);
  std::fill(input_.begin(), input_.end(), 0.0F);
  for (std::size_t to = 0; to < n; ++to) {
    for (std::size_t from = 0; from < n; ++from) {
      const float* rates = &activity_[from * n];
      const float* weights = &weights_[2 * n * ((to + n - from) % n)];
      std::size_t at = 0;
      for (; at + kTile <= n; at += kTile) {
        addRow<kTile>(rates, weights + at, n, &input_[to * n + at]);
      }
      for (; at + kSmallTile <= n; at += kSmallTile) {
        addRow<kSmallTile>(rates, weights + at, n, &input_[to * n + at]);
      }
      for (; at < n; ++at) addRow<1>(rates, weights + at, n, &input_[to * n + at]);
    }
  }
}

// Equation 3: A_i = (1 - tau) B_i + tau B_i / sum of A_j, and none below 0.
void AttractorSheet::step(const Phase& motion) {
  const double before = total();
  setWeights(motion);
  addInputs();
  const auto factor =
      static_cast<float>(1 - settings_.stabilisation + settings_.stabilisation / before);
  const Phase expected = wrapped(phase() + motion);
  for (std::size_t i = 0; i < activity_.size(); ++i) {
    activity_[i] = std::max(0.0F, factor * input_[i]);
  }
  const double after = total();
  if (!(after > kMinTotal && after < kMaxTotal)) setBump(expected);
}

Phase AttractorSheet::phase() const {
  const std::size_t n = unsignedOf(settings_.units);
  std::vector<std::complex<double>> turns(n);
  for (std::size_t i = 0; i < n; ++i) {
    turns[i] = std::polar(1.0, 2 * std::numbers::pi * static_cast<double>(i) / settings_.units);
  }
  std::complex<double> along_u = 0;
  std::complex<double> along_v = 0;
  for (std::size_t v = 0; v < n; ++v) {
    for (std::size_t u = 0; u < n; ++u) {
      const auto rate = static_cast<double>(activity_[v * n + u]);
      along_u += rate * turns[u];
      along_v += rate * turns[v];
    }
  }
  return wrapped(Phase(std::arg(along_u), std::arg(along_v)) / (2 * std::numbers::pi));
}

bool AttractorSheet::restore(std::span<const float> activity) {
  if (activity.size() != activity_.size()) return false;
  double sum = 0;
  for (const float rate : activity) {
    if (!(rate >= 0 && rate < kMaxTotal)) return false;
    sum += static_cast<double>(rate);
  }
  if (!(sum > kMinTotal && sum < kMaxTotal)) return false;
  std::copy(activity.begin(), activity.end(), activity_.begin());
  return true;
}

}  // namespace tolman::can_sheet
