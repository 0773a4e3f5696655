// SPDX-License-Identifier: BSD-3-Clause
#include "live_client.hpp"

#include <utility>

namespace tolman::web_viewer {
namespace {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kMaxSentRows = 2000;  // in one message
constexpr std::size_t kMaxSentEvents = 100;
constexpr std::size_t kMaxCommandBytes = 4096;
constexpr int kMaxCommands = 50;  // per second
constexpr auto kClosing = 1s;     // for the client's answer to a close frame

}  // namespace

LiveClient::LiveClient(beast::tcp_stream&& stream, std::shared_ptr<ServerState> state)
    : stream_(std::in_place, std::move(stream)),
      closing_(stream_->get_executor()),
      state_(std::move(state)),
      buffer_(kMaxCommandBytes) {
  ++state_->connections;
  state_->clients.insert(this);
}

LiveClient::~LiveClient() {
  state_->clients.erase(this);
  --state_->connections;
}

void LiveClient::start(const Request& request) {
  beast::get_lowest_layer(*stream_).expires_never();
  stream_->set_option(websocket::stream_base::timeout{5s, 30s, true});
  stream_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(beast::http::field::server, "tolman");
  }));
  stream_->read_message_max(kMaxCommandBytes);
  stream_->auto_fragment(false);
  stream_->binary(true);
  stream_->async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->sendHello();
    self->read();
  });
}

void LiveClient::sendHello() {
  open_ = true;
  next_row_ = state_->store.rows().size();
  next_event_ = 0;
  frame_waits_ = state_->store.newest() != nullptr;
  graph_waits_ = state_->store.graph() != nullptr;
  end_waits_ = state_->store.hasEnded();
  send(std::make_shared<const std::string>(encodeContainer(headerJson(state_->store.hello()), {})));
}

void LiveClient::read() {
  stream_->async_read(buffer_,
                      [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
                        if (error) return self->disconnect();
                        const auto data = self->buffer_.cdata();
                        const std::string command(static_cast<const char*>(data.data()), bytes);
                        self->buffer_.consume(bytes);
                        if (!self->stream_->got_text()) return self->refuse();
                        self->onCommand(command);
                      });
}

/// There is one command: {"type":"flow","live":true|false}, whether to send images and arrays.
void LiveClient::onCommand(std::string_view command) {
  const Clock::time_point now = Clock::now();
  if (now - commands_since_ > 1s) {
    commands_since_ = now;
    commands_ = 0;
  }
  const auto json = nlohmann::json::parse(command, nullptr, false);
  const bool known = json.is_object() && json.size() == 2 && json.contains("type") &&
                     json["type"] == "flow" && json.contains("live") && json["live"].is_boolean();
  if (!known || ++commands_ > kMaxCommands) return refuse();
  wants_arrays_ = json["live"].get<bool>();
  read();
}

void LiveClient::refuse() { close(websocket::close_code::policy_error); }

void LiveClient::close(websocket::close_code code) {
  if (!std::exchange(open_, false)) return;
  // After some inputs (one is in the fuzz corpus) neither the read nor the close of Beast 1.74 ever
  // completes, not even when the socket is closed: only destroying the stream ends them.
  closing_.expires_after(kClosing);
  closing_.async_wait([self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->disconnect();
    self->stream_.reset();
  });
  stream_->async_close(code, [self = shared_from_this()](beast::error_code) {
    self->closing_.cancel();
    self->disconnect();
  });
}

void LiveClient::disconnect() {
  open_ = false;
  if (!stream_) return;
  beast::error_code ignored;
  beast::get_lowest_layer(*stream_).socket().close(ignored);
}

bool LiveClient::isStalled(Clock::duration patience) const {
  return message_ != nullptr && Clock::now() - sent_at_ > patience;
}

void LiveClient::newFrame() {
  if (frame_waits_ && open_) ++dropped_;
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
  if (!open_ || message_) return;
  const RunStore& store = state_->store;
  if (std::exchange(graph_waits_, false)) return send(store.graph());
  const bool fresh = std::exchange(frame_waits_, false);
  if (fresh || (next_row_ < store.rows().size() && store.newest())) {
    return send(std::make_shared<const std::string>(frameMessage(fresh && wants_arrays_)));
  }
  if (std::exchange(end_waits_, false)) {
    end_sent_ = true;
    return send(std::make_shared<const std::string>(store.endMessage()));
  }
  if (store.hasEnded() && !state_->keeps_open) close(websocket::close_code::normal);
}

std::string LiveClient::frameMessage(bool with_arrays) {
  const RunStore& store = state_->store;
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

void LiveClient::send(std::shared_ptr<const std::string> message) {
  message_ = std::move(message);
  sent_at_ = Clock::now();
  stream_->async_write(boost::asio::buffer(*message_),
                       [self = shared_from_this()](beast::error_code error, std::size_t) {
                         self->message_.reset();
                         if (error) return self->disconnect();
                         self->sendNext();
                       });
}

}  // namespace tolman::web_viewer
