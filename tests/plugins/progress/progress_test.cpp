// SPDX-License-Identifier: BSD-3-Clause
// When the display writes, with a clock that the test sets and a stream that it reads.
#include "progress.hpp"

#include <catch2/catch.hpp>
#include <memory>
#include <sstream>

#include "support/context.hpp"

namespace tolman::progress {
namespace {

constexpr std::int64_t kMs = 1'000'000;

/// A run of which the test decides how fast it is.
struct Run {
  explicit Run(bool interactive, ParameterValues values = {})
      : services(std::move(values)),
        observer(std::make_unique<Progress>(out, interactive, [this] { return columns; })) {
    REQUIRE(observer->configure(services).isOk());
  }
  void begin(std::int64_t frames) {
    RunInfo info;
    info.source.frames = frames;
    REQUIRE(observer->begin(info).isOk());
  }
  /// What one more frame makes the display write.
  std::string frame(std::int64_t ms) {
    services.now_ns += ms * kMs;
    out.str("");
    Snapshot snapshot;
    frame_record.frame++;
    snapshot.frame = &frame_record;
    snapshot.place = &place;
    snapshot.map = &map;
    REQUIRE(observer->observe(snapshot).isOk());
    return out.str();
  }
  std::string finish(const MapGraph& graph = {}) {
    out.str("");
    REQUIRE(observer->finish(graph).isOk());
    return out.str();
  }

  test::TestContext services;
  std::ostringstream out;
  Frame frame_record;
  PlaceObservation place;
  MapUpdate map;
  int columns = 60;
  std::unique_ptr<Progress> observer;
};

}  // namespace

TEST_CASE("a log gets a line at round percentages and after a silence") {
  Run run(false);
  run.begin(20);
  CHECK(run.out.str().empty());
  CHECK(run.frame(100).empty());
  run.place.template_id = 0;
  run.map.experiences = 1;
  CHECK(run.frame(100) ==
        "frame 2 of 20 (10 %), 10.0 frames/s, 1.8 s left, 1 template, 1 experience, 0 loop "
        "decisions\n");
  SECTION("slowly") {
    CHECK(run.frame(4900).empty());  // 15 %, after 4.9 s
    CHECK_FALSE(run.frame(100).empty());
  }
  SECTION("the next percentage") {
    CHECK(run.frame(100).empty());
    CHECK(run.frame(100).starts_with("frame 4 of 20 (20 %)"));
  }
}

TEST_CASE("a log line after five seconds even when nothing is known of the end") {
  Run run(false);
  run.begin(-1);
  CHECK(run.frame(4999).empty());
  CHECK(run.frame(1) == "frame 2, 0.4 frames/s, 0 templates, 0 experiences, 0 loop decisions\n");
  CHECK(run.frame(4999).empty());
}

TEST_CASE("quiet means nothing at all") {
  Run run(false, {{"quiet", true}});
  run.begin(2);
  CHECK(run.frame(6000).empty());
  CHECK(run.frame(6000).empty());
  CHECK(run.finish().empty());
}

TEST_CASE("a terminal's line is redrawn at most ten times a second") {
  Run run(true);
  run.begin(100);
  int drawn = 0;
  for (int i = 0; i < 100; ++i) drawn += run.frame(20).empty() ? 0 : 1;  // 2 s
  CHECK(drawn == 20);
}

TEST_CASE("the summary replaces the line") {
  Run run(true);
  run.begin(1000);
  CHECK(run.frame(100) == "\rframe 1 of 1000 (0 %), 10.0 frames/s, 1:40 min left, 0 temp");
  run.columns = 40;  // the window was made smaller: neither line nor blanks may wrap
  CHECK(run.frame(100) == "\rframe 2 of 1000 (0 %), 10.0 frames/s, 1");
  CHECK(run.finish() == "\r" + std::string(39, ' ') +
                            "\r2 frames in 0.2 s, 10.0 frames/s, 0 templates, 0 experiences, 0 "
                            "loop links\n");
}

TEST_CASE("the summary counts the final map, and frames that were left out") {
  Run run(false);
  run.begin(50);
  run.frame(0);
  run.place.template_id = 11;
  run.frame_record.frame = 38;
  run.frame(4000);
  MapGraph graph;
  graph.experiences.resize(8);
  graph.links.resize(9);
  graph.links[3].kind = LinkKind::Loop;
  CHECK(run.finish(graph) ==
        "2 frames processed and 38 left out in 4.0 s, 0.5 frames/s, 12 templates, 8 experiences, "
        "1 loop link\n");
}

TEST_CASE("a later session counts its own frames") {
  Run run(false);
  run.begin(2);
  run.frame_record.frame = 500;
  run.frame(100);
  run.frame(100);
  CHECK(run.finish({}).starts_with("2 frames in "));
}

TEST_CASE("a run that fails leaves the terminal's cursor on a line of its own") {
  Run run(true);
  run.begin(10);
  run.frame(100);
  run.out.str("");
  run.observer.reset();
  CHECK(run.out.str() == "\n");
}

TEST_CASE("after reset the counts begin again") {
  Run run(false);
  run.begin(4);
  run.place.template_id = 7;
  run.frame(1000);
  REQUIRE(run.observer->reset().isOk());
  run.begin(4);
  run.frame_record.frame = -1;
  run.place.template_id = -1;
  CHECK(run.frame(1000) ==
        "frame 1 of 4 (25 %), 1.0 frames/s, 3.0 s left, 0 templates, 0 experiences, 0 loop "
        "decisions\n");
}

TEST_CASE("after minutes the lines of a log become rarer") {
  Run run(false);
  run.begin(-1);
  int lines = 0;
  for (int i = 0; i < 36'000; ++i) lines += run.frame(1000).empty() ? 0 : 1;  // 10 h
  CHECK(lines > 60);
  CHECK(lines < 100);
}

}  // namespace tolman::progress
