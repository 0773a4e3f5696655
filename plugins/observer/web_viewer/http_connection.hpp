// SPDX-License-Identifier: BSD-3-Clause
// Requests and answers by HTTP, and the connection that handles them.
//
// Values in the query of a request, in which a client may write any byte as %XX (RFC 3986, section
// 2.1), and a blank as + (forms of HTML).
#pragma once

#include <boost/asio/ip/address.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <charconv>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "run_store.hpp"
#include "server.hpp"

namespace tolman::web_viewer {

/// The value in plain text. A % without two hexadecimal digits stays.
inline std::string decodedValue(std::string_view text) {
  std::string plain;
  for (std::size_t at = 0; at < text.size(); ++at) {
    unsigned byte = 0;
    const char* digits = text.data() + at + 1;
    const bool coded = text[at] == '%' && at + 2 < text.size() &&
                       std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2;
    plain += coded ? static_cast<char>(byte) : text[at] == '+' ? ' ' : text[at];
    if (coded) at += 2;
  }
  return plain;
}

// Checks of request headers, against web sites that make a browser send requests to this server
// (DNS rebinding, cross-site requests).

/// Whether a Host header names this server: localhost, a loopback address, or the address that the
/// connection was made to. Other host names are refused, because the DNS of any site can resolve to
/// this machine. The port is not compared, so that tunnels work.
bool isOwnHost(std::string_view host, const boost::asio::ip::address& local);

/// Whether an Origin header names the page that `host` serves.
bool isOwnOrigin(std::string_view origin, std::string_view host);

// The response to each request target, independent of sockets.

struct HttpResponse {
  unsigned status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::string body;
  bool cacheable = false;
};

/// `target`: as in the request line. Paths are looked up in a table, never opened as files.
HttpResponse respond(std::string_view method, std::string_view target, const RunStore& store);

HttpResponse errorResponse(unsigned status);

// An HTTP connection. Size and time of each request are limited. A checked WebSocket handshake is
// passed on to a LiveClient.

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
