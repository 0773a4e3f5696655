// SPDX-License-Identifier: BSD-3-Clause
#include "http_connection.hpp"

#include <algorithm>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>
#include <charconv>
#include <optional>
#include <string>
#include <utility>

#include "bundle.hpp"
#include "socket_client.hpp"

namespace tolman::web_viewer {

namespace {

std::string lower(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return small;
}

bool isPort(std::string_view text) {
  return !text.empty() && text.size() <= 5 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// The host without port and brackets of IPv6; empty when malformed.
std::string nameOf(std::string_view host) {
  std::string_view name = host;
  std::string_view rest;
  if (host.starts_with('[')) {
    const std::size_t end = host.find(']');
    if (end == std::string_view::npos) return {};
    name = host.substr(1, end - 1);
    rest = host.substr(end + 1);
  } else {
    const std::size_t colon = host.find(':');
    name = host.substr(0, colon);
    if (colon != std::string_view::npos) rest = host.substr(colon);
  }
  if (!rest.empty() && (rest[0] != ':' || !isPort(rest.substr(1)))) return {};
  return lower(name);
}

/// Turns ::ffff:1.2.3.4 into 1.2.3.4.
boost::asio::ip::address plain(const boost::asio::ip::address& address) {
  if (address.is_v6() && address.to_v6().is_v4_mapped()) {
    return boost::asio::ip::make_address_v4(boost::asio::ip::v4_mapped, address.to_v6());
  }
  return address;
}

}  // namespace

bool isOwnHost(std::string_view host, const boost::asio::ip::address& local) {
  const std::string name = nameOf(host);
  if (name == "localhost") return true;
  boost::system::error_code error;
  const auto address = boost::asio::ip::make_address(name, error);
  if (error) return false;
  return address.is_loopback() || plain(address) == plain(local);
}

bool isOwnOrigin(std::string_view origin, std::string_view host) {
  return lower(origin) == "http://" + lower(host);
}

namespace {

constexpr std::size_t kMaxRows = 4096;  // of one response
constexpr const char* kBinary = "application/octet-stream";

/// A non-negative decimal number; empty for any other text.
std::optional<std::int64_t> number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || text.starts_with('-')) return std::nullopt;
  return value;
}

/// For a number in a request that is none.
HttpResponse noNumber(const std::string& what, std::string_view given) {
  constexpr std::size_t kShown = 40;
  std::string shown(given.substr(0, kShown));
  for (char& c : shown) c = c > ' ' && c <= '~' ? c : '?';
  return {400, "text/plain; charset=utf-8",
          "'" + shown + "' is no " + what + ": give a whole number from 0.\n"};
}

HttpResponse history(std::string_view query, const RunStore& store) {
  std::size_t from = 0;
  std::size_t count = kMaxRows;
  while (!query.empty()) {
    const std::string_view part = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) return errorResponse(400);
    const auto value = number(decodedValue(part.substr(equals + 1)));
    const std::string_view key = part.substr(0, equals);
    if (key != "from" && key != "count") return errorResponse(400);
    if (!value) return noNumber("value of " + std::string(key), part.substr(equals + 1));
    (key == "from" ? from : count) = static_cast<std::size_t>(*value);
  }
  const HistoryHeader header{static_cast<std::int64_t>(from),
                             static_cast<std::int64_t>(store.rows().size())};
  return {
      200, kBinary,
      encodeContainer(headerJson(header), {store.rows().read(from, std::min(count, kMaxRows))})};
}

HttpResponse storedFrame(std::string_view text, const RunStore& store) {
  const auto frame = number(text);
  if (!frame) return noNumber("frame", text);
  const auto stored = store.frames().atOrBefore(*frame);
  if (!stored) return errorResponse(404);
  return {200, kBinary, *store.frames().at(*stored)};
}

HttpResponse templateImage(std::string_view text, const RunStore& store) {
  const auto id = number(text);
  if (!id) return noNumber("template", text);
  auto image = store.templateImages().at(*id);
  if (!image) return errorResponse(404);
  return {200, "image/jpeg", *std::move(image)};
}

HttpResponse json(ApiAnswer answer) {
  return {answer.status, "application/json", std::move(answer.json) + "\n"};
}

HttpResponse api(std::string_view path, std::string_view query, const RunStore& store) {
  constexpr std::string_view kFrame = "/api/frame/";
  constexpr std::string_view kTemplate = "/api/template/";
  if (path == "/api/history") return history(query, store);
  if (path == "/api/plan") return json(planAnswer(store.flatGraph(), store.pose(), query));
  if (!query.empty()) return errorResponse(400);
  if (path == "/api/run") return {200, "application/json", jsonText(headerJson(store.hello()))};
  if (path == "/api/pose") return json(poseAnswer(store.pose()));
  if (path == "/api/map") return json(mapAnswer(store.flatGraph()));
  if (path.starts_with(kFrame)) return storedFrame(path.substr(kFrame.size()), store);
  if (path.starts_with(kTemplate)) return templateImage(path.substr(kTemplate.size()), store);
  if (path != "/api/graph") return errorResponse(404);
  if (!store.graph()) return {200, kBinary, FlatGraph().encode()};
  return {200, kBinary, *store.graph()};
}

HttpResponse file(std::string_view path) {
  const std::string_view wanted = path == "/" ? "index.html" : path.substr(1);
  for (const BundleFile& known : bundle()) {
    if (known.path != wanted) continue;
    return {200, std::string(mediaType(known.path)), std::string(known.bytes), true};
  }
  return errorResponse(404);
}

}  // namespace

HttpResponse errorResponse(unsigned status) {
  switch (status) {
    case 400:
      return {400, "text/plain; charset=utf-8", "Unknown request.\n"};
    case 403:
      return {403, "text/plain; charset=utf-8",
              "The viewer serves requests to its own address only; the log has the address.\n"};
    case 404:
      return {404, "text/plain; charset=utf-8", "Not found.\n"};
    case 405:
      return {405, "text/plain; charset=utf-8", "Only GET and HEAD are allowed.\n"};
    case 431:
      return {431, "text/plain; charset=utf-8", "The header of the request is too large.\n"};
    default:
      return {503, "text/plain; charset=utf-8",
              "The viewer has the maximum number of clients; see its parameter 'clients'.\n"};
  }
}

HttpResponse respond(std::string_view method, std::string_view target, const RunStore& store) {
  if (method != "GET" && method != "HEAD") return errorResponse(405);
  if (!target.starts_with('/')) return errorResponse(400);
  const std::size_t mark = target.find('?');
  const std::string_view path = target.substr(0, mark);
  const std::string_view query =
      mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
  if (path.starts_with("/api/")) return api(path, query, store);
  return file(path);
}

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
