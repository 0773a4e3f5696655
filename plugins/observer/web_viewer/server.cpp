// SPDX-License-Identifier: BSD-3-Clause
#include "server.hpp"

#include <utility>

#include "http_connection.hpp"
#include "socket_client.hpp"

namespace tolman::web_viewer {

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using namespace std::chrono_literals;

// HTTP connections, not counting the live clients.
constexpr std::size_t kMaxHttpConnections = 64;

std::string portText(const ListenAddress& address, int port) {
  return "port " + std::to_string(port) + " of " + address.bind;
}

}  // namespace

Status Server::open(const ListenAddress& address) {
  boost::system::error_code error;
  address_ =
      asio::ip::make_address(address.bind == "localhost" ? "127.0.0.1" : address.bind, error);
  if (error) {
    return Status::invalidParameter(
        "bind: '" + address.bind +
        "' is not an IP address; give 127.0.0.1 for this machine alone, 0.0.0.0 for all networks");
  }
  bool taken = false;
  Status status = listen(address, address.port, taken);
  if (taken && address.or_any) status = listen(address, 0, taken);
  return status;
}

Status Server::listen(const ListenAddress& address, int port, bool& taken) {
  boost::system::error_code error;
  const tcp::endpoint endpoint(address_, static_cast<std::uint16_t>(port));
  acceptor_.close(error);
  acceptor_.open(endpoint.protocol(), error);
  if (!error) acceptor_.set_option(tcp::acceptor::reuse_address(true), error);
  if (!error) acceptor_.bind(endpoint, error);
  if (!error) acceptor_.listen(asio::socket_base::max_listen_connections, error);
  taken = error == asio::error::address_in_use;
  if (taken) {
    return Status::invalidParameter(portText(address, port) +
                                    " is in use by another program; give another 'port', or 0 for "
                                    "any free port");
  }
  if (error == std::errc::address_not_available) {
    return Status::invalidParameter("bind: " + address.bind + " is not an address of this machine");
  }
  if (error) {
    return Status::invalidParameter(portText(address, port) + " cannot be served (" +
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
    if (error) {  // e.g. out of file descriptors: try again later
      pause_.expires_after(100ms);
      pause_.async_wait([this](const boost::system::error_code& stopped) {
        if (!stopped) accept();
      });
      return;
    }
    if (state_->connections < state_->most_clients + kMaxHttpConnections) {
      boost::system::error_code ignored;
      socket.set_option(tcp::no_delay(true), ignored);
      std::make_shared<HttpConnection>(std::move(socket), state_)->start();
    }
    accept();
  });
}

void Server::publishFrame() {
  for (SocketClient* client : std::set(state_->clients)) client->newFrame();
}

void Server::publishGraph() {
  for (SocketClient* client : std::set(state_->clients)) client->newGraph();
}

void Server::publishNumbers() {
  for (SocketClient* client : std::set(state_->clients)) client->newNumbers();
}

void Server::publishEnd() {
  for (SocketClient* client : std::set(state_->clients)) client->runEnded();
}

bool Server::dropStalledClients() {
  for (SocketClient* client : std::set(state_->clients)) {
    if (client->isStalled(200ms)) client->disconnect();
  }
  return state_->clients.empty();
}

void Server::close() {
  boost::system::error_code ignored;
  acceptor_.close(ignored);
  pause_.cancel();
}

}  // namespace tolman::web_viewer
