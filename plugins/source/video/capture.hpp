// SPDX-License-Identifier: BSD-3-Clause
// Pictures one after another, from a file, a pipe or a camera, and how to open them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>

#include "image_size.hpp"
#include "tolman/context.hpp"
#include "tolman/image.hpp"
#include "tolman/status.hpp"

namespace tolman::video {

using PictureSize = source_parameters::ImageSize;

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

/// The first video stream of a file, or of `pipe`: an open one that must outlive the capture, or
/// -1. InvalidInput with a remedy if it is not a video. A picture that is damaged, or not complete
/// at the end of the file, has a `defect`. `cancellation` ends the wait for a pipe.
Result<std::unique_ptr<Capture>> openVideo(const std::filesystem::path& path, int pipe, bool colour,
                                           const Cancellation& cancellation);

/// Requested settings of a camera; 0: its default.
struct CameraRequest {
  PictureSize size;  ///< px
  double rate = 0;   ///< Hz
};

/// A camera, /dev/video0. Stamps are the driver's times of exposure, or those of arrival where it
/// has none. No picture for 10 s is a failure.
Result<std::unique_ptr<Capture>> openCamera(const std::filesystem::path& path,
                                            const CameraRequest& request, bool colour,
                                            const Clock& clock);

}  // namespace tolman::video
