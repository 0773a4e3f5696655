// SPDX-License-Identifier: BSD-3-Clause
// What the messages say: rows of numbers, and the headers of each kind of message.
//
// One row of numbers per frame, from which the page draws its graphs.
//
// The columns are the scalar fields of the records (Frame, Motion, PlaceObservation and
// its best candidate, Decision and a hypothesis that it changed, MapUpdate), as their fields() list
// them, and a few derived values: positions and times. They are named "record.field", e.g.
// "motion.v". Booleans are 0 or 1; enumerations are their index.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

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

/// Of a measured pose, against the truth.
struct PoseError {
  double metres = 0;
  double sigmas = 0;  ///< standard deviations
};

/// Makes the rows of one run, in order of frames. Chains the odometry from the first frame on, and
/// transforms the true poses into the same world frame: the camera at the first frame with truth.
class RowMaker {
 public:
  /// Appends one value per column to `values`; NaN where the value is not known.
  void append(const Snapshot& snapshot, std::vector<double>& values);

 private:
  std::optional<PoseError> judge(const PlaceObservation& place, const Eigen::Isometry3d& T_truth);

  Eigen::Isometry3d T_world_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_world_truth_;  ///< world frame of the truth to that of the run
  bool begun_ = false;
  std::map<std::int64_t, Eigen::Isometry3d> true_templates_;  ///< true poses where they were made
  Eigen::Matrix3d first_turn_ = Eigen::Matrix3d::Identity();
  bool turned_ = false;  ///< the truth has orientations
};

// The JSON headers of the messages, as records. The server encodes them by their field lists, and
// page/src/wire/records.ts is generated from the same lists. Images, points, arrays and rows follow
// a header as binary arrays; see container.hpp.

/// The first message of a connection, and the answer of /api/run.
struct HelloHeader {
  static constexpr const char* kRecord = "hello";
  RunInfo run;
  bool live = true;
  bool recorded = false;
  std::int64_t rows = 0;
  std::vector<RowColumn> columns;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(run, "", "the run that is shown");
    TOLMAN_FIELD(live, "", "false after the last frame");
    TOLMAN_FIELD(recorded, "", "the run had ended before it was shown");
    TOLMAN_FIELD(rows, "", "history rows so far");
    TOLMAN_FIELD(columns, "", "columns of a history row");
  }
};

/// Header of a frame: image, points, arrays of the cells, and the rows not yet sent to the client.
struct FrameHeader {
  static constexpr const char* kRecord = "frame";
  std::int64_t frame = -1;
  std::int64_t points_frame = -1;
  std::int64_t rows_from = 0;
  std::int64_t dropped = 0;
  std::vector<RunEvent> events;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(frame, "", "index in the run");
    TOLMAN_FIELD(points_frame, "", "the frame that the points belong to, -1 for none");
    TOLMAN_FIELD(rows_from, "", "number of the first row of this message");
    TOLMAN_FIELD(dropped, "", "frames that this client was too slow for");
    TOLMAN_FIELD(events, "", "events since the message before");
  }
};

/// Header of the answer of /api/history.
struct HistoryHeader {
  static constexpr const char* kRecord = "history";
  std::int64_t from = 0;
  std::int64_t total = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(from, "", "number of the first row of this message");
    TOLMAN_FIELD(total, "", "rows so far");
  }
};

struct GraphHeader {
  static constexpr const char* kRecord = "graph";
  std::int64_t version = 0;
  std::int64_t frame = -1;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(version, "", "number of the last correction of the map");
    TOLMAN_FIELD(frame, "", "the frame at which the graph was so; -1 after the last");
  }
};

/// The last message of a run.
struct EndHeader {
  static constexpr const char* kRecord = "end";
  std::string state;
  std::int64_t frames = 0;

  template <class Self, class Visit>
  static void fields(Self& self, Visit&& visit) {
    TOLMAN_FIELD(state, "", "finished or interrupted");
    TOLMAN_FIELD(frames, "", "frames of the run");
  }
};

template <class T>
nlohmann::json valueJson(const std::vector<T>& values);

/// A value of a record as JSON: records are objects, enumerations their names.
template <class T>
nlohmann::json valueJson(const T& value) {
  if constexpr (Record<T>) {
    nlohmann::json object = nlohmann::json::object();
    visitFields(value, [&](const Field& field, const auto& member) {
      object[std::string(field.name)] = valueJson(member);
    });
    return object;
  } else if constexpr (NamedEnum<T>) {
    return std::string(enumName(value));
  } else {
    return value;
  }
}

template <class T>
nlohmann::json valueJson(const std::vector<T>& values) {
  nlohmann::json list = nlohmann::json::array();
  for (const T& value : values) list.push_back(valueJson(value));
  return list;
}

/// A message header: the record's fields, and its name as "type".
template <Record R>
nlohmann::json headerJson(const R& header) {
  nlohmann::json json = valueJson(header);
  json["type"] = R::kRecord;
  return json;
}

}  // namespace tolman::web_viewer
