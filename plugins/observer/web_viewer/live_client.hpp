// SPDX-License-Identifier: BSD-3-Clause
// A page that is connected by WebSocket. Only the newest message of each kind is kept for sending,
// so a slow page misses frames but no rows.
#pragma once

#include "socket_client.hpp"

namespace tolman::web_viewer {

class LiveClient final : public SocketClient {
 public:
  LiveClient(boost::beast::tcp_stream&& stream, std::shared_ptr<ServerState> state)
      : SocketClient(std::move(stream), std::move(state), Messages::Binary) {}

  void newFrame() override;
  void newGraph() override;
  void runEnded() override;

 private:
  void opened() override;
  bool onCommand(std::string_view command) override;
  void sendNext() override;
  std::string frameMessage(bool with_arrays);

  bool wants_arrays_ = true;
  bool frame_waits_ = false;
  bool graph_waits_ = false;
  bool end_waits_ = false;
  bool end_sent_ = false;
  std::size_t next_row_ = 0;
  std::size_t next_event_ = 0;
  std::int64_t dropped_ = 0;  ///< frames that were replaced before they could be sent
};

}  // namespace tolman::web_viewer
