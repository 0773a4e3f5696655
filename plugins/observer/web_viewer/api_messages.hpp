// SPDX-License-Identifier: BSD-3-Clause
// The JSON answers and messages for other programs during a run: pose, map, routes, events.
// docs/web-viewer.md is its documentation.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "event_log.hpp"
#include "frame_encoder.hpp"

namespace tolman::web_viewer {

/// An HTTP answer in JSON; after a failure it has the key `error`.
struct ApiAnswer {
  unsigned status = 200;
  std::string json;
};

ApiAnswer poseAnswer(const LatestPose& pose);
ApiAnswer mapAnswer(const FlatGraph& graph);

/// `query`: to=17 or to=RIGHT,FORWARD or to=RIGHT,FORWARD,UP (m), and from= in the same form or
/// from=here, the default. A place stands for the nearest experience that a route leads to.
ApiAnswer planAnswer(const FlatGraph& graph, const LatestPose& pose, std::string_view query);

/// Text of a message of type `pose`.
std::string poseMessage(const LatestPose& pose);
/// Text of a message of type `end`.
std::string endMessage(std::string_view state, std::int64_t frame);
/// Appends a message for a decision other than to stay, for each loop, and for each event.
void appendMessages(const Snapshot& snapshot, std::vector<std::string>& messages);

}  // namespace tolman::web_viewer
