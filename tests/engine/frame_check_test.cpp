// SPDX-License-Identifier: BSD-3-Clause
// Faults of cameras that begin and end during a run.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "engine/camera_check.hpp"
#include "engine/painted_pair.hpp"

using namespace tolman;
using namespace tolman::engine;
using test::PaintedPair;

namespace {

Frame frameOf(const PaintedPair& pair) {
  Frame frame;
  frame.left = pair.left();
  frame.right = pair.right();
  return frame;
}

/// A new view each time.
PaintedPair view(std::uint64_t seed) {
  PaintedPair pair;
  pair.seed = seed;
  return pair;
}

bool isDark(const Image& image) {
  for (int r = 0; r < image.height(); ++r) {
    for (int c = 0; c < image.width(); ++c) {
      if (image.row(r)[c] != 0) return false;
    }
  }
  return !image.empty();
}

}  // namespace

TEST_CASE("sound frames pass unchanged and without a note") {
  FrameCheck check;
  for (std::uint64_t i = 0; i < 7; ++i) {
    Frame frame = frameOf(view(i));
    const Image left = frame.left;
    CHECK_FALSE(check.check(frame));
    CHECK(frame.left.data() == left.data());
    CHECK(frame.defect.empty());
  }
}

TEST_CASE("images that repeat are taken out") {
  FrameCheck check;
  Frame first = frameOf(view(1));
  CHECK_FALSE(check.check(first));
  for (int i = 0; i < 4; ++i) {
    Frame again = frameOf(view(1));  // other memory, the same pixels
    const auto note = check.check(again);
    CHECK(note == again.defect);
    CHECK(again.left.empty());
    CHECK(again.right.empty());
    CHECK(again.defect.starts_with("both images repeat"));
  }
  Frame next = frameOf(view(2));
  CHECK_FALSE(check.check(next));
  CHECK_FALSE(next.left.empty());
}

TEST_CASE("where only the right image repeats, or is the left one, the left one is used") {
  FrameCheck check;
  Frame first = frameOf(view(1));
  check.check(first);
  Frame frame = frameOf(view(2));
  const bool equal = GENERATE(false, true);
  frame.right = equal ? frame.left : first.right;
  const auto note = check.check(frame);
  REQUIRE(note);
  CHECK(*note == (equal ? "the right image is the left one"
                        : "the right image repeats that of the frame before: no new one comes"));
  CHECK_FALSE(frame.left.empty());
  CHECK(isDark(frame.right));
  CHECK(frame.defect == *note);
}

TEST_CASE("a single camera has no pair to be checked, but repetitions") {
  FrameCheck check;
  for (const std::uint64_t seed : {1, 2, 2, 3}) {
    Frame frame = frameOf(view(seed));
    frame.right = Image();
    check.check(frame);
    static std::uint64_t last = 0;
    CHECK(frame.left.empty() == (seed == last));
    last = seed;
  }
}

TEST_CASE("dark frames are left to odometry, and frames without images stay as they are") {
  FrameCheck check;
  for (int i = 0; i < 3; ++i) {
    Frame frame;
    if (i < 2) {
      frame.left = frame.right = Image::create(64, 48, PixelFormat::Gray8, [](std::uint8_t*) {});
    } else {
      frame.defect = "unreadable";
    }
    CHECK_FALSE(check.check(frame));
    CHECK(frame.left.empty() == (i == 2));
    CHECK(frame.defect == (i == 2 ? "unreadable" : ""));
  }
}

TEST_CASE(
    "exchanged sides are noticed within five frames and believed ended after five sound ones") {
  FrameCheck check;
  std::vector<bool> used;
  for (std::uint64_t i = 0; i < 40; ++i) {
    PaintedPair pair = view(i);
    pair.exchanged = i >= 8 && i < 20;
    Frame frame = frameOf(pair);
    const auto fault = check.check(frame);
    CHECK(fault.has_value() == frame.left.empty());
    used.push_back(!frame.left.empty());
  }
  for (std::size_t i = 0; i < 8; ++i) CHECK(used[i]);
  for (std::size_t i = 12; i < 20; ++i) CHECK_FALSE(used[i]);
  for (std::size_t i = 25; i < 40; ++i) CHECK(used[i]);
}

TEST_CASE(
    "a right image that is a frame late is known in turns to both sides, a sound one in none") {
  const auto turned = [](int i) { return 36.0 * (i <= 12 ? i : 24 - i); };
  for (const int late : {0, 1}) {
    FrameCheck check;
    for (int i = 0; i < 24; ++i) {
      PaintedPair pair;
      pair.turned = turned(i);
      Frame frame;
      frame.left = pair.left();
      pair.turned = turned(std::max(i - late, 0));
      frame.right = pair.right();
      CAPTURE(late, i);
      const std::string fault = check.check(frame).value_or("");
      CHECK_FALSE(frame.left.empty());
      if (late == 0) CHECK(fault.empty());
      if (late == 1 && i > 5)
        CHECK(fault.starts_with("the right image belongs to the left one of"));
    }
  }
}

TEST_CASE("a right image with its rows apart is not used from the first frame on") {
  FrameCheck check;
  for (std::uint64_t i = 0; i < 6; ++i) {
    PaintedPair pair = view(i);
    pair.rows_low = 4;
    Frame frame = frameOf(pair);
    check.check(frame);
    CHECK(isDark(frame.right));
    CHECK_FALSE(frame.left.empty());
    CHECK(frame.defect.find("px low; are the images rectified") != std::string::npos);
  }
}
