// SPDX-License-Identifier: BSD-3-Clause
// Values and gradients from the bytes of an image.
#include "gradient_samples.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// Eight samples, as arrays.
struct Sampled {
  std::array<float, 8> value, gx, gy;
};

Sampled sampled(const GrayLevel& image, const std::array<float, 8>& u,
                const std::array<float, 8>& v) {
  const GradientSamples samples = gradientSamples(image, loadEight(u.data()), loadEight(v.data()));
  Sampled out{};
  for (std::size_t k = 0; k < 8; ++k) {
    out.value[k] = samples.value[k];
    out.gx[k] = samples.gx[k];
    out.gy[k] = samples.gy[k];
  }
  return out;
}

/// A number between the pixels a, b in one row and c, d in the next, in exact arithmetic.
double between(double a, double b, double c, double d, double fx, double fy) {
  return (1 - fy) * ((1 - fx) * a + fx * b) + fy * ((1 - fx) * c + fx * d);
}

GrayLevel rough(int width, int height) {
  return test::levelOf(width, height,
                       [](int u, int v) { return (u * u * 37 + v * v * v * 91 + u * v) % 256; });
}

}  // namespace

TEST_CASE("gradients of a plane are its slopes, anywhere inside") {
  const GrayLevel image = test::levelOf(60, 20, [](int u, int v) { return 200 - 3 * u + 2 * v; });
  const std::array<float, 8> u = {1, 2, 7.25, 19.5, 22.75, 30.125, 40.75, 57.5};
  const std::array<float, 8> v = {9.5, 1, 17.5, 3.25, 4, 5, 6, 7};
  const Sampled samples = sampled(image, u, v);
  for (std::size_t k = 0; k < 8; ++k) {
    CAPTURE(k);
    CHECK(samples.value[k] == 200 - 3 * u[k] + 2 * v[k]);
    CHECK(samples.gx[k] == -3);
    CHECK(samples.gy[k] == 2);
  }
  CHECK(gradientSquared(image, 10, 10) == 13);
}

TEST_CASE("values and central differences are bilinear, exactly, at multiples of 1/128 px") {
  const GrayLevel image = rough(37, 23);
  for (int step = 0; step <= 128; ++step) {
    std::array<float, 8> u{};
    std::array<float, 8> v{};
    for (int k = 0; k < 8; ++k) {
      u[std::size_t(k)] = float(1 + (7 * step + 5 * k) % 34) + float(step % 128) / 128;
      v[std::size_t(k)] = float(1 + (3 * step + k) % 20) + float((step * 37 + k) % 128) / 128;
    }
    const Sampled samples = sampled(image, u, v);
    for (std::size_t k = 0; k < 8; ++k) {
      const int x = int(u[k]);
      const int y = int(v[k]);
      const double fx = double(u[k]) - x;
      const double fy = double(v[k]) - y;
      const auto mixed = [&](auto at) {
        return between(at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1), fx, fy);
      };
      CAPTURE(step, k);
      CHECK(samples.value[k] == mixed([&](int a, int b) { return double(image.row(b)[a]); }));
      CHECK(samples.gx[k] ==
            mixed([&](int a, int b) { return 0.5 * (image.row(b)[a + 1] - image.row(b)[a - 1]); }));
      CHECK(samples.gy[k] ==
            mixed([&](int a, int b) { return 0.5 * (image.row(b + 1)[a] - image.row(b - 1)[a]); }));
    }
  }
}

TEST_CASE("between these steps the value errs by the step times the slope at most") {
  const GrayLevel image = test::levelOf(40, 10, [](int u, int) { return u < 10 ? 0 : 255; });
  for (float fx = 0; fx < 0.99F; fx += 0.013F) {
    std::array<float, 8> u{};
    u.fill(9 + fx);
    const Sampled samples = sampled(image, u, {4.37F, 4.37F, 4.37F, 4.37F, 4, 4, 5, 5});
    for (const float value : samples.value) CHECK(std::fabs(value - 255 * fx) <= 1);
  }
}

TEST_CASE("eight bilinear values are those of the image, bit by bit") {
  const GrayLevel image = rough(41, 29);
  for (int step = 0; step < 200; ++step) {
    std::array<float, 8> u{};
    std::array<float, 8> v{};
    for (std::size_t k = 0; k < 8; ++k) {
      u[k] = std::fmod(float(step) * 3.713F + float(k) * 5.117F, 39.9F);
      v[k] = std::fmod(float(step) * 1.291F + float(k) * 7.773F, 27.9F);
    }
    const Eight values = bilinear(image, loadEight(u.data()), loadEight(v.data()));
    CAPTURE(step);
    for (std::size_t k = 0; k < 8; ++k) CHECK(values[k] == image.at(u[k], v[k]));
  }
}

TEST_CASE("differences and squared gradient of every inner pixel") {
  const GrayLevel image = rough(21, 9);
  for (int v = 1; v < 8; ++v) {
    for (int u = 1; u < 20; ++u) {
      CAPTURE(u, v);
      const Differences d = differencesAt(image, u, v);
      CHECK(d.gu == image.row(v)[u + 1] - image.row(v)[u - 1]);
      CHECK(d.gv == image.row(v + 1)[u] - image.row(v - 1)[u]);
      CHECK(gradientSquared(image, u, v) == Approx(0.25 * (d.gu * d.gu + d.gv * d.gv)));
    }
  }
}
