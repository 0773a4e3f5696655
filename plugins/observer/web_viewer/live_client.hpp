// SPDX-License-Identifier: BSD-3-Clause
// One page that watches: a WebSocket, with at most one message under way and one of each kind
// waiting, so that a slow reader costs frames of its own and nothing else.
#pragma once

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>

#include "hall.hpp"

namespace tolman::web_viewer {

class LiveClient : public std::enable_shared_from_this<LiveClient> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;

  LiveClient(boost::beast::tcp_stream&& stream, std::shared_ptr<Hall> hall);
  ~LiveClient();
  LiveClient(const LiveClient&) = delete;
  LiveClient& operator=(const LiveClient&) = delete;

  /// Answers the handshake and begins.
  void start(const Request& request);
  void newFrame();
  void newGraph();
  void runEnded();
  /// Hangs up without another word.
  void drop();
  /// Whether a message has been under way for so long.
  bool isStalled(std::chrono::steady_clock::duration patience) const;

 private:
  void greet();
  void read();
  void obey(std::string_view command);
  void refuse();
  void close(boost::beast::websocket::close_code code);
  void sendNext();
  void send(std::shared_ptr<const std::string> message);
  std::string frameMessage(bool with_arrays);
  std::string helloMessage();

  boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
  std::shared_ptr<Hall> hall_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> message_;  ///< under way
  std::chrono::steady_clock::time_point sent_at_;
  bool open_ = false;
  bool wants_pictures_ = true;
  bool frame_waits_ = false;
  bool graph_waits_ = false;
  bool end_waits_ = false;
  bool end_told_ = false;
  std::size_t next_row_ = 0;
  std::size_t next_event_ = 0;
  std::size_t dropped_ = 0;
  int commands_ = 0;  ///< heard in the present second
  std::chrono::steady_clock::time_point commands_since_;
};

}  // namespace tolman::web_viewer
