// SPDX-License-Identifier: BSD-3-Clause
#include "engine/source_notes.hpp"

#include <catch2/catch.hpp>

using namespace tolman;
using tolman::run::SourceNotes;

namespace {

Frame at(std::int64_t stamp_ns, bool has_truth = false) {
  Frame frame;
  frame.stamp_ns = stamp_ns;
  frame.has_truth = has_truth;
  return frame;
}

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr std::int64_t kDay = 86'400 * kSecond;

}  // namespace

TEST_CASE("steps of days between frames of a tenth of a second are told, three of them") {
  SourceNotes notes;
  std::int64_t now = 0;
  CHECK_FALSE(notes.add(at(now)));
  for (int i = 0; i < 20; ++i) CHECK_FALSE(notes.add(at(now += kSecond / 10)));
  CHECK(notes.add(at(now += 2 * kDay)) ==
        "the stamp is 172800 s after that of the frame before; stamps are in ns, and velocities "
        "are divided by that time");
  CHECK_FALSE(notes.add(at(now += kSecond / 10)));
  CHECK_FALSE(notes.add(at(now += 3600 * kSecond)));  // a pause
  CHECK(notes.atEnd(false).empty());
  CHECK(notes.add(at(now += kDay)));
  CHECK(notes.add(at(now += kDay)).value().ends_with("counted at the end"));
  CHECK_FALSE(notes.add(at(now += kDay)));
  CHECK(notes.atEnd(false) == std::vector<std::string>{"4 stamps are days after the one before"});
}

TEST_CASE("one frame a day is no jump, and told by the median") {
  SourceNotes notes;
  std::int64_t now = 0;
  (void)notes.add(at(now));
  (void)notes.add(at(now += kDay / 2));
  for (int i = 0; i < 5; ++i) CHECK_FALSE(notes.add(at(now += kDay)));
  REQUIRE(notes.atEnd(false).size() == 1);
  CHECK(notes.atEnd(false)[0].find("8.64e+04 s apart (median)") != std::string::npos);
}

TEST_CASE("a truth that was told and never came is told") {
  SourceNotes notes;
  CHECK(notes.atEnd(true).empty());  // no frame, which is told elsewhere
  for (int i = 0; i < 3; ++i) (void)notes.add(at(i * kSecond));
  CHECK(notes.atEnd(false).empty());
  REQUIRE(notes.atEnd(true).size() == 1);
  CHECK(notes.atEnd(true)[0] ==
        "told that frames come with true poses, and none of 3 did; errors are not measured");
  (void)notes.add(at(9 * kSecond, true));
  CHECK(notes.atEnd(true) ==
        std::vector<std::string>{"only 1 of 4 frames have true poses; errors are of these alone"});
  for (int i = 10; i < 12; ++i) (void)notes.add(at(i * kSecond, true));
  CHECK(notes.atEnd(true).empty());
}
