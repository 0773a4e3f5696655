// SPDX-License-Identifier: BSD-3-Clause
// A plugin that was built against the headers of SDK 0.1 is loaded by the present host, and by a
// host compiled from the same source against changed headers, as of a later version (the changes
// are listed in CMakeLists.txt).
#include <catch2/catch.hpp>
#include <sstream>

#include "host/fixture_plugins.hpp"
#include "host/stages.hpp"
#include "support/context.hpp"

using namespace tolman;
using namespace tolman::host;

namespace {

Manifest walkerManifest() {
  const auto manifests = readManifests(test::fixtureFile("walker"));
  REQUIRE(std::holds_alternative<std::vector<Manifest>>(manifests));
  return std::get<std::vector<Manifest>>(manifests).at(0);
}

OdometryStage walker() {
  const auto loaded = loadPlugin(walkerManifest(), HostIdentity::ofThisBuild());
  if (const auto* refusal = std::get_if<Refusal>(&loaded)) FAIL(refusal->text());
  auto created = Instance::create(std::get<LoadedPlugin>(loaded), "odometry");
  REQUIRE(std::holds_alternative<std::unique_ptr<Instance>>(created));
  return OdometryStage(std::move(std::get<std::unique_ptr<Instance>>(created)));
}

Frame frameAt(std::int64_t index) {
  Frame frame;
  frame.frame = index;
  frame.stamp_ns = index * 100'000'000;
  frame.sensors.resize(7);  // the last field of SDK 0.1
  return frame;
}

Motion track(OdometryStage& odometry, std::int64_t index) {
  Motion motion;
  const Status status = odometry.track(frameAt(index), motion);
  INFO(status.message());
  REQUIRE(status.isOk());
  return motion;
}

}  // namespace

TEST_CASE("the host of " TOLMAN_HOST_OF " has the layout that this test is about") {
  const auto extras = sizeof(PluginObject) / sizeof(void*) - 1;
  CHECK(extras == TOLMAN_HOST_EXTRAS);
  CHECK(walkerManifest().sdk_major == TOLMAN_SDK_MAJOR);
}

TEST_CASE("a plugin of SDK 0.1 runs in the host of " TOLMAN_HOST_OF) {
  OdometryStage odometry = walker();
  test::TestContext context({{"step", 2.0}});
  context.quiet = true;
  REQUIRE(odometry.instance().configure(context).isOk());
  CHECK(context.log == std::vector<std::string>{"test walks quietly"});
  for (std::int64_t k = 0; k < 6; ++k) {
    const Motion motion = track(odometry, k);
    CHECK(motion.tracked == 7);
    CHECK(motion.v == Approx(k == 0 ? 0 : 20));
    CHECK(motion.revisions.size() == (k == 0 ? 0 : 1));
  }
  std::vector<MotionRevision> revisions;
  CHECK(odometry.finish(revisions).isOk());
}

TEST_CASE("its extras of SDK 0.1 are found in the host of " TOLMAN_HOST_OF) {
  OdometryStage odometry = walker();
  test::TestContext context({{"step", 0.5}});
  REQUIRE(odometry.instance().configure(context).isOk());
  for (std::int64_t k = 0; k < 4; ++k) track(odometry, k);
  std::vector<NamedArray> arrays;
  REQUIRE(odometry.instance().arrays(3, arrays).isOk());
  REQUIRE(arrays.size() == 1);
  CHECK(arrays[0].values == std::vector<float>{1.5F});

  std::stringstream saved;
  REQUIRE(odometry.instance().state() != nullptr);
  REQUIRE(odometry.instance().state()->save(saved).isOk());
  CHECK(saved.str() == "1.5");
  std::istringstream damaged("x");
  CHECK(odometry.instance().state()->load(damaged).code() == StatusCode::InvalidInput);
}

TEST_CASE("the next major refuses it, says why and what to do") {
  HostIdentity next = HostIdentity::ofThisBuild();
  next.sdk_major += 1;
  next.sdk_minor = 0;
  const auto result = loadPlugin(walkerManifest(), next);
  REQUIRE(std::holds_alternative<Refusal>(result));
  CHECK(std::get<Refusal>(result).text() ==
        "[plugin/sdk-major] plugin 'walker' (" + test::fixtureFile("walker").string() +
            ") was built for SDK 0.1; this host has SDK " + std::to_string(next.sdk_major) +
            ".0\n"
            "  remedy: rebuild the plugin against this SDK; docs/stability.md lists what changed");
}
