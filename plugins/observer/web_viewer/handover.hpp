// SPDX-License-Identifier: BSD-3-Clause
// Between the thread of the run and that of the viewer. The run never waits here, unless every
// frame was asked for.
#pragma once

#include <condition_variable>
#include <mutex>
#include <vector>

#include "flat_graph.hpp"
#include "history_row.hpp"
#include "sighting.hpp"

namespace tolman::web_viewer {

/// The view that a new template was made of.
struct TemplateView {
  std::int64_t template_id = -1;
  Image image;
};

/// What has come since the last time.
struct Delivery {
  std::vector<HistoryRow> rows;  ///< all of them
  std::vector<RunEvent> events;  ///< the newest
  std::vector<TemplateView> views;
  bool has_frame = false;
  bool has_graph = false;
  Sighting newest;  ///< where has_frame
  FlatGraph graph;  ///< where has_graph
};

class Handover {
 public:
  /// `every_frame`: put() waits until the frame before was taken.
  explicit Handover(bool every_frame) : every_frame_(every_frame) {}

  /// True when the viewer should be woken: much has come, or every frame counts.
  bool put(const Snapshot& snapshot);
  void putGraph(const MapGraph& graph);

  /// Moves what has come into `delivery`, whose memory is used for what comes next. Frame and graph
  /// only where they are wanted now; else they wait, and newer ones replace them.
  void take(Delivery& delivery, bool frame, bool graph);
  /// From now on nobody takes, so nobody waits.
  void close();

 private:
  void putEvents(const std::vector<RunEvent>& events);
  void putView(const Snapshot& snapshot);

  const bool every_frame_;
  RowMaker rows_;
  std::mutex mutex_;
  std::condition_variable taken_;
  bool closed_ = false;
  bool fresh_frame_ = false;
  bool fresh_graph_ = false;
  Sighting newest_;
  FlatGraph graph_;
  std::vector<HistoryRow> waiting_rows_;
  std::vector<RunEvent> events_;
  std::vector<TemplateView> views_;
};

}  // namespace tolman::web_viewer
