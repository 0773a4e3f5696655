// SPDX-License-Identifier: BSD-3-Clause
// All data of the run that clients can get: description, rows, stored frames, template images,
// graph and events. Belongs to the viewer's thread.
#pragma once

#include <memory>
#include <string>

#include "event_log.hpp"
#include "frame_encoder.hpp"
#include "handover.hpp"
#include "spool.hpp"

namespace tolman::web_viewer {

class RunStore {
 public:
  RunStore(const JpegOptions& jpeg_options, std::uint64_t spool_bytes);

  /// `recorded`: the run had ended before it was shown.
  void begin(const RunInfo& run, bool recorded) {
    hello_.run = run;
    hello_.recorded = recorded;
  }
  /// Encodes and stores new data.
  void add(const PendingData& pending);
  /// `state`: finished or interrupted.
  void end(std::string_view state);

  /// The object of /api/run.
  HelloHeader hello() const;
  bool hasEnded() const { return !hello_.live; }
  std::string endMessage() const;
  const std::string& endState() const { return end_state_; }
  const RowStore& rows() const { return rows_; }
  const Spool& frames() const { return frames_; }
  const Spool& templateImages() const { return template_images_; }
  const EventLog& events() const { return events_; }
  const MessageLog& messages() const { return messages_; }
  const LatestPose& pose() const { return pose_; }
  const FlatGraph& flatGraph() const { return flat_graph_; }
  /// The newest frame, null before the first; shared, because it may still be being sent to a
  /// client.
  const std::shared_ptr<const EncodedFrame>& newest() const { return newest_; }
  /// The encoded graph; null before the first.
  const std::shared_ptr<const std::string>& graph() const { return graph_; }

 private:
  JpegOptions jpeg_options_;
  HelloHeader hello_;
  std::string end_state_;
  RowStore rows_;
  Spool frames_;
  Spool template_images_;
  EventLog events_;
  MessageLog messages_;
  LatestPose pose_;
  FlatGraph flat_graph_;
  std::shared_ptr<const EncodedFrame> newest_;
  std::shared_ptr<const std::string> graph_;
};

}  // namespace tolman::web_viewer
