// SPDX-License-Identifier: BSD-3-Clause
// Patterns and albedos, averaged over the pixel as the mean of many small pixels would be.
#include "material.hpp"

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "drawn_route.hpp"
#include "lanes.hpp"
#include "tolman/context.hpp"

using namespace tolman::town;
using namespace tolman;

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

namespace {

constexpr std::array<Material, 12> kMaterials = {
    Material::Road,   Material::Kerb, Material::Land,  Material::Paint,
    Material::Facade, Material::Roof, Material::Plain, Material::Wood,
    Material::Leaves, Material::Bark, Material::Body,  Material::Board};

/// With a street whose middle is 1.7 m left of the origin, so that x leads off it.
const StreetPlan& thePlan() {
  static const StreetPlan plan = StreetPlan::grow(town::test::builtIn("block"), 1.65).value();
  return plan;
}

/// A surface in the plane of x and z (walls) or x and y (ground), 12 m by 6 m.
struct Sheet {
  Surface surface;
  Vec3 axis_v;
  Vec3 normal;

  Sheet(Material material, std::uint32_t seed) {
    const bool ground = material == Material::Road || material == Material::Land ||
                        material == Material::Paint || material == Material::Kerb;
    axis_v = ground ? Vec3{0, 1, 0} : Vec3{0, 0, 1};
    normal = ground ? Vec3{0, 0, 1} : Vec3{0, -1, 0};
    surface.material = material;
    surface.seed = seed;
    surface.tone = material == Material::Leaves ? 0.2F : 0.3F;  // as large as plants have it
    surface.axis_v = axis_v;
    surface.width = 12;
    surface.height = 6;
  }
  /// Seen by a square pixel of `size` m.
  float at(float u, float v, float size) const {
    Eight result;
    albedos(surface, hitsAt(u, v, size), thePlan(), result);
    return result[0];
  }
  /// The same point eight times.
  SurfaceHits hitsAt(float u, float v, float size) const {
    return {vec3s(Vec3{u, 0, 0} + axis_v * v), vec3s(normal), vec3s({size, 0, 0}),
            vec3s(axis_v * size), surface.seed - EightWords{}};
  }
  /// The same square as the mean of n^2 small pixels.
  float meanOf(float u, float v, float size, int n) const {
    const float step = size / static_cast<float>(n);
    const float first = 0.5F * step - 0.5F * size;
    float sum = 0;
    for (int i = 0; i < n; ++i) {
      for (int j = 0; j < n; ++j) {
        sum += at(u + first + static_cast<float>(i) * step,
                  v + first + static_cast<float>(j) * step, step);
      }
    }
    return sum / static_cast<float>(n * n);
  }
};

float draw(RandomStream& random, double low, double high) {
  return static_cast<float>(random.uniform(low, high));
}

}  // namespace

TEST_CASE("no surface swallows or makes light, from whatever distance") {
  RandomStream random(3);
  for (const Material material : kMaterials) {
    for (int i = 0; i < 3000; ++i) {
      const Sheet sheet(material, static_cast<std::uint32_t>(i));
      const float size = std::pow(10.0F, draw(random, -3, 1));
      const float value = sheet.at(draw(random, -40, 40), draw(random, -5, 30), size);
      CAPTURE(static_cast<int>(material), i, size, value);
      REQUIRE(value > 0);
      REQUIRE(value < 1);
    }
  }
}

TEST_CASE("eight points look as each of them does alone") {
  RandomStream random(7);
  for (const Material material : kMaterials) {
    for (int i = 0; i < 300; ++i) {
      const Sheet sheet(material, static_cast<std::uint32_t>(i));
      SurfaceHits hits = sheet.hitsAt(0, 0, 1);
      std::array<float, kLanes> alone{};
      for (int k = 0; k < kLanes; ++k) {
        const float size = std::pow(10.0F, draw(random, -3, 1));
        const SurfaceHits one = sheet.hitsAt(draw(random, -9, 20), draw(random, -1, 9), size);
        Eight value;
        albedos(sheet.surface, one, thePlan(), value);
        alone[static_cast<std::size_t>(k)] = value[0];
        hits.point.x[k] = one.point.x[0];
        hits.point.y[k] = one.point.y[0];
        hits.point.z[k] = one.point.z[0];
        hits.dx.x[k] = one.dx.x[0];
        hits.dy.y[k] = one.dy.y[0];
        hits.dy.z[k] = one.dy.z[0];
      }
      Eight together;
      albedos(sheet.surface, hits, thePlan(), together);
      for (int k = 0; k < kLanes; ++k) {
        CAPTURE(static_cast<int>(material), i, k);
        REQUIRE(together[k] == alone[static_cast<std::size_t>(k)]);
      }
    }
  }
}

// A texture that is sampled instead of averaged shimmers: seen from afar it would keep the contrast
// of single points.
TEST_CASE("a wide pixel sees about the mean of the small ones that it covers") {
  RandomStream random(5);
  for (const Material material : kMaterials) {
    constexpr int kCount = 400;
    constexpr float kWide = 0.5F;  // m
    double error = 0;
    double mean = 0;
    double fine_mean = 0;
    double squares = 0;
    double squared_error = 0;
    for (int i = 0; i < kCount; ++i) {
      const Sheet sheet(material, static_cast<std::uint32_t>(i % 5));
      const float u = draw(random, 0.5, 11.5);
      const float v = draw(random, 0.5, 5.5);
      const auto fine = static_cast<double>(sheet.meanOf(u, v, kWide, 10)) / kCount;
      const auto coarse = static_cast<double>(sheet.at(u, v, kWide)) / kCount;
      const auto point = static_cast<double>(sheet.at(u, v, 1e-3F)) / kCount;
      error += coarse - fine;
      squared_error += kCount * (coarse - fine) * (coarse - fine);
      squares += kCount * point * point;
      mean += point;
      fine_mean += fine;
    }
    const double contrast = std::sqrt(squares - mean * mean);
    CAPTURE(static_cast<int>(material), std::sqrt(squared_error), contrast, error, fine_mean);
    CHECK(std::sqrt(squared_error) < 0.7 * contrast);
    // Leaves lose their gaps and highlights unequally: up to a fifth of their brightness.
    CHECK(std::abs(error) < (material == Material::Leaves ? 0.2 : 0.1) * fine_mean);
  }
}
