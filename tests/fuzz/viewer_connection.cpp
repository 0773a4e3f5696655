// SPDX-License-Identifier: BSD-3-Clause
#include "viewer_connection.hpp"

#include <sys/socket.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <chrono>

#include "http_connection.hpp"
#include "input.hpp"
#include "server.hpp"
#include "small_plugins.hpp"
#include "viewer_thread.hpp"

namespace tolman::fuzz {
namespace {

using namespace web_viewer;
using boost::asio::ip::tcp;

/// A run of three frames with an image, a graph and an event.
std::shared_ptr<ServerState> shortRun() {
  const auto state = std::make_shared<ServerState>(JpegOptions{}, 1U << 20U, 8);
  RunInfo run;
  run.name = "short";
  run.source.rig = {16, 8, false, {10, 10, 8, 4}, 0};
  state->store.begin(run, true);
  Handover handover(false);
  for (std::int64_t i = 0; i < 3; ++i) {
    Frame frame = loggedFrame(i);
    frame.left =
        Image::create(16, 8, PixelFormat::Gray8, [](std::uint8_t* p) { std::memset(p, 77, 128); });
    const Motion motion = straightMotion(i);
    const PlaceObservation place = seenView(i, Recognition::Novel, i);
    const Decision decision;
    const MapUpdate map;
    const std::vector<NamedArray> cells = {{"hd.activity", {3}, {1, 2, 3}}};
    const MapGraph graph{1, {{0, 0, 0, Eigen::Isometry3d::Identity()}}, {}, {}};
    const std::vector<RunEvent> events = {{i, LogLevel::Info, "place", "new view"}};
    handover.put({&frame, &motion, &place, &decision, &map, &cells, &graph, {}, &events});
    PendingData pending;
    handover.take(pending, true, true);
    state->store.add(pending);
  }
  state->store.end("finished");
  return state;
}

/// Reads what the viewer has written, so that it never waits for its client.
bool readAnswer(int client) {
  std::array<char, 65536> bytes{};
  bool any = false;
  while (::recv(client, bytes.data(), bytes.size(), MSG_DONTWAIT) > 0) any = true;
  return any;
}

}  // namespace

void connectAndSend(std::string_view bytes) {
  static const std::shared_ptr<ServerState> state = shortRun();
  std::array<int, 2> ends{};
  require(::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0, "no socket");
  const auto client = ends[1];
  boost::asio::io_context io;
  {
    tcp::socket socket(io);
    socket.assign(tcp::v4(), ends[0]);
    std::make_shared<HttpConnection>(std::move(socket), state)->start();
  }
  // The socket's buffer is larger than any input.
  require(::send(client, bytes.data(), bytes.size(), MSG_NOSIGNAL) ==
              static_cast<ssize_t>(bytes.size()),
          "the input cannot be sent");
  ::shutdown(client, SHUT_WR);
  for (int idle = 0; state->connections > 0 && idle < 1000;) {
    const bool worked = io.poll() > 0;
    io.restart();
    const bool answered = readAnswer(client);
    idle = worked || answered ? 0 : idle + 1;
  }
  io.run_for(state->connections > 0 ? std::chrono::seconds(2) : std::chrono::seconds(0));
  require(state->connections == 0, "a connection stays although its client has gone");
  require(state->clients.empty(), "a live client stays although it has gone");
  ::close(client);
}

}  // namespace tolman::fuzz
