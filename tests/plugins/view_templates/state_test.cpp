// SPDX-License-Identifier: BSD-3-Clause
// Saved templates: the round trip, and every kind of damage refused.
#include <catch2/catch.hpp>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

std::string stateAfter(ViewTemplates& plugin, int frames) {
  RandomStream random(20);
  for (int i = 0; i < frames; ++i) observe(plugin, noise(160, 120, random), i);
  std::ostringstream stream;
  REQUIRE(plugin.save(stream).isOk());
  return stream.str();
}

Status loadText(ViewTemplates& plugin, const std::string& text) {
  std::istringstream stream(text);
  return plugin.load(stream);
}

}  // namespace

TEST_CASE("a loaded instance answers as the saved one would") {
  ViewTemplates saved;
  ViewTemplates loaded;
  const ParameterValues parameters = {{"threshold", 0.03}};
  REQUIRE(configure(saved, parameters).isOk());
  REQUIRE(configure(loaded, parameters).isOk());
  REQUIRE(loadText(loaded, stateAfter(saved, 30)).isOk());
  RandomStream random(20);  // the first 30 are familiar, the others novel
  for (int i = 0; i < 40; ++i) {
    const Image image = noise(160, 120, random);
    const PlaceObservation a = observe(saved, image, i);
    const PlaceObservation b = observe(loaded, image, i);
    CHECK(a.template_id == b.template_id);
    CHECK(a.recognition == b.recognition);
    CHECK(a.score == b.score);
    CHECK((i >= 30 || a.recognition == Recognition::Familiar));
  }
}

TEST_CASE("a state ends where it ends: two can follow one another") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {}).isOk());
  const std::string text = stateAfter(plugin, 3);
  std::istringstream stream(text + "next");
  REQUIRE(plugin.load(stream).isOk());
  std::string rest;
  stream >> rest;
  CHECK(rest == "next");
}

TEST_CASE("damage is found, and the instance is as after reset") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {{"threshold", 0.03}}).isOk());
  const std::string good = stateAfter(plugin, 5);
  for (std::size_t position = 0; position < good.size(); position += 331) {
    std::string bad = good;
    bad[position] = static_cast<char>(bad[position] ^ 0x10);
    CHECK(loadText(plugin, bad).code() == StatusCode::InvalidInput);
  }
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, std::size_t{40}, good.size() / 2, good.size() - 1}) {
    CHECK(loadText(plugin, good.substr(0, length)).code() == StatusCode::InvalidInput);
  }
  RandomStream random(21);
  CHECK(observe(plugin, noise(160, 120, random)).template_id == 0);
  CHECK(loadText(plugin, "something else entirely, long enough to be a header").message() ==
        "this is not a saved state of 'TLMVIEWS'");
}

TEST_CASE("templates of another recipe are refused") {
  ViewTemplates saved;
  ViewTemplates other;
  REQUIRE(configure(saved, {}).isOk());
  REQUIRE(configure(other, {{"normalisation", 0.5}}).isOk());
  CHECK(loadText(other, stateAfter(saved, 2)).message() ==
        "the saved templates were made with other parameters (columns, rows, cells, crop, "
        "normalisation, patch, landmarks)");
}
