// SPDX-License-Identifier: BSD-3-Clause
// Passes data from the thread of the run to the thread of the viewer. The run waits here only when
// every frame is to be shown (`rate: 0`).
#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

#include "flat_graph.hpp"
#include "frame_copy.hpp"
#include "history_row.hpp"

namespace tolman::web_viewer {

/// The image that a new template was made of.
struct TemplateImage {
  std::int64_t template_id = -1;
  Image image;
};

/// Data that the viewer has not processed yet.
struct PendingData {
  std::vector<double> rows;      ///< all values of all rows; see rowColumns()
  std::vector<RunEvent> events;  ///< the newest
  std::vector<TemplateImage> template_images;
  bool has_frame = false;
  bool has_graph = false;
  FrameCopy newest;  ///< where has_frame
  FlatGraph graph;   ///< where has_graph
};

class Handover {
 public:
  /// `every_frame`: put() waits until the frame before was taken.
  explicit Handover(bool every_frame) : every_frame_(every_frame) {}

  /// True when the viewer should take the data now: there are many, or every frame is to be shown.
  bool put(const Snapshot& snapshot);
  void putGraph(const MapGraph& graph);

  /// Moves the data into `pending`, and reuses its memory for the next data. Frame and graph are
  /// moved only when asked for; otherwise they wait, and newer ones replace them.
  void take(PendingData& pending, bool frame, bool graph);
  /// put() no longer waits; call it when nobody calls take() any more.
  void close();

 private:
  void putEvents(const std::vector<RunEvent>& events);
  void putTemplateImage(const Snapshot& snapshot);

  const bool every_frame_;
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
  std::vector<TemplateImage> template_images_;
};

}  // namespace tolman::web_viewer
