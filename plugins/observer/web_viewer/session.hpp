// SPDX-License-Identifier: BSD-3-Clause
// One HTTP connection: reads requests with a limit on everything, answers one after the other, and
// hands a checked WebSocket handshake on to a LiveClient.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <memory>
#include <optional>

#include "answers.hpp"
#include "hall.hpp"

namespace tolman::web_viewer {

class Session : public std::enable_shared_from_this<Session> {
 public:
  Session(boost::asio::ip::tcp::socket&& socket, std::shared_ptr<Hall> hall);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;
  void start() { read(); }

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
  void read();
  void onRead(boost::beast::error_code error);
  void serve();
  bool comesFromOwnPage() const;
  void upgrade();
  void reply(Answer answer, bool keep_alive);
  void hangUp();
  void drain(std::size_t most);
  std::string_view header(boost::beast::http::field field) const;

  boost::beast::tcp_stream stream_;
  std::shared_ptr<Hall> hall_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;  ///< afresh for each request
};

}  // namespace tolman::web_viewer
