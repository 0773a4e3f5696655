// SPDX-License-Identifier: BSD-3-Clause
// The binary messages, and frames encoded as such.
//
// The binary form of all messages: length of the header (uint32), JSON header that lists the
// arrays, arrays aligned to 8 bytes; little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tolman/roles.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {

enum class ElementType : std::uint8_t { U8, I32, F32, F64 };

/// A named array of a container. The bytes are shared between messages.
struct PackedArray {
  std::string name;
  ElementType element = ElementType::U8;
  std::vector<std::size_t> shape;
  std::shared_ptr<const std::string> bytes;
};

template <class T>
constexpr ElementType elementOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return ElementType::U8;
  if constexpr (std::is_same_v<T, std::int32_t>) return ElementType::I32;
  if constexpr (std::is_same_v<T, float>) return ElementType::F32;
  if constexpr (std::is_same_v<T, double>) return ElementType::F64;
}

/// Copies `values`, row-major.
template <class T>
PackedArray pack(std::string name, std::vector<std::size_t> shape, std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  auto copy = std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes.data()),
                                                  bytes.size());
  return {std::move(name), elementOf<T>(), std::move(shape), std::move(copy)};
}

/// `header` is an object; the member "arrays" is added to it.
std::string encodeContainer(nlohmann::json header, const std::vector<PackedArray>& arrays);

/// JSON text; invalid UTF-8 is replaced.
std::string jsonText(const nlohmann::json& json);

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
  std::vector<std::int32_t> loop;           ///< link, its frame, and those of its ends, of each
  std::vector<float> loop_residual;         ///< of each, standard deviations; -1: not known
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
