// SPDX-License-Identifier: BSD-3-Clause
#include <catch2/catch.hpp>
#include <cmath>
#include <limits>

#include "conformance/hash_of.hpp"
#include "conformance/test_instance.hpp"
#include "tolman/records.hpp"

using namespace tolman;
using namespace tolman::conformance;

namespace {

Transcript transcriptOf(const Motion& motion) {
  TranscriptEntry answer;
  answer.call = "frame 12";
  answer.add(motion);
  return {answer};
}

/// The difference between a motion and a changed copy.
std::optional<std::string> difference(auto&& change) {
  Motion motion;
  motion.points.setOnes(4, 6);
  motion.revisions.resize(2);
  Motion other = motion;
  change(other);
  return firstDifference(transcriptOf(motion), transcriptOf(other));
}

Image grey(int width, std::ptrdiff_t stride, std::uint8_t last) {
  const std::shared_ptr<std::uint8_t[]> pixels(new std::uint8_t[64]());
  pixels[static_cast<std::size_t>(stride) + static_cast<std::size_t>(width) - 1] = last;
  return {pixels.get(), width, 2, stride, PixelFormat::Gray8, pixels};
}

}  // namespace

TEST_CASE("the smallest difference of any field is found and named") {
  CHECK_FALSE(difference([](Motion&) {}));
  const auto x = [](Motion& m) { m.T_previous_current.translation().x() = 1e-300; };
  CHECK(difference(x) == "frame 12: 'T_previous_current'");
  CHECK(difference([](Motion& m) { m.v = -0.0; }) == "frame 12: 'v'");
  CHECK(difference([](Motion& m) { m.state = TrackingState::Lost; }) == "frame 12: 'state'");
  CHECK(difference([](Motion& m) { m.points(3, 5) = 1.0000001F; }) == "frame 12: 'points'");
  CHECK(difference([](Motion& m) { m.points.setOnes(6, 4); }) == "frame 12: 'points'");
  CHECK(difference([](Motion& m) { m.revisions[1].frame = 1; }) == "frame 12: 'revisions'");
  CHECK(difference([](Motion& m) { m.revisions.pop_back(); }) == "frame 12: 'revisions'");
}

TEST_CASE("missing and shifted answers are differences") {
  Transcript three(3);
  for (std::size_t i = 0; i < 3; ++i) three[i].call = "frame " + std::to_string(i);
  Transcript two(three.begin(), three.end() - 1);
  CHECK(firstDifference(three, two) == "2 answers instead of 3");
  const Transcript late(three.begin() + 1, three.end());
  CHECK(firstDifference(three, late) == "'frame 1' instead of 'frame 0'");
  CHECK_FALSE(firstDifference(three, late, 1));
}

TEST_CASE("the hash of an image covers pixels, size and format, not the padding") {
  CHECK(test::hashOf(grey(4, 4, 9)) == test::hashOf(grey(4, 11, 9)));
  CHECK(test::hashOf(grey(4, 4, 9)) != test::hashOf(grey(4, 4, 8)));
  CHECK(test::hashOf(grey(4, 4, 0)) != test::hashOf(grey(3, 3, 0)));
  CHECK(test::hashOf(grey(4, 4, 0)) != test::hashOf(Image()));
}

TEST_CASE("the hash of a list of texts depends on where each text ends") {
  const std::vector<std::string> ab_c = {"ab", "c"};
  const std::vector<std::string> a_bc = {"a", "bc"};
  CHECK(test::hashOf(ab_c) != test::hashOf(a_bc));
}
