// SPDX-License-Identifier: BSD-3-Clause
// Saved states of the plugin: continued at any frame, damaged, of other parameters, and with
// landmarks without space for them.
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>
#include <map>

#include "support/data.hpp"
#include "support/environment.hpp"
#include "support/saved_payload.hpp"
#include "support/street_scene.hpp"
#include "tour.hpp"

using namespace tolman;
using namespace tolman::view_sequences;
using namespace tolman::view_sequences::test;

namespace {

constexpr const char* kMagic = "TLMVSEQS";

std::uint64_t versionOf(const std::string& state) {
  std::uint64_t version = 0;
  std::memcpy(&version, state.data() + 8, sizeof version);
  return version;
}

std::string payloadOf(const std::string& state) {
  return state.substr(sizeof(detail::StateHeader));
}

bool areSame(const PlaceObservation& a, const PlaceObservation& b) {
  return a.recognition == b.recognition && a.template_id == b.template_id && a.score == b.score &&
         a.relative_yaw == b.relative_yaw && a.has_relative_pose == b.has_relative_pose &&
         a.T_template_current.matrix() == b.T_template_current.matrix() &&
         a.covariance == b.covariance;
}

/// Frame `i` of a drive with standing still, blank pictures, and a second lap after a restart.
PlaceObservation frameOf(Tour& tour, int i) {
  const auto stands = [](int k) { return k % 17 < 2; };
  const int start = i < 70 ? 0 : 70;
  int place = 0;
  for (int k = start + 1; k <= i; ++k) place += stands(k) ? 0 : 1;
  const Image picture = i % 23 == 5 ? Image() : placePicture(place, std::uint64_t(i));
  return tour.drive(picture, stands(i) ? 0 : 1, i == start);
}

CameraRig rig() { return tolman::test::streetRig(); }

ParameterValues withLandmarks() { return {{"spacing", 0.5}, {"landmarks", std::int64_t{300}}}; }

/// The street at `z` m, rendered once.
const Frame& streetAt(double z) {
  static std::map<double, Frame> rendered;
  const auto found = rendered.find(z);
  if (found != rendered.end()) return found->second;
  return rendered[z] =
             tolman::test::streetFrame(0, Eigen::Isometry3d(Eigen::Translation3d(0, 0, z)));
}

/// 20 m along the street.
void driveStreet(Tour& tour) {
  for (int i = 0; i < 40; ++i) tour.drive(streetAt(0.5 * i), 0.5, i == 0);
}

std::string streetState() {
  static const std::string state = [] {
    Tour tour(withLandmarks(), rig());
    driveStreet(tour);
    return tour.saved();
  }();
  return state;
}

}  // namespace

TEST_CASE("a drive that is continued from a state at any frame is the whole drive, to the bit") {
  constexpr int kFrames = 140;
  Tour whole(bold());
  std::vector<std::string> states;
  std::vector<PlaceObservation> answers;
  int familiar = 0;
  for (int i = 0; i < kFrames; ++i) {
    states.push_back(whole.saved());
    answers.push_back(frameOf(whole, i));
    familiar += answers.back().recognition == Recognition::Familiar ? 1 : 0;
  }
  REQUIRE(familiar > 30);
  for (int begin = 0; begin < kFrames; ++begin) {
    Tour continued(bold());
    frameOf(continued, 0);  // forgotten
    REQUIRE(continued.load(states[std::size_t(begin)]).isOk());
    continued.continueAt(begin);
    CAPTURE(begin);
    REQUIRE(continued.saved() == states[std::size_t(begin)]);
    // Frame by frame suffices: each next state is the whole drive's.
    REQUIRE(areSame(frameOf(continued, begin), answers[std::size_t(begin)]));
    const auto next = std::size_t(begin) + 1;
    REQUIRE(continued.saved() == (next < states.size() ? states[next] : whole.saved()));
  }
}

TEST_CASE("landmarks continue to the bit as well, and measure where the robot is") {
  Tour saved(withLandmarks(), rig());
  driveStreet(saved);
  Tour loaded(withLandmarks(), rig());
  REQUIRE(loaded.load(saved.saved()).isOk());
  loaded.continueAt(saved.frames());
  int measured = 0;
  for (int i = 0; i < 36; ++i) {
    const Frame& frame = streetAt(0.5 * i + 0.2);
    const auto a = saved.drive(frame, 0.5, i == 0);
    const auto b = loaded.drive(frame, 0.5, i == 0);
    REQUIRE(areSame(a, b));
    if (!a.has_relative_pose) continue;
    ++measured;
    const double expected = 0.5 * i + 0.2 - 0.5 * static_cast<double>(a.template_id);
    const Eigen::Vector3d error =
        a.T_template_current.translation() - Eigen::Vector3d(0, 0, expected);
    CAPTURE(i, a.template_id);
    CHECK(error.norm() < 0.2);
    CHECK(a.relative_yaw == Approx(0).margin(0.01));
  }
  CHECK(measured >= 4);
  CHECK(saved.saved() == loaded.saved());
}

