// SPDX-License-Identifier: BSD-3-Clause
// A configured plugin that gets one picture after the other, and random pictures of places.
#pragma once

#include <catch2/catch.hpp>
#include <sstream>
#include <string>
#include <utility>

#include "seqslam.hpp"
#include "support/context.hpp"
#include "support/gray_images.hpp"

namespace tolman::seqslam::test {

/// Blocks of grey, others at every place; `seed` is that of the camera's noise, `light` a factor.
inline Image placePicture(int place, std::uint64_t seed = 0, double light = 1) {
  RandomStream noise(1000 + seed);
  return tolman::test::gray(128, 64, [&](int x, int y) {
    RandomStream random(static_cast<std::uint64_t>((place * 307 + x / 6) * 211 + y / 6));
    const double level = light * (40 + 170 * random.uniform()) + 4 * noise.normal();
    return std::lround(std::clamp(level, 0.0, 255.0));
  });
}

class Walk {
 public:
  explicit Walk(ParameterValues parameters = {}) : services_(strict(std::move(parameters))) {
    const Status status = plugin_.configure(services_);
    INFO(status.message());
    REQUIRE(status.isOk());
  }

  SeqSlam& plugin() { return plugin_; }

  PlaceObservation see(const Image& image) {
    Frame frame;
    frame.frame = frame_;
    frame.stamp_ns = 100'000'000 * frame_;
    frame.left = image;
    PlaceObservation seen;
    const Status status = plugin_.observe(frame, nullptr, seen);
    INFO(status.message());
    REQUIRE(status.isOk());
    REQUIRE(firstInvalidField(seen).empty());
    REQUIRE(seen.frame == frame_);
    REQUIRE(seen.stamp_ns == 100'000'000 * frame_);
    REQUIRE((seen.recognition == Recognition::None) == (seen.template_id < 0));
    ++frame_;
    return seen;
  }
  /// Places `first` to `end` - 1.
  void see(int first, int end) {
    for (int place = first; place < end; ++place) see(placePicture(place));
  }

  std::string saved() const {
    std::ostringstream stream;
    REQUIRE(plugin_.save(stream).isOk());
    return stream.str();
  }
  Status load(const std::string& state) {
    std::istringstream stream(state);
    return plugin_.load(stream);
  }
  /// The number of the next frame, as in a continued run.
  void continueAt(std::int64_t frame) { frame_ = frame; }

 private:
  /// Pictures by chance are told apart well.
  static ParameterValues strict(ParameterValues parameters) {
    parameters.try_emplace("quotient", 0.4);
    return parameters;
  }

  tolman::test::TestContext services_;
  SeqSlam plugin_;
  std::int64_t frame_ = 0;
};

}  // namespace tolman::seqslam::test
