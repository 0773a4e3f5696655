// SPDX-License-Identifier: BSD-3-Clause
// Saved templates and landmarks with a valid envelope and wrong numbers: refused, or used without
// invalid answers.
#include <catch2/catch.hpp>
#include <cstring>
#include <limits>
#include <sstream>

#include "harness.hpp"
#include "support/saved_payload.hpp"
#include "support/street_scene.hpp"
#include "tolman/state_stream.hpp"

using namespace tolman;
using namespace tolman::view_templates;

namespace {

constexpr std::size_t kHeader = sizeof(detail::StateHeader);

/// Small templates with landmarks in a street.
struct Street {
  Street()
      : services({{"columns", std::int64_t{24}},
                  {"rows", std::int64_t{6}},
                  {"threshold", 0.03},
                  {"landmarks", std::int64_t{60}}}) {
    services.rig = tolman::test::streetRig();
    const Status status = plugin.configure(services);
    INFO(status.message());
    REQUIRE(status.isOk());
  }
  PlaceObservation observe(const Frame& frame) {
    PlaceObservation observation;
    const Status status = plugin.observe(frame, nullptr, observation);
    INFO(status.message());
    REQUIRE(status.isOk());
    return observation;
  }
  Status load(const std::string& envelope, const std::string& payload) {
    std::uint64_t version = 0;
    std::memcpy(&version, envelope.data() + 8, sizeof version);
    return tolman::test::loadPayload(plugin, "TLMVIEWS", version, payload);
  }

  tolman::test::TestContext services;
  ViewTemplates plugin;
};

Frame streetAt(std::int64_t index, double z) {
  return tolman::test::streetFrame(index, Eigen::Isometry3d(Eigen::Translation3d(0, 0, z)));
}

std::string saved() {
  Street street;
  for (std::int64_t i = 0; i < 3; ++i) street.observe(streetAt(i, 6.0 * static_cast<double>(i)));
  std::ostringstream stream;
  REQUIRE(street.plugin.save(stream).isOk());
  return stream.str();
}

}  // namespace

TEST_CASE("a state of any other length is refused, and the instance is as after reset") {
  const std::string state = saved();
  const std::string payload = state.substr(kHeader);
  const Frame first = streetAt(0, 0);
  for (std::size_t length = 0; length < payload.size(); length += 173) {
    Street street;
    CAPTURE(length);
    REQUIRE(street.load(state, payload.substr(0, length)).code() == StatusCode::InvalidInput);
    if (length % 4 == 0) CHECK(street.observe(first).template_id == 0);
  }
  Street street;
  CHECK(street.load(state, payload + '\0').message() == "the saved state is damaged: wrong length");
  CHECK(street.load(state, payload).isOk());
}

TEST_CASE("wild numbers in templates and landmarks never become an answer with NaN") {
  const std::string state = saved();
  const std::string payload = state.substr(kHeader);
  const Frame again = streetAt(3, 0.4);
  RandomStream random(4);
  int refused = 0;
  int located = 0;
  for (int i = 0; i < 120; ++i) {
    std::string bytes = payload;
    const float wild = i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                  : (i % 3 == 1 ? std::numeric_limits<float>::infinity() : -1e30F);
    for (int k = 0; k < 6; ++k) {
      const std::size_t at = 4 * random.below(bytes.size() / 4);
      std::memcpy(bytes.data() + at, &wild, sizeof wild);
    }
    Street street;
    if (!street.load(state, bytes).isOk()) {
      ++refused;
      continue;
    }
    const PlaceObservation seen = street.observe(again);
    CAPTURE(i, seen.template_id);
    REQUIRE(firstInvalidField(seen).empty());
    located += seen.has_relative_pose;
  }
  CHECK(refused > 5);
  CHECK(located > 20);
}
