// SPDX-License-Identifier: BSD-3-Clause
// The viewer's own thread: encodes, keeps and sends what the run hands over.
#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <functional>
#include <thread>

#include "handover.hpp"
#include "server.hpp"
#include "tolman/context.hpp"

namespace tolman::web_viewer {

struct ViewerOptions {
  Place place;
  std::size_t clients = 8;
  double rate = 10;  ///< frame messages a second; 0 for every frame
  Picture picture;
  std::uint64_t spool_bytes = 0;
};

class ViewerThread {
 public:
  /// `log` hears of trouble; it must outlive the object.
  ViewerThread(const ViewerOptions& options, Logger& log);
  /// Ends at once.
  ~ViewerThread();
  ViewerThread(const ViewerThread&) = delete;
  ViewerThread& operator=(const ViewerThread&) = delete;

  /// Listens and starts the thread.
  Status start();
  std::string url() const { return server_.url(); }
  int port() const { return server_.port(); }
  bool isLoopback() const { return server_.isLoopback(); }

  void begin(const RunInfo& run);
  void observe(const Snapshot& snapshot);
  /// Sends all that is left and the end. Those who read get a moment for it.
  void finish(const MapGraph* graph, const char* state, const std::function<bool()>& stays);

 private:
  using Clock = std::chrono::steady_clock;
  void work();
  void tick();
  void take(bool everything);
  void end(const char* state, bool keeps_open);

  ViewerOptions options_;
  Logger& log_;
  Handover handover_;
  std::shared_ptr<Hall> hall_;
  boost::asio::io_context io_;  ///< destroyed before what its handlers refer to
  boost::asio::steady_timer timer_;
  Server server_;
  Delivery delivery_;
  Clock::duration frame_period_;
  Clock::time_point next_frame_;
  Clock::time_point next_graph_;
  std::atomic<bool> woken_ = false;
  std::atomic<bool> deserted_ = false;
  bool ending_ = false;
  int failures_ = 0;
  std::thread thread_;
};

}  // namespace tolman::web_viewer
