// SPDX-License-Identifier: BSD-3-Clause
// Sun and sky: the direction of the sun, illumination, extinction by haze.
#include "light.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

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

TEST_CASE("fog hides what is far and leaves what is near") {
  const Light fog = makeLight(12, Weather::Fog, 0, 1);
  CHECK(fog.sun == 0);
  CHECK(std::abs(fog.through(0.1F, 300) - fog.horizon) < 0.01F * fog.horizon);
  CHECK(fog.through(0.1F, 0.1F) == Approx(0.1F).epsilon(0.02));
  const Light clear = makeLight(12, Weather::Clear, 0, 1);
  CHECK(clear.through(0.1F, 500) == 0.1F);
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

TEST_CASE("cameras expose by the light on the road, lamps and snow included") {
  Light light = makeLight(10, Weather::Clear, 0, 3);
  CHECK(light.level() == light.onto({0, 0, 1}, 1));
  const float plain = light.level();
  light.snow = 1;
  CHECK(light.level() > 1.5F * plain);
  makeNight(light);
  CHECK(light.level() > 5 * light.sky);
}
