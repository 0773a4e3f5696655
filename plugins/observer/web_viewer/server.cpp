// SPDX-License-Identifier: BSD-3-Clause
#include "server.hpp"

#include <utility>

#include "live_client.hpp"
#include "session.hpp"

namespace tolman::web_viewer {
namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using namespace std::chrono_literals;

// Connections that only ask for pages and data, beside the live ones.
constexpr std::size_t kMostVisitors = 64;

std::string placeText(const Place& place, int port) {
  return "port " + std::to_string(port) + " of " + place.bind;
}

}  // namespace

Status Server::open(const Place& place) {
  boost::system::error_code error;
  address_ = asio::ip::make_address(place.bind == "localhost" ? "127.0.0.1" : place.bind, error);
  if (error) {
    return Status::invalidParameter(
        "bind: '" + place.bind +
        "' is no address; give 127.0.0.1 for this machine alone, 0.0.0.0 for all networks");
  }
  bool taken = false;
  Status status = listen(place, place.port, taken);
  if (taken && place.or_any) status = listen(place, 0, taken);
  return status;
}

Status Server::listen(const Place& place, int port, bool& taken) {
  boost::system::error_code error;
  const tcp::endpoint endpoint(address_, static_cast<std::uint16_t>(port));
  acceptor_.close(error);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  taken = error == asio::error::address_in_use;
  if (taken) {
    return Status::invalidParameter(placeText(place, port) +
                                    " is in use by another program; give another 'port', or 0 for "
                                    "any that is free");
  }
  if (error == std::errc::address_not_available) {
    return Status::invalidParameter("bind: " + place.bind + " is no address of this machine");
  }
  if (error) {
    return Status::invalidParameter(placeText(place, port) + " cannot be served (" +
                                    error.message() + "); give another 'port' or 'bind'");
  }
  port_ = acceptor_.local_endpoint().port();
  return Status::ok();
}

std::string Server::url() const {
  const std::string shown = address_.is_unspecified() ? "127.0.0.1" : address_.to_string();
  const std::string host = shown.find(':') == std::string::npos ? shown : "[" + shown + "]";
  return "http://" + host + ":" + std::to_string(port_) + "/";
}

void Server::accept() {
  acceptor_.async_accept([this](const boost::system::error_code& error, tcp::socket socket) {
    if (error == asio::error::operation_aborted || !acceptor_.is_open()) return;
    if (error) {  // out of file descriptors: a moment later there may be some
      pause_.expires_after(100ms);
      pause_.async_wait([this](const boost::system::error_code& stopped) {
        if (!stopped) accept();
      });
      return;
    }
    if (hall_->connections < hall_->most_clients + kMostVisitors) {
      boost::system::error_code ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      std::make_shared<Session>(std::move(socket), hall_)->start();
    }
    accept();
  });
}

void Server::tellFrame() {
  for (LiveClient* client : std::set(hall_->clients)) client->newFrame();
}

void Server::tellGraph() {
  for (LiveClient* client : std::set(hall_->clients)) client->newGraph();
}

void Server::tellEnd() {
  for (LiveClient* client : std::set(hall_->clients)) client->runEnded();
}

bool Server::isDeserted() {
  for (LiveClient* client : std::set(hall_->clients)) {
    if (client->isStalled(200ms)) client->drop();
  }
  return hall_->clients.empty();
}

void Server::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  pause_.cancel();
}

}  // namespace tolman::web_viewer
