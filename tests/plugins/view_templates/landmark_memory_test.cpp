// SPDX-License-Identifier: BSD-3-Clause
// The landmarks of all templates: poses in a scene of boards; damaged states.
#include <catch2/catch.hpp>
#include <sstream>

#include "support/street_scene.hpp"
#include "template_bank.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::view_templates;

namespace {

constexpr const char* kMagic = "TESTMARK";

Frame frameAlong(double z, double yaw = 0) {
  return tolman::test::streetFrame(0, Eigen::Translation3d(0, 0, z) *
                                          Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitY()) *
                                          Eigen::Isometry3d::Identity());
}

LandmarkMemory streetMemory() { return {tolman::test::streetRig(), 400, 12}; }

std::string payloadOf(const LandmarkMemory& memory) {
  StateWriter writer;
  memory.save(writer);
  std::ostringstream stream;
  REQUIRE(writer.write(stream, kMagic, 1).isOk());
  return stream.str().substr(sizeof(detail::StateHeader));
}

/// Whether `memory` takes the bytes, in an envelope whose checksum is right.
bool takes(LandmarkMemory& memory, const std::string& payload) {
  StateWriter writer;
  writer.putAll(std::span<const char>(payload.data(), payload.size()));
  std::ostringstream out;
  REQUIRE(writer.write(out, kMagic, 1).isOk());
  std::istringstream in(out.str());
  auto reader = StateReader::open(in, kMagic, 1);
  REQUIRE(reader.isOk());
  return memory.load(reader.value()) && reader.value().complete();
}

std::optional<landmarks::MeasuredPose> locate(LandmarkMemory& memory, const Frame& frame,
                                              std::int64_t id) {
  landmarks::Agreement agreement;
  auto measured = memory.locate(frame, id, agreement);
  if (measured) CHECK(agreement.agreeing >= agreement.needed);
  return measured;
}

}  // namespace

TEST_CASE("a street seen again is measured, from ahead, from behind and turned") {
  LandmarkMemory memory = streetMemory();
  const Frame first = frameAlong(0);
  memory.beginFrame();
  memory.add(first);
  REQUIRE(memory.hasEnough(0));
  struct Case {
    double z, yaw;
  };
  for (const Case& c : {Case{0, 0}, {0.8, 0}, {-0.8, 0}, {1.5, 0}, {0.4, 0.03}, {0.4, -0.03}}) {
    const Frame now = frameAlong(c.z, c.yaw);
    memory.beginFrame();
    const auto measured = locate(memory, now, 0);
    CAPTURE(c.z, c.yaw);
    REQUIRE(measured);
    const Eigen::Isometry3d& T = measured->T_template_current;
    CHECK((T.translation() - Eigen::Vector3d(0, 0, c.z)).norm() < 0.15);
    CHECK(std::asin(T.linear()(0, 2)) == Approx(c.yaw).margin(0.01));
    CHECK(measured->inliers >= 12);
  }
}

TEST_CASE("another picture is not located, and nothing is kept of the frame before") {
  LandmarkMemory memory = streetMemory();
  memory.beginFrame();
  memory.add(frameAlong(0));
  Frame grey = frameAlong(0);
  grey.left = tolman::test::filled(90);
  memory.beginFrame();
  CHECK_FALSE(locate(memory, grey, 0));
  memory.beginFrame();
  CHECK(locate(memory, frameAlong(0.5), 0));
}

TEST_CASE("without a right image or a calibration a template has no landmarks, but a number") {
  LandmarkMemory memory = streetMemory();
  Frame one_eyed = frameAlong(0);
  one_eyed.right = Image();
  memory.beginFrame();
  memory.add(one_eyed);
  memory.beginFrame();
  memory.add(frameAlong(0));
  CHECK(memory.size() == 2);
  CHECK_FALSE(memory.hasEnough(0));
  CHECK(memory.hasEnough(1));
  memory.beginFrame();
  CHECK_FALSE(locate(memory, frameAlong(0), 0));
  CameraRig uncalibrated = tolman::test::streetRig();
  uncalibrated.calibrated = false;
  CHECK_FALSE(LandmarkMemory(uncalibrated, 400, 12).hasStereo());
  CHECK(streetMemory().hasStereo());
}

TEST_CASE("a loaded memory measures to the bit what the saved one does") {
  LandmarkMemory saved = streetMemory();
  for (const double z : {0.0, 5.0, 9.0}) {
    saved.beginFrame();
    saved.add(frameAlong(z));
  }
  LandmarkMemory loaded = streetMemory();
  REQUIRE(takes(loaded, payloadOf(saved)));
  CHECK(payloadOf(loaded) == payloadOf(saved));
  for (std::int64_t id = 0; id < 3; ++id) {
    const Frame now = frameAlong(5 * static_cast<double>(id) + 0.3);
    saved.beginFrame();
    loaded.beginFrame();
    const auto a = locate(saved, now, id);
    const auto b = locate(loaded, now, id);
    REQUIRE(a.has_value() == b.has_value());
    if (a) CHECK(a->T_template_current.matrix() == b->T_template_current.matrix());
  }
}

TEST_CASE("sizes that the bytes cannot hold are refused without asking for their memory") {
  LandmarkMemory memory = streetMemory();
  memory.beginFrame();
  memory.add(frameAlong(0));
  const std::string sound = payloadOf(memory);
  RandomStream random(6);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string bytes = sound;
    const std::size_t at = i % 3 == 0 ? 0 : (i % 3 == 1 ? 8 : 8 * random.below(bytes.size() / 8));
    const std::uint64_t wild = ~0ULL >> random.below(60);
    std::memcpy(bytes.data() + at, &wild, sizeof wild);
    LandmarkMemory other = streetMemory();
    refused += !takes(other, bytes);
  }
  CHECK(refused >= 190);
  for (std::size_t length = 0; length < sound.size(); length += 97) {
    LandmarkMemory other = streetMemory();
    CHECK_FALSE(takes(other, sound.substr(0, length)));
  }
}
