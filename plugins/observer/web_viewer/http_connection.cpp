// SPDX-License-Identifier: BSD-3-Clause
#include "http_connection.hpp"

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "http_response.hpp"
#include "socket_client.hpp"

namespace tolman::web_viewer {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using namespace std::chrono_literals;

constexpr std::uint32_t kMaxHeaderBytes = 8192;
constexpr auto kRequestTimeout = 15s;  // to receive a whole request
constexpr auto kCloseTimeout = 1s;
constexpr std::size_t kMaxDrained = 1U << 20U;  // bytes
constexpr auto kWriteTimeout = 30s;             // to send a response
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; connect-src "
    "'self' ws:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'";

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// HTTP status for an error of the parser; 0 when the client has closed the connection.
unsigned errorStatusOf(const beast::error_code& error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) return 431;
  if (error == http::error::end_of_stream || error == http::error::partial_message) return 0;
  return error.category() == beast::error_code(http::error::bad_method).category() ? 400 : 0;
}

}  // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket&& socket,
                               std::shared_ptr<ServerState> state)
    : stream_(std::move(socket)), state_(std::move(state)), buffer_(2 * kMaxHeaderBytes) {
  ++state_->connections;
}

HttpConnection::~HttpConnection() { --state_->connections; }

void HttpConnection::read() {
  parser_.emplace();
  parser_->header_limit(kMaxHeaderBytes);
  parser_->body_limit(0);
  stream_.expires_after(kRequestTimeout);
  http::async_read(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](beast::error_code error, std::size_t) { self->onRead(error); });
}

void HttpConnection::onRead(beast::error_code error) {
  if (!error) return serve();
  const unsigned status = errorStatusOf(error);
  if (status == 0) return closeAfterReply();
  reply(errorResponse(status), false);
}

std::string_view HttpConnection::header(http::field field) const {
  return view(parser_->get()[field]);
}

bool HttpConnection::comesFromOwnPage() const {
  beast::error_code error;
  const auto local = stream_.socket().local_endpoint(error);
  const std::string_view host = header(http::field::host);
  if (error || !isOwnHost(host, local.address())) return false;
  const std::string_view origin = header(http::field::origin);
  return origin.empty() || isOwnOrigin(origin, host);
}

void HttpConnection::serve() {
  const auto& request = parser_->get();
  const bool keep_alive = request.keep_alive();
  if (request.count(http::field::host) != 1 || request.count(http::field::origin) > 1) {
    return reply(errorResponse(400), false);
  }
  if (!comesFromOwnPage()) return reply(errorResponse(403), false);
  if (beast::websocket::is_upgrade(request)) return upgrade();
  const std::string_view target = view(request.target());
  if (target == "/live" || target == "/api/events") return reply(errorResponse(400), keep_alive);
  if (state_->refresh && target.starts_with("/api/")) state_->refresh();
  reply(respond(view(request.method_string()), target, state_->store), keep_alive);
}

void HttpConnection::upgrade() {
  constexpr std::size_t kKeyLength = 24;  // 16 bytes in base64, RFC 6455
  const std::string_view target = view(parser_->get().target());
  if (target != "/live" && target != "/api/events") return reply(errorResponse(404), false);
  if (header(http::field::sec_websocket_key).size() != kKeyLength) {
    return reply(errorResponse(400), false);
  }
  if (state_->clients.size() >= state_->most_clients) return reply(errorResponse(503), false);
  // A client gets no messages from before its connection.
  if (state_->refresh && target == "/api/events") state_->refresh();
  if (target == "/live") {
    std::make_shared<LiveClient>(std::move(stream_), state_)->start(parser_->get());
  } else {
    std::make_shared<EventClient>(std::move(stream_), state_)->start(parser_->get());
  }
}

void HttpConnection::reply(HttpResponse answer, bool keep_alive) {
  auto response = std::make_shared<http::response<http::string_body>>(
      static_cast<http::status>(answer.status), 11);
  response->set(http::field::server, "tolman");
  response->set(http::field::content_type, answer.type);
  response->set(http::field::cache_control, answer.cacheable ? "no-cache" : "no-store");
  response->set("Content-Security-Policy", kPolicy);
  response->set("X-Content-Type-Options", "nosniff");
  response->set("Referrer-Policy", "no-referrer");
  response->set("Cross-Origin-Resource-Policy", "same-origin");
  if (answer.status == 405) response->set(http::field::allow, "GET, HEAD");
  response->keep_alive(keep_alive);
  response->content_length(answer.body.size());
  if (parser_->get().method() != http::verb::head) response->body() = std::move(answer.body);
  stream_.expires_after(kWriteTimeout);
  http::async_write(stream_, *response,
                    [self = shared_from_this(), response](beast::error_code error, std::size_t) {
                      if (error || !response->keep_alive()) return self->closeAfterReply();
                      self->read();
                    });
}

/// Closing a socket with unread bytes resets the connection, and the response could be lost.
void HttpConnection::closeAfterReply() {
  beast::error_code ignored;
  stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  stream_.expires_after(kCloseTimeout);
  drain(kMaxDrained);
}

void HttpConnection::drain(std::size_t most) {
  buffer_.clear();
  stream_.async_read_some(
      buffer_.prepare(kMaxHeaderBytes),
      [self = shared_from_this(), most](beast::error_code error, std::size_t bytes) {
        if (!error && bytes < most) self->drain(most - bytes);
      });
}

}  // namespace tolman::web_viewer
