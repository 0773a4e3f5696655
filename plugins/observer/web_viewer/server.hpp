// SPDX-License-Identifier: BSD-3-Clause
// The listening socket, and word to all who watch. All but the constructor belongs to the viewer's
// thread.
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <string>

#include "hall.hpp"
#include "tolman/status.hpp"

namespace tolman::web_viewer {

struct Place {
  std::string bind;
  int port = 0;
  bool or_any = false;  ///< a port that is taken is replaced by a free one
};

class Server {
 public:
  Server(boost::asio::io_context& io, std::shared_ptr<Hall> hall)
      : acceptor_(io), pause_(io), hall_(std::move(hall)) {}

  /// Listens; a failure says what to change.
  Status open(const Place& place);
  int port() const { return port_; }
  /// For a browser.
  std::string url() const;
  bool isLoopback() const { return address_.is_loopback(); }

  void accept();
  void tellFrame();
  void tellGraph();
  void tellEnd();
  /// Ends those that have not taken a message for a while; true when nobody is left.
  bool isDeserted();
  /// Takes no more connections.
  void close();

 private:
  Status listen(const Place& place, int port, bool& taken);

  boost::asio::ip::tcp::acceptor acceptor_;
  boost::asio::steady_timer pause_;
  std::shared_ptr<Hall> hall_;
  boost::asio::ip::address address_;
  int port_ = 0;
};

}  // namespace tolman::web_viewer
