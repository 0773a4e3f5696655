// SPDX-License-Identifier: BSD-3-Clause
// The viewer's thread: encodes, stores and sends the data of the run.
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
  ListenAddress address;
  std::size_t clients = 8;
  double rate = 10;       ///< frame messages per second; 0 for every frame
  bool recorded = false;  ///< the run had ended before it was shown
  JpegOptions jpeg_options;
  std::uint64_t spool_bytes = 0;
};

class ViewerThread {
 public:
  /// `log` must outlive the object.
  ViewerThread(const ViewerOptions& options, Logger& log);
  /// Stops at once; finish() sends the remaining data first.
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
  /// Sends the remaining data and the end message, and waits at most half a second for clients to
  /// receive them. Then continues to serve while `stays` returns true.
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
  std::shared_ptr<ServerState> state_;
  boost::asio::io_context io_;  ///< destroyed before the objects that its handlers refer to
  boost::asio::steady_timer timer_;
  Server server_;
  PendingData pending_;
  Clock::duration frame_period_;
  Clock::time_point next_frame_;
  Clock::time_point next_graph_;
  std::atomic<bool> woken_ = false;
  std::atomic<bool> no_clients_ = false;
  bool ending_ = false;
  int failures_ = 0;
  std::thread thread_;
};

}  // namespace tolman::web_viewer
