// SPDX-License-Identifier: BSD-3-Clause
// A sighting as a message: JPEG, points, neural arrays, and the few numbers of the header.
#pragma once

#include <memory>

#include "container.hpp"
#include "sighting.hpp"

namespace tolman::web_viewer {

/// Encoded once, sent to many.
struct EncodedFrame {
  std::int64_t frame = -1;
  nlohmann::json header;            ///< without what differs from client to client
  std::vector<PackedArray> arrays;  ///< image, points, cells.*
};

struct Picture {
  int width = 640;   ///< px at most
  int quality = 70;  ///< of JPEG
};

/// Empty where the image is.
std::string jpeg(const Image& image, const Picture& picture);

EncodedFrame encodeFrame(const Sighting& sighting, const Picture& picture);

nlohmann::json eventsJson(const std::vector<RunEvent>& events);

/// As it is kept for those who come later: without rows, dropped and clients.
std::string storedMessage(const EncodedFrame& frame, const std::vector<RunEvent>& events);

}  // namespace tolman::web_viewer
