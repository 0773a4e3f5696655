// SPDX-License-Identifier: BSD-3-Clause
// A program that is connected to /api/events. It gets the newest pose, and every decision, loop and
// event since it connected, as JSON texts. A slow client misses poses.
#pragma once

#include "socket_client.hpp"

namespace tolman::web_viewer {

class EventClient final : public SocketClient {
 public:
  EventClient(boost::beast::tcp_stream&& stream, std::shared_ptr<ServerState> state)
      : SocketClient(std::move(stream), std::move(state), Messages::Text) {
    ++this->state().event_clients;
  }
  ~EventClient() override { --state().event_clients; }
  EventClient(const EventClient&) = delete;
  EventClient& operator=(const EventClient&) = delete;

  void newNumbers() override { sendNext(); }
  void runEnded() override { sendNext(); }

 private:
  void opened() override;
  /// There are no commands.
  bool onCommand(std::string_view) override { return false; }
  void sendNext() override;

  std::size_t next_ = 0;         ///< number of the next message of the log
  std::int64_t sent_pose_ = -1;  ///< frame of the last pose that was sent
  bool end_sent_ = false;
};

}  // namespace tolman::web_viewer
