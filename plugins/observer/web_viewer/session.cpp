// SPDX-License-Identifier: BSD-3-Clause
#include "session.hpp"

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <utility>

#include "live_client.hpp"
#include "request_check.hpp"

namespace tolman::web_viewer {
namespace {

namespace beast = boost::beast;
namespace http = boost::beast::http;
using namespace std::chrono_literals;

constexpr std::uint32_t kMostHeaderBytes = 8192;
constexpr auto kPatience = 15s;  // for a whole request, and for the next one
constexpr auto kFarewell = 1s;
constexpr std::size_t kMostDrained = 1U << 20U;  // bytes
constexpr auto kReadPatience = 30s;              // for a client to take an answer
constexpr const char* kPolicy =
    "default-src 'self'; img-src 'self' blob: data:; style-src 'self' 'unsafe-inline'; connect-src "
    "'self' ws:; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'none'; object-src 'none'";

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

/// How to refuse what the parser could not read; 0 for a connection that is simply over.
unsigned refusalOf(const beast::error_code& error) {
  if (error == http::error::header_limit || error == http::error::buffer_overflow) return 431;
  if (error == http::error::end_of_stream || error == http::error::partial_message) return 0;
  return error.category() == beast::error_code(http::error::bad_method).category() ? 400 : 0;
}

}  // namespace

Session::Session(boost::asio::ip::tcp::socket&& socket, std::shared_ptr<Hall> hall)
    : stream_(std::move(socket)), hall_(std::move(hall)), buffer_(2 * kMostHeaderBytes) {
  ++hall_->connections;
}

Session::~Session() { --hall_->connections; }

void Session::read() {
  parser_.emplace();
  parser_->header_limit(kMostHeaderBytes);
  parser_->body_limit(0);
  stream_.expires_after(kPatience);
  http::async_read(
      stream_, buffer_, *parser_,
      [self = shared_from_this()](beast::error_code error, std::size_t) { self->onRead(error); });
}

void Session::onRead(beast::error_code error) {
  if (!error) return serve();
  const unsigned status = refusalOf(error);
  if (status == 0) return hangUp();
  reply(refusal(status), false);
}

std::string_view Session::header(http::field field) const { return view(parser_->get()[field]); }

bool Session::comesFromOwnPage() const {
  beast::error_code error;
  const auto local = stream_.socket().local_endpoint(error);
  const std::string_view host = header(http::field::host);
  if (error || !isOwnHost(host, local.address())) return false;
  const std::string_view origin = header(http::field::origin);
  return origin.empty() || isOwnOrigin(origin, host);
}

void Session::serve() {
  const auto& request = parser_->get();
  const bool keep_alive = request.keep_alive();
  if (request.count(http::field::host) != 1 || request.count(http::field::origin) > 1) {
    return reply(refusal(400), false);
  }
  if (!comesFromOwnPage()) return reply(refusal(403), false);
  if (beast::websocket::is_upgrade(request)) return upgrade();
  if (view(request.target()) == "/live") return reply(refusal(400), keep_alive);
  reply(answer(view(request.method_string()), view(request.target()), hall_->gallery), keep_alive);
}

void Session::upgrade() {
  if (view(parser_->get().target()) != "/live") return reply(refusal(404), false);
  if (hall_->clients.size() >= hall_->most_clients) return reply(refusal(503), false);
  std::make_shared<LiveClient>(std::move(stream_), hall_)->start(parser_->get());
}

void Session::reply(Answer answer, bool keep_alive) {
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
  stream_.expires_after(kReadPatience);
  http::async_write(stream_, *response,
                    [self = shared_from_this(), response](beast::error_code error, std::size_t) {
                      if (error || !response->keep_alive()) return self->hangUp();
                      self->read();
                    });
}

/// To close while bytes wait unread would reset the connection, and the answer would be lost.
void Session::hangUp() {
  beast::error_code ignored;
  stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
  stream_.expires_after(kFarewell);
  drain(kMostDrained);
}

void Session::drain(std::size_t most) {
  buffer_.clear();
  stream_.async_read_some(
      buffer_.prepare(kMostHeaderBytes),
      [self = shared_from_this(), most](beast::error_code error, std::size_t bytes) {
        if (!error && bytes < most) self->drain(most - bytes);
      });
}

}  // namespace tolman::web_viewer
