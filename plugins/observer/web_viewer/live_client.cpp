// SPDX-License-Identifier: BSD-3-Clause
#include "live_client.hpp"

#include <utility>

#include "base/bounded_json.hpp"

namespace tolman::web_viewer {
namespace {

constexpr std::size_t kMaxSentRows = 2000;  // in one message
constexpr std::size_t kMaxSentEvents = 100;

}  // namespace

void LiveClient::opened() {
  const RunStore& store = state().store;
  next_row_ = store.rows().size();
  next_event_ = 0;
  frame_waits_ = store.newest() != nullptr;
  graph_waits_ = store.graph() != nullptr;
  end_waits_ = store.hasEnded();
  send(std::make_shared<const std::string>(encodeContainer(headerJson(store.hello()), {})));
}

/// The only command is {"type":"flow","live":true|false}: whether to send images and arrays.
bool LiveClient::onCommand(std::string_view command) {
  const auto json = bounded_json::parse<nlohmann::json>(command);
  const bool known = json.is_object() && json.size() == 2 && json.contains("type") &&
                     json["type"] == "flow" && json.contains("live") && json["live"].is_boolean();
  if (known) wants_arrays_ = json["live"].get<bool>();
  return known;
}

void LiveClient::newFrame() {
  if (frame_waits_ && isOpen()) ++dropped_;
  frame_waits_ = true;
  sendNext();
}

void LiveClient::newGraph() {
  graph_waits_ = true;
  sendNext();
}

void LiveClient::runEnded() {
  end_waits_ = !end_sent_;
  sendNext();
}

void LiveClient::sendNext() {
  if (!canSend()) return;
  const RunStore& store = state().store;
  if (std::exchange(graph_waits_, false)) return send(store.graph());
  const bool fresh = std::exchange(frame_waits_, false);
  if (fresh || (next_row_ < store.rows().size() && store.newest())) {
    return send(std::make_shared<const std::string>(frameMessage(fresh && wants_arrays_)));
  }
  if (std::exchange(end_waits_, false)) {
    end_sent_ = true;
    return send(std::make_shared<const std::string>(store.endMessage()));
  }
  if (store.hasEnded() && !state().keeps_open) close(boost::beast::websocket::close_code::normal);
}

std::string LiveClient::frameMessage(bool with_arrays) {
  const RunStore& store = state().store;
  const EncodedFrame& newest = *store.newest();
  FrameHeader header = newest.header;
  header.rows_from = static_cast<std::int64_t>(next_row_);
  header.dropped = dropped_;
  header.events = shortened(store.events().since(next_event_, kMaxSentEvents));
  next_event_ = store.events().end();
  std::vector<PackedArray> arrays = {store.rows().read(next_row_, kMaxSentRows)};
  next_row_ += arrays.front().shape.front();
  if (with_arrays) arrays.insert(arrays.end(), newest.arrays.begin(), newest.arrays.end());
  return encodeContainer(headerJson(header), arrays);
}

}  // namespace tolman::web_viewer
