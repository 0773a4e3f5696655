// SPDX-License-Identifier: BSD-3-Clause
// A page that is connected by WebSocket. At most one message is being sent, and one of each kind
// waits, so a slow client misses frames and delays nobody else.
#pragma once

#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <optional>

#include "server_state.hpp"

namespace tolman::web_viewer {

class LiveClient : public std::enable_shared_from_this<LiveClient> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;

  LiveClient(boost::beast::tcp_stream&& stream, std::shared_ptr<ServerState> state);
  ~LiveClient();
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  /// Completes the handshake and sends the first message.
  void start(const Request& request);
  void newFrame();
  void newGraph();
  void runEnded();
  /// Closes the connection at once.
  void disconnect();
  /// Whether sending the present message has taken longer than `patience`.
  bool isStalled(std::chrono::steady_clock::duration patience) const;

 private:
  void sendHello();
  void read();
  void onCommand(std::string_view command);
  void refuse();
  void close(boost::beast::websocket::close_code code);
  void sendNext();
  void send(std::shared_ptr<const std::string> message);
  std::string frameMessage(bool with_arrays);

  std::optional<boost::beast::websocket::stream<boost::beast::tcp_stream>> stream_;
  boost::asio::steady_timer closing_;
  std::shared_ptr<ServerState> state_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> message_;  ///< being sent
  std::chrono::steady_clock::time_point sent_at_;
  bool open_ = false;
  bool wants_arrays_ = true;
  bool frame_waits_ = false;
  bool graph_waits_ = false;
  bool end_waits_ = false;
  bool end_sent_ = false;
  std::size_t next_row_ = 0;
  std::size_t next_event_ = 0;
  std::int64_t dropped_ = 0;  ///< frames that were replaced before they could be sent
  int commands_ = 0;          ///< in the present second
  std::chrono::steady_clock::time_point commands_since_;
};

}  // namespace tolman::web_viewer
