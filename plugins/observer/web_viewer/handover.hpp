// SPDX-License-Identifier: BSD-3-Clause
// Passes data from the thread of the run to the thread of the viewer. The run waits here only when
// every frame is to be shown (`rate: 0`).
#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <vector>

#include "api_messages.hpp"
#include "frame_encoder.hpp"
#include "wire_records.hpp"

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

}  // namespace tolman::web_viewer
