// SPDX-License-Identifier: BSD-3-Clause
// A configured plugin on a drive past pictures, and random pictures of places.
#pragma once

#include <catch2/catch.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <utility>

#include "support/context.hpp"
#include "support/gray_images.hpp"
#include "view_sequences.hpp"

namespace tolman::view_sequences::test {

inline constexpr int kPictureCell = 16;  // px
inline constexpr int kPictureWidth = kColumns * kPictureCell;
inline constexpr int kPictureHeight = kRows * kPictureCell;

/// Blocks of grey, others at every place; `moved_left` px turns the camera to the right. `seed` is
/// that of the camera's noise.
inline Image placePicture(int place, std::uint64_t seed = 0, int moved_left = 0) {
  RandomStream noise(1000 + seed);
  return tolman::test::gray(kPictureWidth, kPictureHeight, [&](int x, int y) {
    const int block_x = (x + moved_left + 1600) / 20;
    RandomStream random(static_cast<std::uint64_t>((place * 307 + block_x) * 211 + y / 24));
    const double level = 40 + 170 * random.uniform() + 8 * noise.normal();
    return std::lround(std::clamp(level, 0.0, 255.0));
  });
}

class Tour {
 public:
  explicit Tour(ParameterValues parameters = {}, const CameraRig& rig = {})
      : services_(std::move(parameters)) {
    services_.rig = rig;
    const Status status = plugin_.configure(services_);
    INFO(status.message());
    REQUIRE(status.isOk());
  }

  ViewSequences& plugin() { return plugin_; }
  const std::vector<std::string>& log() const { return services_.log; }

  Status observe(Frame frame, const Motion& motion, PlaceObservation& seen) {
    frame.frame = frame_;
    frame.stamp_ns = 100'000'000 * frame_;
    ++frame_;
    seen = {};
    return plugin_.observe(frame, &motion, seen);
  }
  /// The answer to a frame after so many metres ahead; `starts`: odometry (re)starts.
  PlaceObservation drive(const Frame& frame, double metres, bool starts = false) {
    Motion motion;
    motion.state = starts ? TrackingState::Initialising : TrackingState::Tracking;
    if (!starts) motion.T_previous_current.translation().z() = metres;
    PlaceObservation seen;
    const std::int64_t number = frame_;
    const Status status = observe(frame, motion, seen);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(seen).empty());
    REQUIRE(seen.frame == number);
    REQUIRE(seen.stamp_ns == 100'000'000 * number);
    REQUIRE((seen.recognition == Recognition::None) == (seen.template_id < 0));
    return seen;
  }
  PlaceObservation drive(const Image& image, double metres, bool starts = false) {
    Frame frame;
    frame.left = image;
    return drive(frame, metres, starts);
  }

  std::string saved() const {
    std::ostringstream stream;
    const Status status = plugin_.save(stream);
    INFO(status.message());
    REQUIRE(status.isOk());
    return stream.str();
  }
  Status load(const std::string& state) {
    std::istringstream stream(state);
    return plugin_.load(stream);
  }
  /// The number of the next frame, as in a continued run.
  void continueAt(std::int64_t frame) { frame_ = frame; }
  std::int64_t frames() const { return frame_; }

 private:
  tolman::test::TestContext services_;
  ViewSequences plugin_;
  std::int64_t frame_ = 0;
};

/// Places that a tour recognises without landmarks soon after it comes back.
inline ParameterValues bold(ParameterValues more = {}) {
  more.try_emplace("probability", 0.6);
  return more;
}

}  // namespace tolman::view_sequences::test
