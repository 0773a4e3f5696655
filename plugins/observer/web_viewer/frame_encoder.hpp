// SPDX-License-Identifier: BSD-3-Clause
// Encodes a frame as a message: header, JPEG image, points, and arrays of the cells.
#pragma once

#include "container.hpp"
#include "frame_copy.hpp"
#include "wire_records.hpp"

namespace tolman::web_viewer {

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
