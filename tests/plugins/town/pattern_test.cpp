// SPDX-License-Identifier: BSD-3-Clause
// Box-filtered patterns against the mean of many point samples.
#include "pattern.hpp"

#include <catch2/catch.hpp>
#include <cmath>

using namespace tolman::town;

namespace {

/// Mean of `pattern` over [x - width/2, x + width/2] by sampling.
template <class Pattern>
float sampled(float x, float width, Pattern pattern) {
  constexpr int kSamples = 20000;
  int inside = 0;
  for (int i = 0; i < kSamples; ++i) {
    inside += pattern(x + width * ((static_cast<float>(i) + 0.5F) / kSamples - 0.5F));
  }
  return static_cast<float>(inside) / kSamples;
}

}  // namespace

TEST_CASE("stripes are averaged exactly, however wide the pixel") {
  const float period = GENERATE(0.3F, 1.0F);
  const float width = GENERATE(0.01F, 0.2F, 0.9F, 3.7F);
  for (int i = 0; i < 40; ++i) {
    const float x = -2 + 0.1037F * static_cast<float>(i);
    const auto stripe = [&](float t) {
      return t - period * std::floor(t / period) < 0.25F * period;
    };
    CHECK(filteredStripes(period, 0.25F * period, eight(x), eight(width))[3] ==
          Approx(sampled(x, width, stripe)).margin(2e-3));
  }
}

TEST_CASE("steps and pulses are averaged exactly") {
  for (int i = 0; i < 40; ++i) {
    const float x = -1 + 0.0513F * static_cast<float>(i);
    CHECK(filteredStep(0.2F, eight(x), eight(0.5F))[0] ==
          Approx(sampled(x, 0.5F, [](float t) { return t >= 0.2F; })).margin(2e-3));
    CHECK(filteredPulse(-0.1F, 0.4F, eight(x), eight(0.7F))[7] ==
          Approx(sampled(x, 0.7F, [](float t) { return t >= -0.1F && t < 0.4F; })).margin(2e-3));
  }
}

TEST_CASE("cells of their own tone are averaged exactly across their boundaries") {
  const auto value = [](int k) { return static_cast<float>((k * k + 100) % 7); };
  constexpr int kSamples = 20000;
  for (int i = 0; i < 60; ++i) {
    const float x = -1 + 0.0371F * static_cast<float>(i);
    double sum = 0;
    for (int j = 0; j < kSamples; ++j) {
      const float t = x + 0.2F * ((static_cast<float>(j) + 0.5F) / kSamples - 0.5F);
      sum += static_cast<double>(value(static_cast<int>(std::floor(t / 0.3F))));
    }
    const auto values = [](EightInts k) { return toFloat((k * k + 100) % 7); };
    CHECK(filteredCells(0.3F, eight(x), eight(0.2F), values)[2] ==
          Approx(sum / kSamples).margin(5e-3));
  }
}
