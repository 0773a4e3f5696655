// SPDX-License-Identifier: BSD-3-Clause
// Bumps against a numeric product of wrapped Gaussians on a fine grid, which shares no formula.
#include "periodic_bump.hpp"

#include <catch2/catch.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

using namespace tolman;
using namespace tolman::paper_attractor;

namespace {

double wrappedGaussian(double x, double mean, double precision, double period) {
  double sum = 0;
  for (int turn = -3; turn <= 3; ++turn) {
    const double off = x - mean + turn * period;
    sum += std::exp(-0.5 * precision * off * off);
  }
  return sum;
}

struct Numeric {
  double peak = 0;       ///< where the product is largest
  double mean = 0;       ///< circular mean of the product
  double precision = 0;  ///< from the variance about that mean
};

/// Multiplies the two densities point by point.
Numeric numericProduct(const PeriodicBump<1>& a, const PeriodicBump<1>& b, double period) {
  constexpr int kPoints = 200000;
  std::vector<double> product;
  std::complex<double> direction = 0;
  std::size_t peak = 0;
  for (int i = 0; i < kPoints; ++i) {
    const double x = period * i / kPoints;
    product.push_back(wrappedGaussian(x, a.mean(0), a.precision, period) *
                      wrappedGaussian(x, b.mean(0), b.precision, period));
    direction += product.back() * std::polar(1.0, 2 * std::numbers::pi * x / period);
    if (product.back() > product[peak]) peak = product.size() - 1;
  }
  Numeric result;
  result.peak = period * static_cast<double>(peak) / kPoints;
  result.mean = wrapPeriod(std::arg(direction) * period / (2 * std::numbers::pi), period);
  double mass = 0;
  double spread = 0;
  for (std::size_t i = 0; i < product.size(); ++i) {
    const double off =
        std::remainder(period * static_cast<double>(i) / kPoints - result.mean, period);
    mass += product[i];
    spread += product[i] * off * off;
  }
  result.precision = mass / spread;
  return result;
}

PeriodicBump<1> bump(double mean, double precision) { return {Phase<1>(mean), precision}; }

}  // namespace

TEST_CASE("the product of narrow bumps: mean, peak and precision as on a fine grid") {
  const double period = GENERATE(2 * std::numbers::pi, 15.0);
  const double sigma = period / 40;  // narrow: the far side plays no part
  const double start = GENERATE(0.0, 0.01, 0.3, 0.5, 0.98);
  const double apart = GENERATE(-0.1, -0.02, 0.0, 0.05, 0.12);
  const double ratio = GENERATE(0.1, 0.4, 1.0, 3.0);
  const auto a = bump(start * period, 1 / (sigma * sigma));
  const auto b = bump(wrapPeriod((start + apart) * period, period), ratio / (sigma * sigma));
  const PeriodicBump<1> product = combined<1>(a, b, period);
  const Numeric numeric = numericProduct(a, b, period);
  CHECK(std::remainder(product.mean(0) - numeric.peak, period) ==
        Approx(0).margin(1.01 * period / 200000));
  CHECK(std::remainder(product.mean(0) - numeric.mean, period) == Approx(0).margin(1e-6 * period));
  CHECK(product.precision == Approx(numeric.precision).epsilon(1e-4));
  CHECK(product.mean(0) >= 0);
  CHECK(product.mean(0) < period);
}

TEST_CASE("at the network's own widths the unwrapped mean is still the grid's peak") {
  // E = 100 on the ring; E = 1 with period 15 on the torus; injected 0.4 E.
  const double period = GENERATE(2 * std::numbers::pi, 15.0);
  const double energy = period < 10 ? 100 : 1;
  const double apart = GENERATE(-2.9, -1.0, 0.5, 2.9);
  const auto a = bump(0.2, energy);
  const auto b = bump(wrapPeriod(0.2 + apart, period), 0.4 * energy);
  const Numeric numeric = numericProduct(a, b, period);
  CHECK(std::remainder(combined<1>(a, b, period).mean(0) - numeric.peak, period) ==
        Approx(0).margin(1e-3));
}

TEST_CASE("across the seam, where raw means give the opposite side") {
  const double turn = 2 * std::numbers::pi;
  const PeriodicBump<1> sum = combined<1>(bump(turn - 0.1, 100), bump(0.1, 100), turn);
  CHECK(std::remainder(sum.mean(0), turn) == Approx(0).margin(1e-12));  // and not pi
  CHECK(sum.precision == 200);
  // On a torus of 15 cells: 14.8 with weight 3 and 0.2 with weight 1 make 14.9.
  const PeriodicBump<2> torus = combined<2>({{14.8, 0.2}, 3}, {{0.2, 14.8}, 1}, 15);
  CHECK(torus.mean.x() == Approx(14.9));
  CHECK(torus.mean.y() == Approx(0.1));
}

TEST_CASE("short ways and distances") {
  CHECK(shortWay<1>(Phase<1>(14.0), Phase<1>(1.0), 15)(0) == Approx(2));
  CHECK(shortWay<1>(Phase<1>(1.0), Phase<1>(14.0), 15)(0) == Approx(-2));
  CHECK(shortWay<1>(Phase<1>(0.0), Phase<1>(7.5), 15)(0) == -7.5);  // half a period: [-B/2, B/2)
  CHECK(distance<2>({14, 14}, {2, 3}, 15) == Approx(5));            // 3 and 4
  CHECK(distance<2>({3, 3}, {3, 3}, 15) == 0);
}

TEST_CASE("no precision at all keeps the first mean") {
  const PeriodicBump<1> sum = combined<1>(bump(1, 0), bump(2, 0), 15);
  CHECK(sum.mean(0) == 1);
  CHECK(sum.precision == 0);
}
