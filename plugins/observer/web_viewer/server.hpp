// SPDX-License-Identifier: BSD-3-Clause
// State that all connections share, used only in the viewer's thread. Each connection holds a
// reference.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <cstddef>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "run_store.hpp"
#include "tolman/status.hpp"

namespace tolman::web_viewer {

class SocketClient;

struct ServerState {
  ServerState(const JpegOptions& jpeg_options, std::uint64_t spool_bytes, std::size_t most)
      : store(jpeg_options, spool_bytes), most_clients(most) {}

  RunStore store;
  std::size_t most_clients;
  std::size_t connections = 0;      ///< HTTP and live
  std::set<SocketClient*> clients;  ///< WebSocket clients; each registers itself
  std::size_t event_clients = 0;    ///< clients of /api/events
  std::function<void()> refresh;    ///< takes new data before an answer; empty in some tests
  bool keeps_open = false;          ///< connections are kept after the end of the run
};

// The listening socket, and what is sent to all live clients. All functions but the constructor
// and open() are called in the viewer's thread.

struct ListenAddress {
  std::string bind;
  int port = 0;
  bool or_any = false;  ///< use any free port when this one is in use
};

class Server {
 public:
  Server(boost::asio::io_context& io, std::shared_ptr<ServerState> state)
      : acceptor_(io), pause_(io), state_(std::move(state)) {}

  /// Listens. The message of a failure names the parameter to change.
  Status open(const ListenAddress& address);
  int port() const { return port_; }
  /// URL of the page.
  std::string url() const;
  bool isLoopback() const { return address_.is_loopback(); }

  /// Accepts connections until close().
  void accept();
  void publishFrame();
  void publishGraph();
  void publishNumbers();
  void publishEnd();
  /// Disconnects clients that do not read; true when no client is left.
  bool dropStalledClients();
  /// Accepts no more connections.
  void close();

 private:
  Status listen(const ListenAddress& address, int port, bool& taken);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  std::shared_ptr<ServerState> state_;
  boost::asio::ip::address address_;
  int port_ = 0;
};

}  // namespace tolman::web_viewer
