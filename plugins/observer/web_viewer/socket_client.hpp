// SPDX-License-Identifier: BSD-3-Clause
// A client that is connected by WebSocket. At most one message is sent at a time; the next one is
// made when it is complete, so a slow client delays no other client.
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

#include "server.hpp"

namespace tolman::web_viewer {

class SocketClient : public std::enable_shared_from_this<SocketClient> {
 public:
  using Request = boost::beast::http::request<boost::beast::http::empty_body>;
  enum class Messages : std::uint8_t { Text, Binary };

  SocketClient(boost::beast::tcp_stream&& stream, std::shared_ptr<ServerState> state,
               Messages messages);
  virtual ~SocketClient();
  SocketClient(const SocketClient&) = delete;
  SocketClient& operator=(const SocketClient&) = delete;

  /// Completes the handshake; opened() sends the first message.
  void start(const Request& request);
  /// Called when there is a new frame to send.
  virtual void newFrame() {}
  virtual void newGraph() {}
  virtual void newNumbers() {}
  virtual void runEnded() {}
  /// Closes the connection at once.
  void disconnect();
  /// Whether sending the present message has taken longer than `patience`.
  bool isStalled(std::chrono::steady_clock::duration patience) const;

 protected:
  virtual void opened() = 0;
  /// Handles a text from the client; false if it is unknown, which closes the connection.
  virtual bool onCommand(std::string_view command) = 0;
  /// Sends the next message, if any; called when a message has been sent.
  virtual void sendNext() = 0;

  void send(std::shared_ptr<const std::string> message);
  void close(boost::beast::websocket::close_code code);
  bool isOpen() const { return open_; }
  bool canSend() const { return open_ && !message_; }
  ServerState& state() { return *state_; }

 private:
  void read();
  bool tooMany();
  void refuse();

  std::optional<boost::beast::websocket::stream<boost::beast::tcp_stream>> stream_;
  boost::asio::steady_timer closing_;
  std::shared_ptr<ServerState> state_;
  boost::beast::flat_buffer buffer_;
  std::shared_ptr<const std::string> message_;  ///< being sent
  std::chrono::steady_clock::time_point sent_at_;
  bool open_ = false;
  int commands_ = 0;  ///< in the present second
  std::chrono::steady_clock::time_point commands_since_;
};

// A page that is connected by WebSocket. Only the newest message of each kind is kept for sending,
// so a slow page misses frames but no rows.

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

// A program that is connected to /api/events. It gets the newest pose, and every decision, loop and
// event since it connected, as JSON texts. A slow client misses poses.

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
