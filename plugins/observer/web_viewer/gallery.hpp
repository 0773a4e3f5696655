// SPDX-License-Identifier: BSD-3-Clause
// All that the viewer shows: the run, its rows, stored frames, template views, graph and events.
// Lives in the viewer's thread; knows nothing of connections.
#pragma once

#include <memory>
#include <string>

#include "event_log.hpp"
#include "frame_encoder.hpp"
#include "handover.hpp"
#include "row_store.hpp"
#include "spool.hpp"

namespace tolman::web_viewer {

/// The newest frame, and whether it can be asked for again.
struct Exhibit {
  EncodedFrame encoded;
  bool stored = false;
};

class Gallery {
 public:
  Gallery(const Picture& picture, std::uint64_t spool_bytes);

  void begin(const RunInfo& run);
  /// Encodes and keeps what came.
  void take(const Delivery& delivery);
  void end(std::string_view state);

  /// The object of /api/run.
  const nlohmann::json& run() const { return run_; }
  bool hasEnded() const { return !end_state_.empty(); }
  std::string endMessage() const;
  const RowStore& rows() const { return rows_; }
  const Spool& frames() const { return frames_; }
  const Spool& views() const { return views_; }
  const EventLog& events() const { return events_; }
  /// Null before the first; shared, for a client may still be sending it.
  const std::shared_ptr<const Exhibit>& newest() const { return newest_; }
  const std::shared_ptr<const std::string>& graph() const { return graph_; }

 private:
  Picture picture_;
  nlohmann::json run_;
  std::string end_state_;
  RowStore rows_;
  Spool frames_;
  Spool views_;
  EventLog events_;
  std::shared_ptr<const Exhibit> newest_;
  std::shared_ptr<const std::string> graph_;
};

}  // namespace tolman::web_viewer
