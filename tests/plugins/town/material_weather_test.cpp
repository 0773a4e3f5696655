// SPDX-License-Identifier: BSD-3-Clause
#include "material_weather.hpp"

#include <catch2/catch.hpp>

using namespace tolman::town;

namespace {

constexpr Vec3 kUp = {0, 0, 1};

Surface of(Material material) {
  Surface surface;
  surface.material = material;
  return surface;
}

/// Mean over a field of points.
template <class Value>
float mean(Value&& value) {
  float sum = 0;
  for (int i = 0; i < 2500; ++i) {
    sum += value(Vec3{static_cast<float>(i % 50) * 0.71F, static_cast<float>(i) * 0.0131F, 0});
  }
  return sum / 2500;
}

}  // namespace

TEST_CASE("rain darkens the ground and leaves walls") {
  Light wet;
  wet.wet = 1;
  const StreetPlan plan;
  const auto seen = [&](Material material, const Light& light) {
    return mean([&](const Vec3& p) {
      return weatheredAlbedo(0.3F, of(material), p, kUp, 0.01F, light, plan);
    });
  };
  CHECK(seen(Material::Road, wet) < 0.7F * 0.3F);
  CHECK(seen(Material::Facade, wet) == Approx(0.3F).epsilon(1e-3));
  CHECK(seen(Material::Road, Light{}) == Approx(0.3F).epsilon(1e-3));
}

TEST_CASE("snow lies on what faces upwards, less in the tracks of the road") {
  Light snow;
  snow.snow = 1;
  const StreetPlan plan;  // everything is on a centreline
  const auto albedo = [&](Material material, const Vec3& normal) {
    return mean([&](const Vec3& p) {
      return weatheredAlbedo(0.2F, of(material), p, normal, 0.01F, snow, plan);
    });
  };
  CHECK(albedo(Material::Land, kUp) == Approx(0.72).epsilon(0.1));
  CHECK(albedo(Material::Roof, normalised({0.5F, 0, 1})) > 0.6F);
  CHECK(albedo(Material::Facade, {1, 0, 0}) == Approx(0.2F).epsilon(1e-3));
  CHECK(albedo(Material::Leaves, kUp) < albedo(Material::Land, kUp));
  CHECK(albedo(Material::Road, kUp) > 0.5F);  // between the tracks
}

TEST_CASE("wet ground mirrors at grazing angles, dry ground and walls never") {
  Light wet;
  wet.wet = 1;
  const auto share = [&](Material material, const Vec3& way, const Light& light) {
    return mean(
        [&](const Vec3& p) { return mirroredShare(of(material), p, kUp, normalised(way), light); });
  };
  const float grazing = share(Material::Road, {0, 1, -0.05F}, wet);
  CHECK(grazing > 4 * share(Material::Road, {0, 1, -1}, wet));
  CHECK(grazing < 1);
  CHECK(share(Material::Road, {0, 1, -0.05F}, Light{}) == 0);
  CHECK(share(Material::Facade, {0, 1, -0.05F}, wet) == 0);
  CHECK(mirroredShare(of(Material::Kerb), {0, 0, 0}, {1, 0, 0}, {-1, 0, 0}, wet) == 0);
}
