// SPDX-License-Identifier: BSD-3-Clause
// The plugin: answers, parameters, determinism.
#include "view_templates.hpp"

#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::view_templates;
using namespace tolman::view_templates::test;

namespace {

/// Columns of brightness; `kind` selects one of many unlike scenes.
Image scene(int kind, int add = 0) {
  RandomStream random(static_cast<std::uint64_t>(kind) + 100);
  std::vector<int> stripes;
  for (int i = 0; i < 40; ++i) stripes.push_back(static_cast<int>(random.below(200)));
  return gray(320, 96, [&](int x, int y) {
    return stripes[static_cast<std::size_t>(x / 8)] / 2 + y / 4 + add;
  });
}

ParameterValues plain() {
  return {{"normalisation", 0.0},
          {"threshold", 0.05},
          {"columns", std::int64_t{40}},
          {"crop", std::vector<double>{0, 1, 50.0 / 376, 300.0 / 376}}};
}

}  // namespace

TEST_CASE("ids have no gaps, and an old view is familiar") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, plain()).isOk());
  for (int kind = 0; kind < 20; ++kind) {
    const PlaceObservation seen = observe(plugin, scene(kind), kind);
    CHECK(seen.recognition == Recognition::Novel);
    CHECK(seen.template_id == kind);
    CHECK(seen.frame == kind);
    CHECK(seen.stamp_ns == 1000 * kind);
    CHECK(seen.relative_yaw == 0);
  }
  for (int kind = 19; kind >= 0; --kind) {
    const PlaceObservation seen = observe(plugin, scene(kind));
    CHECK(seen.recognition == Recognition::Familiar);
    CHECK(seen.template_id == kind);
    CHECK(seen.score == 0);
    CHECK(seen.relative_yaw == Approx(0).margin(0.002));  // interpolated between cells of 0.044
    CHECK_FALSE(seen.has_relative_pose);
  }
}

TEST_CASE("the threshold is on the mean absolute difference") {
  // Twelve grey levels more everywhere: a distance of 12/255 = 0.0471.
  for (const auto& [threshold, expected] :
       {std::pair{0.0465, Recognition::Novel}, std::pair{0.0475, Recognition::Familiar}}) {
    ViewTemplates plugin;
    ParameterValues parameters = plain();
    parameters["threshold"] = threshold;
    REQUIRE(configure(plugin, parameters).isOk());
    observe(plugin, scene(0));
    const PlaceObservation seen = observe(plugin, scene(0, 12), 1);
    CHECK(seen.recognition == expected);
    CHECK(seen.score == Approx(12.0 / 255).margin(1e-4));
  }
}

TEST_CASE("normalisation makes brightness not matter") {
  for (const auto& [name, value] : {std::pair<std::string, ParameterValue>{"normalisation", 0.4},
                                    {"patch_radius", std::int64_t{3}}}) {
    ViewTemplates plugin;
    ParameterValues parameters = plain();
    parameters[name] = value;
    REQUIRE(configure(plugin, parameters).isOk());
    const Image bright = scene(0);
    const Image dark = gray(320, 96, [&](int x, int y) { return bright.row(y)[x] / 2; });
    observe(plugin, bright);
    CHECK(observe(plugin, dark, 1).recognition == Recognition::Familiar);
  }
}

TEST_CASE("an empty image is no news and leaves no trace") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, plain()).isOk());
  const PlaceObservation seen = observe(plugin, Image(), 3);
  CHECK(seen.recognition == Recognition::None);
  CHECK(seen.template_id == -1);
  CHECK(seen.frame == 3);
  CHECK(observe(plugin, scene(0), 4).template_id == 0);
}

TEST_CASE("grey and equal-channel colour are the same view") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, plain()).isOk());
  const Image grey = scene(1);
  const Image colour = tolman::test::coloured(grey);
  observe(plugin, grey);
  CHECK(observe(plugin, colour, 1).score == 0);
}

TEST_CASE("bad parameters are refused with the remedy") {
  ViewTemplates plugin;
  CHECK(configure(plugin, {{"shift", std::int64_t{30}}}).message() ==
        "a shift of 30 cells to both sides leaves none of 60 columns to compare; lower `shift`");
  CHECK(configure(plugin, {{"crop", std::vector{0.95, 0.9, 0.0, 1.0}}}).message() ==
        "the crop is empty: give [left, right, upper, lower] with left < right and upper < lower");
}

TEST_CASE("a rig whose images are too small is refused before the first frame") {
  ViewTemplates plugin;
  tolman::test::TestContext services;
  services.rig.width = 16;
  services.rig.height = 8;
  const Status refused = plugin.configure(services);
  CHECK(refused.code() == StatusCode::InvalidParameter);
  CHECK(refused.message().find("the crop of the 16x8 image has 14x5 pixels, too few") == 0);
  services.rig.width = 160;
  services.rig.height = 60;
  CHECK(plugin.configure(services).isOk());
}

TEST_CASE("small images work with the defaults") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {}).isOk());
  RandomStream random(9);
  CHECK(observe(plugin, noise(160, 120, random)).recognition == Recognition::Novel);
}

TEST_CASE("after reset the same frames give the same answers, bit by bit") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, {{"patch_radius", std::int64_t{2}}, {"threshold", 0.2}}).isOk());
  const auto drive = [&] {
    RandomStream random(10);
    std::vector<double> answers;
    for (int i = 0; i < 40; ++i) {
      const PlaceObservation seen = observe(plugin, noise(160, 120, random), i);
      answers.insert(answers.end(),
                     {static_cast<double>(seen.template_id), seen.score, seen.relative_yaw});
    }
    return answers;
  };
  const std::vector<double> first = drive();
  REQUIRE(plugin.reset().isOk());
  CHECK(drive() == first);
}

TEST_CASE("the current view and its template are offered as arrays") {
  ViewTemplates plugin;
  REQUIRE(configure(plugin, plain()).isOk());
  std::vector<NamedArray> arrays;
  plugin.arrays(arrays);  // before the first frame: zeros of the same shape
  observe(plugin, scene(2));
  plugin.arrays(arrays);
  REQUIRE(arrays.size() == 4);
  CHECK(arrays[0].values == std::vector<float>(400, 0.0F));
  CHECK(arrays[2].name == "view.current");
  CHECK(arrays[3].name == "view.template");
  CHECK(arrays[3].shape == std::vector<int>{10, 40});
  for (std::size_t i = 0; i < 400; ++i) {
    CHECK(arrays[2].values[i] == Approx(arrays[3].values[i]).margin(1.0 / kOne));
  }
}
