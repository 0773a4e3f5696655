// SPDX-License-Identifier: BSD-3-Clause
// The data of one frame until it is encoded. Pixels are shared, the rest is copied.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "container.hpp"
#include "tolman/roles.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {

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
