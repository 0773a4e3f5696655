// SPDX-License-Identifier: BSD-3-Clause
// The frames of a run compared with lists by hand and with an iteration over the data.
#include "tolman/frame_selection.hpp"

#include <catch2/catch.hpp>
#include <cstdlib>
#include <numeric>
#include <tuple>

namespace tolman {
namespace {

struct Parameters : FrameSelection {
  double rate = 10;
  static constexpr auto declaration() {
    return std::tuple_cat(parameters(parameter("rate", &Parameters::rate)),
                          selectionParameters<Parameters>());
  }
};

const std::vector<std::int64_t> kUneven = {100, 110, 130, 131, 200};

FrameSequence sequence(const FrameSelection& selection, const std::vector<std::int64_t>& stamps) {
  Result<FrameSequence> made = FrameSequence::make(selection, stamps);
  INFO(made.status().message());
  REQUIRE(made.isOk());
  return made.value();
}

std::vector<std::int64_t> indices(const FrameSequence& sequence) {
  std::vector<std::int64_t> list;
  for (std::int64_t k = 0; k < sequence.size(); ++k) list.push_back(sequence.sourceIndex(k));
  return list;
}

std::vector<std::int64_t> stamps(const FrameSequence& sequence) {
  std::vector<std::int64_t> list;
  for (std::int64_t k = 0; k < sequence.size(); ++k) list.push_back(sequence.stampNs(k));
  return list;
}

std::string failure(const FrameSelection& selection, const std::vector<std::int64_t>& stamps) {
  return FrameSequence::make(selection, stamps).status().message();
}

using List = std::vector<std::int64_t>;

}  // namespace

TEST_CASE("a selection says which frames come, in which order and when") {
  SECTION("everything, with the stamps of the data") {
    const FrameSequence all = sequence({}, kUneven);
    CHECK(indices(all) == List{0, 1, 2, 3, 4});
    CHECK(stamps(all) == kUneven);
  }
  SECTION("a part") {
    const FrameSequence part = sequence({.first = 1, .last = 3, .step = 2}, kUneven);
    CHECK(indices(part) == List{1, 3});
    CHECK(stamps(part) == List{110, 131});
  }
  SECTION("the last frame is left out when no step hits it") {
    CHECK(indices(sequence({.step = 3}, kUneven)) == List{0, 3});
  }
  SECTION("backward begins with the earliest stamp") {
    const FrameSequence back = sequence({.order = FrameOrder::Backward}, kUneven);
    CHECK(indices(back) == List{4, 3, 2, 1, 0});
    CHECK(stamps(back) == List{100, 169, 170, 190, 200});
  }
  SECTION("backward over every second frame starts at the last one that forward would show") {
    const FrameSequence back =
        sequence({.last = 3, .step = 2, .order = FrameOrder::Backward}, kUneven);
    CHECK(indices(back) == List{2, 0});
  }
  SECTION("pingpong shows the frame at a turn once") {
    const FrameSequence both = sequence({.first = 2, .order = FrameOrder::Pingpong}, kUneven);
    CHECK(indices(both) == List{2, 3, 4, 3, 2});
    CHECK(stamps(both) == List{130, 131, 200, 269, 270});
  }
  SECTION("one frame stays one frame") {
    const FrameSequence one = sequence({.last = 0, .order = FrameOrder::Pingpong}, kUneven);
    CHECK(indices(one) == List{0});
    CHECK(stamps(one) == List{100});
  }
  SECTION("an unmade sequence is empty") { CHECK(FrameSequence().size() == 0); }
}

TEST_CASE("51 frames forward and backward twice are 201") {
  List times(51);
  for (std::size_t i = 0; i < times.size(); ++i) {
    times[i] = static_cast<std::int64_t>(i * 100 + i * i % 7);
  }
  const FrameSequence laps = sequence({.order = FrameOrder::Pingpong, .passes = 4}, times);
  REQUIRE(laps.size() == 201);
  CHECK(laps.sourceIndex(0) == 0);
  CHECK(laps.sourceIndex(50) == 50);
  CHECK(laps.sourceIndex(100) == 0);
  CHECK(laps.sourceIndex(150) == 50);
  CHECK(laps.sourceIndex(200) == 0);

  // The oracle walks: neighbours in the data, and time that goes on by the absolute difference.
  std::int64_t stamp = times.front();
  for (std::int64_t k = 1; k < laps.size(); ++k) {
    const std::int64_t from = laps.sourceIndex(k - 1);
    const std::int64_t to = laps.sourceIndex(k);
    REQUIRE(std::abs(to - from) == 1);
    stamp += std::abs(times[static_cast<std::size_t>(to)] - times[static_cast<std::size_t>(from)]);
    REQUIRE(laps.stampNs(k) == stamp);
  }
}

TEST_CASE("an impossible selection names the remedy") {
  CHECK(failure({}, {}) == "the data have no frames; check the path");
  CHECK(failure({.first = 5}, kUneven) ==
        "first is 5, but the data end at frame 4; choose a smaller one");
  CHECK(failure({.last = 9}, kUneven) ==
        "last is 9, but the data end at frame 4; choose a smaller one, or -1 for the end");
  CHECK(failure({.first = 3, .last = 1}, kUneven) ==
        "last is 1, before first = 3; for the reverse order use order: backward");
  CHECK(failure({.step = 0}, kUneven) == "first, last, step or passes is out of its range");
  CHECK(failure({}, {10, 20, 20}) ==
        "the stamp of frame 2 is not after that of the frame before; sort the data");
  CHECK(failure({.step = 2}, {10, 20, 5}) ==
        "the stamp of frame 2 is not after that of the frame before; sort the data");
  CHECK(failure({}, {-1, 2}) ==
        "the stamp of frame 0 is not within 0 and 146 years; check its unit");
  CHECK(failure({.order = FrameOrder::Pingpong, .passes = 10000}, {0, 1000000000000000000}) ==
        "passes = 10000 take longer than 146 years; choose fewer");
  SECTION("a time that goes back outside of the selection does not matter") {
    CHECK(failure({.first = 1}, {50, 20, 30}).empty());
  }
}

TEST_CASE("a source's parameters include the selection's") {
  const Schema schema = schemaOf<Parameters>();
  std::vector<std::string> names;
  for (const ParameterInfo& info : schema) names.push_back(info.name);
  CHECK(names == std::vector<std::string>{"rate", "first", "last", "step", "order", "passes"});
  CHECK(schema[4].choices == std::vector<std::string>{"forward", "backward", "pingpong"});

  const Result<Parameters> bound = bindParameters<Parameters>(
      {{"rate", 5.0}, {"step", std::int64_t{3}}, {"order", std::string("backward")}});
  REQUIRE(bound.isOk());
  CHECK(bound.value().rate == 5.0);
  CHECK(bound.value().step == 3);
  CHECK(bound.value().order == FrameOrder::Backward);
  static_assert(schemaHash<Parameters>() != 0);
}

}  // namespace tolman
