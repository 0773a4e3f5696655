// SPDX-License-Identifier: BSD-3-Clause
// The report on a run without motion.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "engine/chain.hpp"

using tolman::engine::RunCounters;

namespace {

RunCounters counters(std::int64_t frames, std::int64_t initialising, std::int64_t lost) {
  RunCounters n;
  n.frames = frames;
  n.initialising = initialising;
  n.lost = lost;
  return n;
}

bool says(const RunCounters& n, std::string_view part) {
  return n.endText().find(part) != std::string_view::npos;
}

}  // namespace

TEST_CASE("a run with one motion has tracked, one without has not") {
  CHECK_FALSE(counters(0, 0, 0).neverTracked());
  CHECK_FALSE(counters(10, 1, 8).neverTracked());
  CHECK(counters(10, 1, 9).neverTracked());
  CHECK(counters(10, 10, 0).neverTracked());
}

TEST_CASE("motions that are all exactly zero are no motion, one that is not is one") {
  RunCounters n = counters(10, 1, 2);
  n.unmoved = 7;
  CHECK(n.neverTracked());
  CHECK(says(n, "exactly zero at each frame"));
  n.unmoved = 6;
  CHECK_FALSE(n.neverTracked());
}

TEST_CASE("the cause is named: one frame, limits of checks, or images") {
  CHECK(says(counters(1, 1, 0), "it has one frame"));
  CHECK(says(counters(10, 10, 0), "are the images rectified"));
  RunCounters impossible = counters(10, 1, 9);
  impossible.impossible = 9;
  CHECK(says(impossible, "most motions exceed the limits of `checks`"));
  impossible.impossible = 3;
  CHECK(says(impossible, "are the images rectified"));
}

TEST_CASE("images that are nearly black are named before their rectification is") {
  RunCounters n = counters(10, 10, 0);
  n.nearly_black = 6;
  CHECK(says(n, "nearly black"));
  CHECK(says(n, "set source.bits"));
  n.nearly_black = 5;
  CHECK(says(n, "are the images rectified"));
}

TEST_CASE("a run that is lost at its end among nearly black images says so") {
  RunCounters n = counters(12, 1, 9);
  n.nearly_black = 9;
  CHECK(n.endText().empty());  // it tracks again
  n.lost_at_end = true;
  CHECK(n.endText().find("nearly black") != std::string_view::npos);
  n.nearly_black = 5;  // of ten without tracking
  CHECK(n.endText().empty());
}

TEST_CASE("every count is visited once, under its own name") {
  RunCounters n;
  n.impossible = 7;
  std::vector<std::string> names;
  std::int64_t found = -1;
  RunCounters::visit(n, [&](const std::string& name, const auto& value) {
    names.push_back(name);
    if (name == "impossible") found = static_cast<std::int64_t>(value);
  });
  CHECK(found == 7);
  std::sort(names.begin(), names.end());
  CHECK(std::adjacent_find(names.begin(), names.end()) == names.end());
}
