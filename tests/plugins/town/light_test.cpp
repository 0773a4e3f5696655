// SPDX-License-Identifier: BSD-3-Clause
// Sun, sky and haze; lamps; rain and snow on surfaces.
#include "light.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "material.hpp"

using namespace tolman::town;

TEST_CASE("at noon the sun stands at 90 - latitude + declination; at midnight below ground") {
  const Light noon = makeLight(12, Weather::Clear, 0, 1);
  constexpr double kDegree = std::numbers::pi / 180;
  CHECK(static_cast<double>(noon.to_sun.z) ==
        Approx(std::sin((90 - 49 + 20) * kDegree)).margin(1e-5));
  CHECK(norm(noon.to_sun) == Approx(1).margin(1e-5));
  CHECK(makeLight(0, Weather::Clear, 0, 1).to_sun.z < 0);
  CHECK(makeLight(0, Weather::Clear, 0, 1).sun == 0);
  CHECK(makeLight(9, Weather::Clear, 0, 1).to_sun.z ==
        Approx(makeLight(15, Weather::Clear, 0, 1).to_sun.z).margin(1e-5));
}

TEST_CASE("light falls by the cosine, and shadow leaves the sky") {
  Light light = makeLight(12, Weather::Clear, 0, 1);
  const float towards = light.onto(light.to_sun, 1) - light.onto(light.to_sun, 0);
  CHECK(towards == Approx(light.sun));
  const float up = light.onto({0, 0, 1}, 1) - light.onto({0, 0, 1}, 0);
  CHECK(up == Approx(light.sun * light.to_sun.z).margin(1e-5));
  CHECK(light.onto({0, 0, 1}, 0) > 0.5F * light.sky);
}

TEST_CASE("haze hides what is far and leaves what is near") {
  const Light haze = makeLight(12, Weather::Overcast, 0.02, 1);
  CHECK(std::abs(haze.through(0.1F, 300) - haze.horizon) < 0.01F * haze.horizon);
  CHECK(haze.through(0.1F, 0.1F) == Approx(0.1F).epsilon(0.02));
  CHECK(makeLight(12, Weather::Clear, 0, 1).through(0.1F, 500) == 0.1F);
}

TEST_CASE("the mean of lights has the mean of their numbers") {
  const Light day = makeLight(12, Weather::Clear, 0.001, 3);
  Light night = makeLight(0, Weather::Clear, 0.001, 3);
  makeNight(night);
  CHECK(night.lamps == 1);
  CHECK(night.horizon < 0.1F * day.horizon);
  const Light same = meanOf(std::array{day});
  CHECK(same.sun == day.sun);
  CHECK(same.to_sun.x == day.to_sun.x);
  const Light both = meanOf(std::array{day, day, day, night});
  CHECK(both.sun == Approx(0.75F * day.sun));
  CHECK(both.lamps == Approx(0.25F));
  CHECK(both.haze == Approx(day.haze));
  CHECK(norm(both.to_sun) == Approx(1));
  CHECK(dot(both.to_sun, day.to_sun) > 0.99F);
}

namespace {
constexpr Vec3 kUp = {0, 0, 1};
}

TEST_CASE("below a lamp light falls off with the square of the height") {
  const StreetLamps low({{100, -50, 4}});
  const StreetLamps high({{100, -50, 8}});
  CHECK(low.onto({100, -50, 0}, kUp) == Approx(4 * high.onto({100, -50, 0}, kUp)));
  CHECK(low.onto({100, -50, 0}, {0, 0, -1}) == 0);
  CHECK(low.onto({110, -50, 0}, kUp) < low.onto({105, -50, 0}, kUp));
  CHECK(low.onto({131, -50, 0}, kUp) == 0);
}

TEST_CASE("lamps add up, also across cells, and shine themselves") {
  std::vector<Vec3> heads;
  float sum = 0;
  const Vec3 point = {0.5F, 0.5F, 0};
  for (int i = 0; i < 8; ++i) {
    heads.push_back({static_cast<float>(i * 9 - 36), static_cast<float>(i % 3 * 8 - 8), 5});
    sum += StreetLamps({heads.back()}).onto(point, kUp);
  }
  const StreetLamps lamps(heads);
  CHECK(lamps.onto(point, kUp) == Approx(sum));
  CHECK(lamps.isHead(heads[3]));
  CHECK_FALSE(lamps.isHead({heads[3].x, heads[3].y, 4}));
  CHECK(StreetLamps().onto(point, kUp) == 0);
  CHECK_FALSE(StreetLamps().isHead(point));
}

TEST_CASE("low beams light what is ahead, below the horizon, and faces the car") {
  const Headlights beams = {{0, 0, 0.7F}, {0, 1, 0}};
  const Vec3 to_car = {0, -1, 0};
  const float ahead = headlightsOnto(beams, {0, 15, 0.3F}, to_car);
  CHECK(ahead > 0.1F);
  CHECK(headlightsOnto(beams, {0, 30, 0.3F}, to_car) < ahead);
  CHECK(headlightsOnto(beams, {0, 15, 3}, to_car) < 0.2F * ahead);
  CHECK(headlightsOnto(beams, {12, 15, 0.3F}, to_car) < 0.3F * ahead);
  CHECK(headlightsOnto(beams, {12, 15, 0.3F}, to_car) ==
        Approx(headlightsOnto(beams, {-12, 15, 0.3F}, to_car)));
  CHECK(headlightsOnto(beams, {0, -15, 0.3F}, {0, 1, 0}) == 0);
  CHECK(headlightsOnto(beams, {0, 15, 0.3F}, {0, 1, 0}) == 0);
}

namespace {

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
