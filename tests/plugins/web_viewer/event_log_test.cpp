// SPDX-License-Identifier: BSD-3-Clause
// Each client gets every event of the log once, compared with a list of all events.
#include "event_log.hpp"

#include <catch2/catch.hpp>

#include "tolman/context.hpp"

namespace tolman::web_viewer {
namespace {

std::vector<RunEvent> numbered(std::size_t first, std::size_t count) {
  std::vector<RunEvent> events(count);
  for (std::size_t i = 0; i < count; ++i) events[i].frame = static_cast<std::int64_t>(first + i);
  return events;
}

}  // namespace

TEST_CASE("clients of any pace get every event once and in order, while the log has it") {
  RandomStream random(31);
  EventLog log;
  std::size_t written = 0;
  std::vector<std::size_t> next(3, 0);  // of each client
  for (int round = 0; round < 2000; ++round) {
    const std::size_t count = random.below(5);
    log.append(numbered(written, count));
    written += count;
    REQUIRE(log.end() == written);
    const std::size_t client = random.below(3);
    const std::vector<RunEvent> got = log.since(next[client], 100);
    const std::size_t missed = written - next[client];
    REQUIRE(got.size() == std::min<std::size_t>(missed, 100));
    for (std::size_t i = 0; i < got.size(); ++i) {
      REQUIRE(got[i].frame == static_cast<std::int64_t>(written - got.size() + i));
    }
    next[client] = log.end();
  }
  CHECK(written > 3000);
}

TEST_CASE("the log keeps the newest thousand") {
  EventLog log;
  log.append(numbered(0, 700));
  log.append(numbered(700, 800));
  const std::vector<RunEvent> got = log.since(0, 5000);
  REQUIRE(got.size() == 1000);
  CHECK(got.front().frame == 500);
  CHECK(got.back().frame == 1499);
}

TEST_CASE("a client that is ahead, as of a run before, gets nothing") {
  EventLog log;
  CHECK(log.since(0, 10).empty());
  log.append(numbered(0, 3));
  CHECK(log.since(3, 10).empty());
  CHECK(log.since(400, 10).empty());
  CHECK(log.since(0, 0).empty());
}

}  // namespace tolman::web_viewer
