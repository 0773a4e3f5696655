// SPDX-License-Identifier: BSD-3-Clause
// One row of numbers per frame, from which the page draws its graphs.
//
// The columns are the scalar fields of the records (Frame, Motion, PlaceObservation, Decision,
// MapUpdate), as their fields() list them, and a few derived values: positions and times. They are
// named "record.field", e.g. "motion.v". Booleans are 0 or 1; enumerations are their index.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "event_log.hpp"
#include "frame_encoder.hpp"
#include "tolman/roles.hpp"

namespace tolman::web_viewer {

/// Name, unit and meaning of a column.
struct RowColumn {
  static constexpr const char* kRecord = "column";
  std::string name;
  std::string unit;
  std::string doc;
  std::span<const std::string_view> choices;  ///< names of an enumeration's values; else empty

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(name, "", "record and field, e.g. motion.v");
    TOLMAN_FIELD(unit, "", "unit of the value, empty for none");
    TOLMAN_FIELD(doc, "", "meaning");
  }
};

/// All columns in the order of the values of a row.
const std::vector<RowColumn>& rowColumns();

/// Makes the rows of one run, in order of frames. Chains the odometry from the first frame on, and
/// transforms the true poses into the same world frame: the camera at the first frame with truth.
class RowMaker {
 public:
  /// Appends one value per column to `values`; NaN where the value is not known.
  void append(const Snapshot& snapshot, std::vector<double>& values);

 private:
  Eigen::Isometry3d T_world_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_world_truth_;  ///< world frame of the truth to that of the run
  bool begun_ = false;
};

// The JSON answers and messages for other programs during a run: pose, map, routes, events.
// docs/web-viewer.md is its documentation.

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
