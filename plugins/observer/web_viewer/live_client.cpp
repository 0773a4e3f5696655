// SPDX-License-Identifier: BSD-3-Clause
#include "live_client.hpp"

#include <utility>

namespace tolman::web_viewer {
namespace {

namespace beast = boost::beast;
namespace websocket = boost::beast::websocket;
using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr std::size_t kMostRows = 2000;  // a message
constexpr std::size_t kMostEvents = 100;
constexpr std::size_t kMostCommandBytes = 4096;
constexpr int kMostCommands = 50;  // a second

}  // namespace

LiveClient::LiveClient(beast::tcp_stream&& stream, std::shared_ptr<Hall> hall)
    : stream_(std::move(stream)), hall_(std::move(hall)), buffer_(kMostCommandBytes) {
  ++hall_->connections;
  hall_->clients.insert(this);
}

LiveClient::~LiveClient() {
  hall_->clients.erase(this);
  --hall_->connections;
}

void LiveClient::start(const Request& request) {
  beast::get_lowest_layer(stream_).expires_never();
  stream_.set_option(websocket::stream_base::timeout{5s, 30s, true});
  stream_.set_option(websocket::stream_base::decorator([](websocket::response_type& response) {
    response.set(beast::http::field::server, "tolman");
  }));
  stream_.read_message_max(kMostCommandBytes);
  stream_.auto_fragment(false);
  stream_.binary(true);
  stream_.async_accept(request, [self = shared_from_this()](beast::error_code error) {
    if (error) return;
    self->greet();
    self->read();
  });
}

void LiveClient::greet() {
  open_ = true;
  next_row_ = hall_->gallery.rows().size();
  next_event_ = 0;
  frame_waits_ = hall_->gallery.newest() != nullptr;
  graph_waits_ = hall_->gallery.graph() != nullptr;
  end_waits_ = hall_->gallery.hasEnded();
  send(std::make_shared<const std::string>(helloMessage()));
}

std::string LiveClient::helloMessage() {
  const Gallery& gallery = hall_->gallery;
  nlohmann::json header = gallery.run();
  header["type"] = "hello";
  header["rows"] = gallery.rows().size();
  header["newest"] = gallery.newest() ? gallery.newest()->encoded.frame : -1;
  return encodeContainer(std::move(header), {});
}

void LiveClient::read() {
  stream_.async_read(buffer_,
                     [self = shared_from_this()](beast::error_code error, std::size_t bytes) {
                       if (error) return self->drop();
                       const auto data = self->buffer_.cdata();
                       const std::string command(static_cast<const char*>(data.data()), bytes);
                       self->buffer_.consume(bytes);
                       if (!self->stream_.got_text()) return self->refuse();
                       self->obey(command);
                     });
}

/// The one command that there is: {"type":"flow","live":true|false}.
void LiveClient::obey(std::string_view command) {
  const Clock::time_point now = Clock::now();
  if (now - commands_since_ > 1s) {
    commands_since_ = now;
    commands_ = 0;
  }
  const auto json = nlohmann::json::parse(command, nullptr, false);
  const bool known = json.is_object() && json.size() == 2 && json.contains("type") &&
                     json["type"] == "flow" && json.contains("live") && json["live"].is_boolean();
  if (!known || ++commands_ > kMostCommands) return refuse();
  wants_pictures_ = json["live"].get<bool>();
  read();
}

void LiveClient::refuse() { close(websocket::close_code::policy_error); }

void LiveClient::close(websocket::close_code code) {
  if (!std::exchange(open_, false)) return;
  stream_.async_close(code, [self = shared_from_this()](beast::error_code) { self->drop(); });
}

void LiveClient::drop() {
  open_ = false;
  beast::error_code ignored;
  beast::get_lowest_layer(stream_).socket().close(ignored);
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
  end_waits_ = !end_told_;
  sendNext();
}

void LiveClient::sendNext() {
  if (!open_ || message_) return;
  const Gallery& gallery = hall_->gallery;
  if (std::exchange(graph_waits_, false)) return send(gallery.graph());
  const bool fresh = std::exchange(frame_waits_, false);
  if (fresh || (next_row_ < gallery.rows().size() && gallery.newest())) {
    return send(std::make_shared<const std::string>(frameMessage(fresh && wants_pictures_)));
  }
  if (std::exchange(end_waits_, false)) {
    end_told_ = true;
    return send(std::make_shared<const std::string>(gallery.endMessage()));
  }
  if (gallery.hasEnded() && !hall_->keeps_open) close(websocket::close_code::normal);
}

std::string LiveClient::frameMessage(bool with_arrays) {
  const Gallery& gallery = hall_->gallery;
  const Exhibit& newest = *gallery.newest();
  nlohmann::json header = newest.encoded.header;
  header["stored"] = newest.stored;
  header["rows_from"] = next_row_;
  header["dropped"] = dropped_;
  header["clients"] = hall_->clients.size();
  header["events"] = eventsJson(gallery.events().since(next_event_, kMostEvents));
  next_event_ = gallery.events().end();
  auto rows = std::make_shared<const std::string>(gallery.rows().read(next_row_, kMostRows));
  const std::size_t n = rows->size() / sizeof(HistoryRow);
  next_row_ += n;
  std::vector<PackedArray> arrays = {{"rows", Element::F64, {n, kColumns}, std::move(rows)}};
  if (with_arrays) {
    arrays.insert(arrays.end(), newest.encoded.arrays.begin(), newest.encoded.arrays.end());
  }
  return encodeContainer(std::move(header), arrays);
}

void LiveClient::send(std::shared_ptr<const std::string> message) {
  message_ = std::move(message);
  sent_at_ = Clock::now();
  stream_.async_write(boost::asio::buffer(*message_),
                      [self = shared_from_this()](beast::error_code error, std::size_t) {
                        self->message_.reset();
                        if (error) return self->drop();
                        self->sendNext();
                      });
}

}  // namespace tolman::web_viewer
