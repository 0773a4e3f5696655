// SPDX-License-Identifier: BSD-3-Clause
// The JSON headers of the messages, as records. The server encodes them by their field lists, and
// page/src/wire/records.ts is generated from the same lists. Images, points, arrays and rows follow
// a header as binary arrays; see container.hpp.
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "api_messages.hpp"
#include "run_store.hpp"
#include "tolman/roles.hpp"

namespace tolman::web_viewer {

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

// The data of one frame until it is encoded. Pixels are shared, the rest is copied.

struct FrameCopy {
  std::int64_t frame = -1;
  Image left;
  std::int64_t points_frame = -1;                  ///< -1: no points
  Eigen::Matrix<float, 4, Eigen::Dynamic> points;  ///< as Motion::points
  std::vector<NamedArray> cells;

  /// Copies from the snapshot; reuses the memory of the previous copy.
  void assign(const Snapshot& snapshot) {
    frame = snapshot.frame->frame;
    left = snapshot.frame->left;
    points_frame = snapshot.motion != nullptr ? snapshot.motion->points_frame : -1;
    if (points_frame >= 0) points = snapshot.motion->points;
    if (snapshot.cells != nullptr) {
      cells = *snapshot.cells;
    } else {
      cells.clear();
    }
  }
};

// The experience graph in flat arrays for the page: a tenth of the size of a MapGraph.

struct FlatGraph {
  GraphHeader header;
  std::vector<float> experience;   ///< x, y, z (m) and yaw (rad) of each experience
  std::vector<std::int32_t> link;  ///< from, to of each link
  std::vector<std::uint8_t> link_kind;
  std::vector<std::uint8_t> link_rejected;  ///< 1: loop link that the map has rejected
  std::vector<float> link_metres;           ///< length of each; not encoded
  std::vector<float> link_seconds;          ///< travel time of each, 0 for a loop link; not encoded

  /// `at_frame`: the graph is the one after this frame; -1 for the final one.
  void assign(const MapGraph& graph, std::int64_t at_frame);
  std::string encode() const;
};

// Encodes a frame as a message: header, JPEG image, points, and arrays of the cells.

/// Encoded once, sent to many clients.
struct EncodedFrame {
  FrameHeader header;               ///< without the fields that differ between clients
  std::vector<PackedArray> arrays;  ///< image, points, cells.NAME
};

struct JpegOptions {
  int width = 640;   ///< px, at most
  int quality = 70;  ///< in percent
};

/// A JPEG file; empty for an empty image.
std::string jpeg(const Image& image, const JpegOptions& options);

EncodedFrame encodeFrame(const FrameCopy& copy, const JpegOptions& options);

/// Events with messages of limited length.
std::vector<RunEvent> shortened(std::vector<RunEvent> events);

/// The message of /api/frame: without rows.
std::string storedMessage(const EncodedFrame& frame, const std::vector<RunEvent>& events);

}  // namespace tolman::web_viewer
