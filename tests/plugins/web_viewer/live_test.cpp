// SPDX-License-Identifier: BSD-3-Clause
// The live stream: order of messages, completeness of rows, slow clients.
#include <catch2/catch.hpp>
#include <functional>
#include <thread>

#include "browser.hpp"
#include "watched_run.hpp"

namespace tolman::test {
namespace {

using namespace std::chrono_literals;

/// Reads messages until row `end`; checks that no row is missing or repeated.
struct Reader {
  explicit Reader(LiveSocket& from) : socket(from) {}
  void readTo(double end) {
    while (next_row < end) {
      const auto frame = socket.next("frame");
      REQUIRE(frame);
      take(*frame);
    }
  }
  void take(const Container& frame) {
    const auto& array = frame.arrays.at("rows");
    REQUIRE(array.shape.at(0) <= 2000);
    CHECK(frame.header["rows_from"] == static_cast<std::int64_t>(next_row));
    const auto rows = array.as<double>();
    for (std::size_t i = 0; i < array.shape[0]; ++i, ++next_row) {
      REQUIRE(rows[array.shape[1] * i] == next_row);  // the frame
    }
    CHECK(frame.header["dropped"] >= dropped);
    dropped = frame.header["dropped"];
    for (const auto& event : frame.header["events"]) events.push_back(event["frame"]);
    last = frame;
    ++messages;
  }
  LiveSocket& socket;
  double next_row = 0;
  std::int64_t dropped = 0;
  int messages = 0;
  std::vector<std::int64_t> events;
  Container last;
};

}  // namespace

TEST_CASE("the first message is hello, with the number of rows") {
  WatchedRun watched;
  watched.frames(30);
  while (parseContainer(get(watched.port(), "/api/history?count=1").body).header["total"] != 30) {
  }
  LiveSocket socket(watched.port());
  REQUIRE(socket.status() == 101);
  const auto first = socket.next();
  REQUIRE(first);
  CHECK(first->opcode == 2);
  const Container hello = parseContainer(first->bytes);
  CHECK(hello.header["type"] == "hello");
  CHECK(hello.header["run"]["name"] == "made up");
  CHECK(hello.header["rows"] == 30);
  CHECK(hello.header["columns"][0]["name"] == "frame.frame");
}

TEST_CASE("frames bring every row after hello once, with arrays") {
  WatchedRun watched({{"rate", 100.0}});
  LiveSocket socket(watched.port());
  REQUIRE(socket.next("hello")->header["rows"] == 0);
  Reader reader(socket);
  for (int i = 0; i < 20; ++i) {
    watched.frames(7);
    std::this_thread::sleep_for(5ms);
  }
  reader.readTo(140);
  CHECK(reader.messages > 1);
  CHECK(reader.last.header["frame"] == 139);
  CHECK(reader.last.arrays.at("cells.hd.activity").as<float>()[2] == 139);
  CHECK(reader.last.has("image"));
  CHECK(reader.last.has("points"));
  // Each tenth frame had an event; each was sent once.
  REQUIRE(reader.events.size() == 14);
  for (std::size_t i = 0; i < 14; ++i) CHECK(reader.events[i] == static_cast<std::int64_t>(10 * i));
}

TEST_CASE("graphs are sent during the run, the final one before the end") {
  WatchedRun watched;
  LiveSocket socket(watched.port());
  watched.frames(45);
  Status ended;
  std::thread finishing([&] { ended = watched.end(); });
  std::vector<std::string> types;
  Container graph;
  std::optional<LiveSocket::Message> message;
  while ((message = socket.next()) && message->opcode == 2) {
    Container container = parseContainer(message->bytes);
    types.push_back(container.header["type"]);
    if (types.back() == "graph") graph = container;
    if (types.back() == "end") {
      CHECK(container.header["state"] == "finished");
      CHECK(container.header["frames"] == 45);
    }
  }
  finishing.join();
  CHECK(ended.isOk());
  REQUIRE(types.size() >= 4);
  CHECK(types.front() == "hello");
  CHECK(types.back() == "end");
  CHECK(graph.arrays.at("experience").shape[0] == 5);
  REQUIRE(message);
  CHECK(message->closeCode() == 1000);
}

TEST_CASE("interrupted and failed runs end as interrupted") {
  WatchedRun watched;
  LiveSocket socket(watched.port());
  REQUIRE(socket.next("hello"));
  watched.frames(3);
  std::function<Status()> end_run;
  SECTION("interrupted") {
    watched.context.cancelled = true;
    end_run = [&] { return watched.end(); };
  }
  SECTION("destroyed without finish()") {
    end_run = [&] {
      watched.viewer.reset();
      return Status::ok();
    };
  }
  SECTION("reset") {
    end_run = [&] { return watched.viewer->reset(); };
  }
  Status ended;
  std::thread ending([&] { ended = end_run(); });
  const auto end = socket.next("end");
  ending.join();
  CHECK(ended.isOk());
  REQUIRE(end);
  CHECK(end->header["state"] == "interrupted");
  CHECK(end->header["frames"] == 3);
}

TEST_CASE("without flow there are rows and events, but no arrays") {
  WatchedRun watched({{"rate", 100.0}});
  LiveSocket socket(watched.port());
  socket.sendText(R"({"type":"flow","live":false})");
  REQUIRE(socket.next("hello"));
  std::this_thread::sleep_for(50ms);
  Reader reader(socket);
  watched.frames(20);
  reader.readTo(20);
  CHECK(reader.last.arrays.size() == 1);
  CHECK(reader.events.size() == 2);
  socket.sendText(R"({"live":true,"type":"flow"})");
  std::this_thread::sleep_for(50ms);
  watched.frames(1);
  reader.readTo(21);
  CHECK(reader.last.has("image"));
}

TEST_CASE("a slow client misses frames, which are counted, but no rows") {
  WatchedRun watched({{"rate", 0.0}});
  LiveSocket slow(watched.port(), 10, 4096);
  REQUIRE(slow.next("hello"));
  watched.frames(3000);  // while nobody reads
  Reader reader(slow);
  reader.readTo(3000);
  CHECK(reader.dropped > 0);
  CHECK(reader.messages + reader.dropped == 3000);
  CHECK(reader.last.header["frame"] == 2999);
}

TEST_CASE("after a reconnect the history has the missing rows") {
  WatchedRun watched({{"rate", 100.0}});
  watched.frames(50);
  std::size_t rows = 0;
  {
    LiveSocket first(watched.port());
    Reader reader(first);
    reader.next_row = first.next("hello")->header["rows"];
    watched.frames(50);
    reader.readTo(100);
  }
  watched.frames(50);
  LiveSocket second(watched.port());
  rows = second.next("hello")->header["rows"];
  const Container history =
      parseContainer(get(watched.port(), "/api/history?from=0&count=" + std::to_string(rows)).body);
  CHECK(history.arrays.at("rows").shape[0] == rows);
  Reader reader(second);
  reader.next_row = static_cast<double>(rows);
  watched.frames(1);
  reader.readTo(151);
}

TEST_CASE("the number of clients is limited") {
  WatchedRun watched({{"clients", std::int64_t{2}}});
  std::optional<LiveSocket> first(watched.port());
  const LiveSocket second(watched.port());
  CHECK(second.status() == 101);
  CHECK(LiveSocket(watched.port()).status() == 503);
  CHECK(get(watched.port(), "/api/run").status == 200);
  first.reset();
  int status = 503;
  for (int i = 0; i < 200 && status == 503; ++i) {
    std::this_thread::sleep_for(5ms);
    status = LiveSocket(watched.port()).status();
  }
  CHECK(status == 101);
}

TEST_CASE("pings are answered") {
  const WatchedRun watched;
  LiveSocket socket(watched.port());
  REQUIRE(socket.next("hello"));
  socket.sendFrame(0x89, "are you there");
  const auto pong = socket.next();
  REQUIRE(pong);
  CHECK(pong->opcode == 10);
  CHECK(pong->bytes == "are you there");
}

}  // namespace tolman::test
