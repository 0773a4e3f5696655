// SPDX-License-Identifier: BSD-3-Clause
// Pictures one after another, from a file, a pipe or a camera.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::video {

struct PictureSize {
  int width = 0;   ///< px
  int height = 0;  ///< px
  bool operator==(const PictureSize&) const = default;
};

/// One picture. Its image is empty if it was not requested or is damaged.
struct Picture {
  Image image;
  std::int64_t stamp_ns = 0;  ///< of a file: since its first picture
  bool timed = false;         ///< false: the file contains no times
  std::string defect;         ///< why the image is missing
};

class Capture {
 public:
  virtual ~Capture() = default;
  /// Size of all pictures.
  virtual PictureSize size() const = 0;
  /// Text for messages: "mpeg4 in mp4, 640x480 px, 30 Hz, 12.3 s".
  virtual std::string description() const = 0;
  /// The next picture; `wanted`: with its pixels. EndOfStream after the last.
  virtual Status next(bool wanted, Picture& picture) = 0;
  /// After EndOfStream: why the stream is not complete; empty if it is.
  virtual std::string defectOfEnd() const { return {}; }
};

using OpenCapture = std::function<Result<std::unique_ptr<Capture>>()>;

}  // namespace tolman::video
