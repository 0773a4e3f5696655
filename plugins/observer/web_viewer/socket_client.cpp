// SPDX-License-Identifier: BSD-3-Clause
#include "socket_client.hpp"

#include <utility>

namespace tolman::web_viewer {

namespace {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kMaxCommandBytes = 4096;
constexpr int kMaxCommands = 50;  // per second
constexpr auto kClosing = 1s;     // for the client's answer to a close frame

}  // namespace

SocketClient::SocketClient(beast::tcp_stream&& stream, std::shared_ptr<ServerState> state,
                           Messages messages)
    : stream_(std::in_place, std::move(stream)),
      closing_(stream_->get_executor()),
      state_(std::move(state)),
      buffer_(kMaxCommandBytes) {
  stream_->binary(messages == Messages::Binary);
  ++state_->connections;
  state_->clients.insert(this);
}

SocketClient::~SocketClient() {
  state_->clients.erase(this);
  --state_->connections;
}

void SocketClient::start(const Request& request) {
  beast::get_lowest_layer(*stream_).expires_never();
  stream_->set_option(websocket::stream_base::timeout{5s, 30s, true});
  stream_->set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(beast::http::field::server, "tolman");
  }));
  stream_->read_message_max(kMaxCommandBytes);
  stream_->auto_fragment(false);
  stream_->async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->open_ = true;
    self->opened();
    self->read();
  });
}

void SocketClient::read() {
  stream_->async_read(buffer_,
                      [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
                        if (error) return self->disconnect();
                        const auto data = self->buffer_.cdata();
                        const std::string command(static_cast<const char*>(data.data()), bytes);
                        self->buffer_.consume(bytes);
                        if (!self->stream_->got_text()) return self->refuse();
                        if (self->tooMany() || !self->onCommand(command)) return self->refuse();
                        self->read();
                      });
}

bool SocketClient::tooMany() {
  const Clock::time_point now = Clock::now();
  if (now - commands_since_ > 1s) {
    commands_since_ = now;
    commands_ = 0;
  }
  return ++commands_ > kMaxCommands;
}

void SocketClient::refuse() { close(websocket::close_code::policy_error); }

void SocketClient::close(websocket::close_code code) {
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

void SocketClient::disconnect() {
  open_ = false;
  if (!stream_) return;
  beast::error_code ignored;
  beast::get_lowest_layer(*stream_).socket().close(ignored);
}

bool SocketClient::isStalled(Clock::duration patience) const {
  return message_ != nullptr && Clock::now() - sent_at_ > patience;
}

void SocketClient::send(std::shared_ptr<const std::string> message) {
  message_ = std::move(message);
  sent_at_ = Clock::now();
  stream_->async_write(boost::asio::buffer(*message_),
                       [self = shared_from_this()](beast::error_code error, std::size_t) {
                         self->message_.reset();
                         if (error) return self->disconnect();
                         self->sendNext();
                       });
}

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
  const auto json = nlohmann::json::parse(command, nullptr, false);
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

void EventClient::opened() {
  next_ = state().store.messages().end();
  sendNext();
}

void EventClient::sendNext() {
  if (!canSend()) return;
  const RunStore& store = state().store;
  if (auto message = store.messages().next(next_)) return send(std::move(message));
  if (store.pose().frame > sent_pose_) {
    sent_pose_ = store.pose().frame;
    return send(std::make_shared<const std::string>(poseMessage(store.pose())));
  }
  if (!store.hasEnded()) return;
  if (!std::exchange(end_sent_, true)) {
    return send(
        std::make_shared<const std::string>(endMessage(store.endState(), store.pose().frame)));
  }
  if (!state().keeps_open) close(boost::beast::websocket::close_code::normal);
}

}  // namespace tolman::web_viewer
