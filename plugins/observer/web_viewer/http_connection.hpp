// SPDX-License-Identifier: BSD-3-Clause
// An HTTP connection. Size and time of each request are limited. A checked WebSocket handshake is
// passed on to a LiveClient.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <memory>
#include <optional>

#include "http_response.hpp"
#include "server.hpp"

namespace tolman::web_viewer {

class HttpConnection : public std::enable_shared_from_this<HttpConnection> {
 public:
  HttpConnection(boost::asio::ip::tcp::socket&& socket, std::shared_ptr<ServerState> state);
  ~HttpConnection();
  HttpConnection(const HttpConnection&) = delete;
  HttpConnection& operator=(const HttpConnection&) = delete;
  void start() { read(); }

 private:
  using Parser = boost::beast::http::request_parser<boost::beast::http::empty_body>;
  void read();
  void onRead(boost::beast::error_code error);
  void serve();
  bool comesFromOwnPage() const;
  void upgrade();
  void reply(HttpResponse answer, bool keep_alive);
  void closeAfterReply();
  void drain(std::size_t most);
  std::string_view header(boost::beast::http::field field) const;

  boost::beast::tcp_stream stream_;
  std::shared_ptr<ServerState> state_;
  boost::beast::flat_buffer buffer_;
  std::optional<Parser> parser_;  ///< a new one for each request
};

}  // namespace tolman::web_viewer
