// SPDX-License-Identifier: BSD-3-Clause
// A camera, /dev/video0, read by OpenCV's V4L2 capture.
#pragma once

#include <filesystem>
#include <memory>
#include <opencv2/videoio.hpp>

#include "capture.hpp"
#include "tolman/context.hpp"

namespace tolman::video {

/// Requested settings of the camera; 0: its default.
struct CameraRequest {
  PictureSize size;  ///< px
  double rate = 0;   ///< Hz
};

class CameraDevice final : public Capture {
 public:
  static Result<std::unique_ptr<CameraDevice>> open(const std::filesystem::path& path,
                                                    const CameraRequest& request, bool colour,
                                                    const Clock& clock);

  PictureSize size() const override { return size_; }
  std::string description() const override;
  /// Waits for the next picture. Its stamp is the driver's time of exposure, or the time of arrival
  /// if the driver has none. A camera that gives no picture for 10 s is a failure.
  Status next(bool wanted, Picture& picture) override;

 private:
  CameraDevice(std::filesystem::path path, bool colour, const Clock& clock)
      : path_(std::move(path)), colour_(colour), clock_(clock) {}
  Status start(const CameraRequest& request);

  std::filesystem::path path_;
  bool colour_;
  const Clock& clock_;
  cv::VideoCapture capture_;
  PictureSize size_;
};

}  // namespace tolman::video