TEST_CASE("states of other parameters are refused with the reason") {
  const std::string state = streetState();
  const std::string wanted =
      "the saved views were made with another spacing, memory or number of landmarks";
  for (const auto& [name, value] : {std::pair<std::string, ParameterValue>{"spacing", 0.6},
                                    {"memory", 0.5},
                                    {"landmarks", std::int64_t{0}},
                                    {"landmarks", std::int64_t{301}}}) {
    ParameterValues parameters = withLandmarks();
    parameters[name] = value;
    Tour other(parameters, rig());
    const Status status = other.load(state);
    CHECK(status.code() == StatusCode::InvalidInput);
    CHECK(status.message() == wanted);
    CHECK(other.drive(streetAt(0), 0, true).template_id == 0);
  }
  ParameterValues parameters = withLandmarks();  // these only decide about answers
  parameters["probability"] = 0.5;
  parameters["exhaustive"] = std::int64_t{0};
  Tour other(parameters, rig());
  CHECK(other.load(state).isOk());
}

TEST_CASE("damage is found, and the instance is as after reset") {
  const std::string good = streetState();
  const std::string payload = payloadOf(good);
  Tour tour(withLandmarks(), rig());
  const auto refusal = [&](const Status& status) {
    CHECK(status.code() == StatusCode::InvalidInput);
    return status.message();
  };
  for (std::size_t at = 0; at < good.size(); at += 5003) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 0x10);
    CHECK_FALSE(refusal(tour.load(bad)).empty());
  }
  for (std::size_t length = 24; length < payload.size(); length += 4001) {
    CAPTURE(length);
    const std::string message = refusal(tolman::test::loadPayload(
        tour.plugin(), kMagic, versionOf(good), payload.substr(0, length)));
    const bool named =
        message == "the saved state is damaged" || message == "the landmarks are damaged";
    CHECK(named);
  }
  CHECK(refusal(tolman::test::loadPayload(tour.plugin(), kMagic, versionOf(good),
                                          payload + '\0')) == "the saved state is damaged");
  CHECK(refusal(tour.load("something else entirely, long enough to be a header")) ==
        "this is not a saved state of 'TLMVSEQS'");
  CHECK(tour.drive(streetAt(0), 0, true).template_id == 0);
}

TEST_CASE("wild numbers in a state are refused or never become an answer with NaN") {
  const std::string good = streetState();
  const std::string payload = payloadOf(good);
  RandomStream random(4);
  int refused = 0;
  for (int i = 0; i < 150; ++i) {
    std::string bytes = payload;
    const float wild = i % 3 == 0 ? std::numeric_limits<float>::quiet_NaN()
                                  : (i % 3 == 1 ? std::numeric_limits<float>::infinity() : -1e30F);
    // The numbers of path and mean, then any, then the end.
    const std::size_t places[] = {24 + 4 * random.below(600), 4 * random.below(bytes.size() / 4),
                                  bytes.size() - 336 + 4 * random.below(83)};
    std::memcpy(bytes.data() + places[i % 4 % 3], &wild, sizeof wild);
    Tour tour(withLandmarks(), rig());
    const Status status = tolman::test::loadPayload(tour.plugin(), kMagic, versionOf(good), bytes);
    if (!status.isOk()) {
      ++refused;
      continue;
    }
    for (int k = 0; k < 4; ++k) tour.drive(streetAt(0.5 * k + 5), 0.5);  // checks the answers
    if (i % 5 == 0) tour.drive(streetAt(5), 0.5, true);
  }
  CHECK(refused > 30);
  CHECK(refused < 150);
}

TEST_CASE("numbers at the end of a state that cannot be are refused") {
  const std::string good = streetState();
  const std::string payload = payloadOf(good);
  // since_measured, the view, at, at_is_new
  const std::size_t at = payload.size() - 9;
  const std::size_t since = at - kPackedBytes - 8;
  const auto isRefused = [&](std::size_t place, std::int64_t value) {
    std::string bytes = payload;
    std::memcpy(bytes.data() + place, &value, sizeof value);
    Tour tour(withLandmarks(), rig());
    return !tolman::test::loadPayload(tour.plugin(), kMagic, versionOf(good), bytes).isOk();
  };
  CHECK_FALSE(isRefused(since, 5));
  CHECK(isRefused(since, -1));
  CHECK(isRefused(since, INT64_MAX));
  CHECK_FALSE(isRefused(at, 3));
  CHECK_FALSE(isRefused(at, -1));
  CHECK(isRefused(at, -2));
  CHECK(isRefused(at, 1000));
}

TEST_CASE("a missing folder for temporary files is an error of its own, not damage") {
  const tolman::test::TemporaryFolder folder;
  const std::string wanted =
      "landmarks cannot be stored: No such file or directory; does the folder for temporary files "
      "(TMPDIR) exist, and is it full? Set landmarks to 0 to do without";
  const std::string state = streetState();
  const tolman::test::Environment set("TMPDIR", folder.path() / "absent");
  Tour loading(withLandmarks(), rig());
  CHECK(loading.load(state).message() == wanted);
  Tour driving(withLandmarks(), rig());
  PlaceObservation seen;
  CHECK(driving.observe(streetAt(0), Motion{}, seen).message() == wanted);
}
