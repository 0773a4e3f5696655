// SPDX-License-Identifier: BSD-3-Clause
#include "http_response.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include "bundle.hpp"

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

}  // namespace tolman::web_viewer
