// SPDX-License-Identifier: BSD-3-Clause
#include "answers.hpp"

#include <charconv>
#include <optional>

#include "bundle.hpp"

namespace tolman::web_viewer {
namespace {

constexpr std::size_t kMostRows = 4096;  // an answer
constexpr const char* kBinary = "application/octet-stream";

/// Nothing for anything but digits.
std::optional<std::int64_t> number(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (!whole || text.starts_with('-')) return std::nullopt;
  return value;
}

Answer history(std::string_view query, const Gallery& gallery) {
  std::size_t from = 0;
  std::size_t count = kMostRows;
  while (!query.empty()) {
    const std::string_view part = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), part.size() + 1));
    const std::size_t equals = part.find('=');
    if (equals == std::string_view::npos) return refusal(400);
    const auto value = number(part.substr(equals + 1));
    const std::string_view key = part.substr(0, equals);
    if (!value || (key != "from" && key != "count")) return refusal(400);
    (key == "from" ? from : count) = static_cast<std::size_t>(*value);
  }
  auto rows =
      std::make_shared<const std::string>(gallery.rows().read(from, std::min(count, kMostRows)));
  const nlohmann::json header = {
      {"type", "history"}, {"from", from}, {"total", gallery.rows().size()}};
  const std::size_t n = rows->size() / sizeof(HistoryRow);
  return {200, kBinary,
          encodeContainer(header, {{"rows", Element::F64, {n, kColumns}, std::move(rows)}})};
}

Answer storedFrame(std::string_view text, const Gallery& gallery) {
  const auto frame = number(text);
  if (!frame) return refusal(400);
  const auto stored = gallery.frames().atOrBefore(*frame);
  if (!stored) return refusal(404);
  return {200, kBinary, *gallery.frames().at(*stored)};
}

Answer templateView(std::string_view text, const Gallery& gallery) {
  const auto id = number(text);
  if (!id) return refusal(400);
  auto view = gallery.views().at(*id);
  if (!view) return refusal(404);
  return {200, "image/jpeg", *std::move(view)};
}

Answer api(std::string_view path, std::string_view query, const Gallery& gallery) {
  constexpr std::string_view kFrame = "/api/frame/";
  constexpr std::string_view kTemplate = "/api/template/";
  if (path == "/api/history") return history(query, gallery);
  if (!query.empty()) return refusal(400);
  if (path == "/api/run") return {200, "application/json", jsonText(gallery.run())};
  if (path.starts_with(kFrame)) return storedFrame(path.substr(kFrame.size()), gallery);
  if (path.starts_with(kTemplate)) return templateView(path.substr(kTemplate.size()), gallery);
  if (path != "/api/graph") return refusal(404);
  if (!gallery.graph()) return {200, kBinary, FlatGraph().encode()};
  return {200, kBinary, *gallery.graph()};
}

Answer file(std::string_view path) {
  const std::string_view wanted = path == "/" ? "index.html" : path.substr(1);
  for (const BundleFile& known : bundle()) {
    if (known.path != wanted) continue;
    return {200, std::string(mediaType(known.path)), std::string(known.bytes), true};
  }
  return refusal(404);
}

}  // namespace

Answer refusal(unsigned status) {
  switch (status) {
    case 400:
      return {400, "text/plain; charset=utf-8", "This is no request that the viewer knows.\n"};
    case 403:
      return {403, "text/plain; charset=utf-8",
              "The viewer answers to its own address only; see the line that it printed.\n"};
    case 404:
      return {404, "text/plain; charset=utf-8", "There is nothing here.\n"};
    case 405:
      return {405, "text/plain; charset=utf-8", "Only GET and HEAD.\n"};
    case 431:
      return {431, "text/plain; charset=utf-8", "The header of the request is too large.\n"};
    default:
      return {503, "text/plain; charset=utf-8",
              "The viewer has as many clients as its parameter 'clients' allows.\n"};
  }
}

Answer answer(std::string_view method, std::string_view target, const Gallery& gallery) {
  if (method != "GET" && method != "HEAD") return refusal(405);
  if (!target.starts_with('/')) return refusal(400);
  const std::size_t mark = target.find('?');
  const std::string_view path = target.substr(0, mark);
  const std::string_view query =
      mark == std::string_view::npos ? std::string_view() : target.substr(mark + 1);
  if (path.starts_with("/api/")) return api(path, query, gallery);
  return file(path);
}

}  // namespace tolman::web_viewer
