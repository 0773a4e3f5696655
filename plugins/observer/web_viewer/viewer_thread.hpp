// SPDX-License-Identifier: BSD-3-Clause
// Passes data from the thread of the run to the thread of the viewer. The run waits here only when
// every frame is to be shown (`rate: 0`).
#pragma once

#include <atomic>
#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

#include "api_messages.hpp"
#include "frame_encoder.hpp"
#include "server.hpp"
#include "tolman/context.hpp"

namespace tolman::web_viewer {

/// The image that a new template was made of.
struct TemplateImage {
  std::int64_t template_id = -1;
  Image image;
};

/// Data that the viewer has not processed yet.
struct PendingData {
  std::vector<double> rows;           ///< all values of all rows; see rowColumns()
  std::vector<RunEvent> events;       ///< the newest events
  std::vector<std::string> messages;  ///< of /api/events
  LatestPose pose;
  std::vector<TemplateImage> template_images;
  bool has_frame = false;
  bool has_graph = false;
  FrameCopy newest;  ///< where has_frame
  FlatGraph graph;   ///< where has_graph
};

class Handover {
 public:
  /// `every_frame`: put() waits until the previous frame was taken.
  explicit Handover(bool every_frame) : every_frame_(every_frame) {}

  /// True if the viewer should take the data now: there is much of it, or every frame is to be
  /// shown.
  bool put(const Snapshot& snapshot);
  /// The final graph, after the last frame; the newest pose moves with it.
  void putGraph(const MapGraph& graph);

  /// Moves the data into `pending`, and reuses its memory for the next data. Frame and graph are
  /// moved only on request; until then newer ones replace them.
  void take(PendingData& pending, bool frame, bool graph);
  /// Whether put() asks to take the data of every frame.
  void wakeAlways(bool always) { wakes_always_ = always; }
  /// After this put() no longer waits. To be called after the last take().
  void close();

 private:
  void putEvents(const std::vector<RunEvent>& events);
  void putTemplateImage(const Snapshot& snapshot);
  void putMessages(const Snapshot& snapshot);

  const bool every_frame_;
  std::atomic<bool> wakes_always_ = false;
  RowMaker row_maker_;
  std::mutex mutex_;
  std::condition_variable taken_;
  bool closed_ = false;
  bool fresh_frame_ = false;
  bool fresh_graph_ = false;
  FrameCopy newest_;
  FlatGraph graph_;
  std::vector<double> rows_;
  std::vector<RunEvent> events_;
  std::vector<std::string> messages_;
  LatestPose pose_;
  std::vector<TemplateImage> template_images_;
};

// The viewer's thread: encodes, stores and sends the data of the run.

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
