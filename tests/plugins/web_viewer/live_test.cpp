// SPDX-License-Identifier: BSD-3-Clause
// The stream: what comes in which order, that rows are complete, and what a slow reader misses.
#include <catch2/catch.hpp>
#include <thread>

#include "browser.hpp"
#include "drive.hpp"

namespace tolman::test {
namespace {

using namespace std::chrono_literals;

/// Takes messages until the rows go up to `end`; checks that none is missing or double.
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
      REQUIRE(rows[32 * i] == next_row);  // the frame
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

TEST_CASE("hello comes first and says where the run is") {
  Drive drive;
  drive.frames(30);
  while (parseContainer(get(drive.port(), "/api/history?count=1").body).header["total"] != 30) {
  }
  LiveSocket socket(drive.port());
  REQUIRE(socket.status() == 101);
  const auto first = socket.next();
  REQUIRE(first);
  CHECK(first->opcode == 2);
  const Container hello = parseContainer(first->bytes);
  CHECK(hello.header["type"] == "hello");
  CHECK(hello.header["name"] == "made up");
  CHECK(hello.header["rows"] == 30);
  CHECK(hello.header["newest"] == 29);
  CHECK(hello.header["row"].size() == 32);
}

TEST_CASE("rows go on where hello said, complete and once, with arrays beside them") {
  Drive drive({{"rate", 100.0}});
  LiveSocket socket(drive.port());
  REQUIRE(socket.next("hello")->header["rows"] == 0);
  Reader reader(socket);
  for (int i = 0; i < 20; ++i) {
    drive.frames(7);
    std::this_thread::sleep_for(5ms);
  }
  reader.readTo(140);
  CHECK(reader.messages > 1);
  CHECK(reader.last.header["frame"] == 139);
  CHECK(reader.last.header["clients"] == 1);
  CHECK(reader.last.arrays.at("cells.hd.activity").as<float>()[2] == 139);
  CHECK(reader.last.has("image"));
  CHECK(reader.last.has("points"));
  // Each tenth frame had an event; all were told, once.
  REQUIRE(reader.events.size() == 14);
  for (std::size_t i = 0; i < 14; ++i) CHECK(reader.events[i] == static_cast<std::int64_t>(10 * i));
}

TEST_CASE("graphs come while it goes on, the last one at the end, then the end") {
  Drive drive;
  LiveSocket socket(drive.port());
  drive.frames(45);
  std::thread finishing([&] { drive.finish(); });
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
  REQUIRE(types.size() >= 4);
  CHECK(types.front() == "hello");
  CHECK(types.back() == "end");
  CHECK(graph.arrays.at("experience_frame").shape[0] == 5);
  REQUIRE(message);
  CHECK(message->closeCode() == 1000);
}

TEST_CASE("an interrupted run, and one that fails, say so") {
  Drive drive;
  LiveSocket socket(drive.port());
  REQUIRE(socket.next("hello"));
  drive.frames(3);
  std::thread ending([&] {
    SECTION("interrupted") {
      drive.context.cancelled = true;
      drive.finish();
    }
    SECTION("destroyed without finish()") { drive.viewer.reset(); }
    SECTION("reset") { CHECK(drive.viewer->reset().isOk()); }
  });
  const auto end = socket.next("end");
  ending.join();
  REQUIRE(end);
  CHECK(end->header["state"] == "interrupted");
  CHECK(end->header["frames"] == 3);
}

TEST_CASE("without flow there are rows and events, but no pictures") {
  Drive drive({{"rate", 100.0}});
  LiveSocket socket(drive.port());
  socket.sendText(R"({"type":"flow","live":false})");
  REQUIRE(socket.next("hello"));
  std::this_thread::sleep_for(50ms);
  Reader reader(socket);
  drive.frames(20);
  reader.readTo(20);
  CHECK(reader.last.arrays.size() == 1);
  CHECK(reader.events.size() == 2);
  socket.sendText(R"({"live":true,"type":"flow"})");
  std::this_thread::sleep_for(50ms);
  drive.frames(1);
  reader.readTo(21);
  CHECK(reader.last.has("image"));
}

TEST_CASE("a slow client misses frames, which are counted, and no row") {
  Drive drive({{"rate", 0.0}});
  LiveSocket slow(drive.port(), 10, 4096);
  REQUIRE(slow.next("hello"));
  drive.frames(3000);  // while nobody reads
  Reader reader(slow);
  reader.readTo(3000);
  CHECK(reader.dropped > 0);
  CHECK(reader.messages + reader.dropped == 3000);
  CHECK(reader.last.header["frame"] == 2999);
}

TEST_CASE("a client that comes back gets the rest by history") {
  Drive drive({{"rate", 100.0}});
  drive.frames(50);
  std::size_t rows = 0;
  {
    LiveSocket first(drive.port());
    Reader reader(first);
    reader.next_row = first.next("hello")->header["rows"];
    drive.frames(50);
    reader.readTo(100);
  }
  drive.frames(50);
  LiveSocket second(drive.port());
  rows = second.next("hello")->header["rows"];
  const Container history =
      parseContainer(get(drive.port(), "/api/history?from=0&count=" + std::to_string(rows)).body);
  CHECK(history.arrays.at("rows").shape[0] == rows);
  Reader reader(second);
  reader.next_row = static_cast<double>(rows);
  drive.frames(1);
  reader.readTo(151);
}

TEST_CASE("as many clients as allowed, and again when one has gone") {
  Drive drive({{"clients", std::int64_t{2}}});
  std::optional<LiveSocket> first(drive.port());
  const LiveSocket second(drive.port());
  CHECK(second.status() == 101);
  CHECK(LiveSocket(drive.port()).status() == 503);
  CHECK(get(drive.port(), "/api/run").status == 200);
  first.reset();
  int status = 503;
  for (int i = 0; i < 200 && status == 503; ++i) {
    std::this_thread::sleep_for(5ms);
    status = LiveSocket(drive.port()).status();
  }
  CHECK(status == 101);
}

TEST_CASE("pings are answered") {
  const Drive drive;
  LiveSocket socket(drive.port());
  REQUIRE(socket.next("hello"));
  socket.sendFrame(0x89, "are you there");
  const auto pong = socket.next();
  REQUIRE(pong);
  CHECK(pong->opcode == 10);
  CHECK(pong->bytes == "are you there");
}

}  // namespace tolman::test
