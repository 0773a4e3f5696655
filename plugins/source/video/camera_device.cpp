// SPDX-License-Identifier: BSD-3-Clause
// A camera read by OpenCV's V4L2 capture.
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>

#include "capture.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::video {
namespace {

class CameraDevice final : public Capture {
 public:
  CameraDevice(std::filesystem::path path, bool colour, const Clock& clock)
      : path_(std::move(path)), colour_(colour), clock_(clock) {}
  Status start(const CameraRequest& request);

  PictureSize size() const override { return size_; }
  std::string description() const override {
    return "camera " + path_.string() + ", " + size_.text();
  }
  Status next(bool wanted, Picture& picture) override;

 private:
  std::filesystem::path path_;
  bool colour_;
  const Clock& clock_;
  cv::VideoCapture capture_;
  PictureSize size_;
};

Status CameraDevice::start(const CameraRequest& request) {
  if (!capture_.open(path_.string(), cv::CAP_V4L2)) {
    return Status::invalidInput(
        "is no camera, or another program uses it; close that program (`fuser " + path_.string() +
        "`), or name another of `ls /dev/video*`");
  }
  if (request.size.width > 0) capture_.set(cv::CAP_PROP_FRAME_WIDTH, request.size.width);
  if (request.size.height > 0) capture_.set(cv::CAP_PROP_FRAME_HEIGHT, request.size.height);
  if (request.rate > 0) capture_.set(cv::CAP_PROP_FPS, request.rate);
  size_ = {static_cast<int>(std::lround(capture_.get(cv::CAP_PROP_FRAME_WIDTH))),
           static_cast<int>(std::lround(capture_.get(cv::CAP_PROP_FRAME_HEIGHT)))};
  const bool as_asked = (request.size.width == 0 || request.size.width == size_.width) &&
                        (request.size.height == 0 || request.size.height == size_.height);
  if (as_asked) return Status::ok();
  return Status::invalidParameter("the camera gives " + size_.text() + " instead of " +
                                  request.size.text() +
                                  "; set width and height to a size that it has");
}

Status CameraDevice::next(bool wanted, Picture& picture) {
  picture = {};
  cv::Mat pixels_read;
  if (!capture_.grab() || (wanted && !capture_.retrieve(pixels_read))) {
    return Status::invalidInput(path_.string() +
                                ": the camera gives no more pictures; it was unplugged, or hangs: "
                                "connect it again and go on with --continue");
  }
  const double exposed_ms = capture_.get(cv::CAP_PROP_POS_MSEC);
  picture.stamp_ns = exposed_ms > 0 ? std::llround(exposed_ms * 1e6) : clock_.steadyNs();
  picture.timed = true;
  if (!wanted) return Status::ok();
  if (pixels_read.channels() == 3 && !colour_) {
    cv::cvtColor(pixels_read, pixels_read, cv::COLOR_BGR2GRAY);
  } else if (pixels_read.channels() == 1 && colour_) {
    cv::cvtColor(pixels_read, pixels_read, cv::COLOR_GRAY2BGR);
  }
  // A copy, because the next picture is decoded into the same memory.
  picture.image = asImage(pixels_read.clone());
  return Status::ok();
}

}  // namespace

Result<std::unique_ptr<Capture>> openCamera(const std::filesystem::path& path,
                                            const CameraRequest& request, bool colour,
                                            const Clock& clock) {
  auto camera = std::make_unique<CameraDevice>(path, colour, clock);
  const Status status = camera->start(request);
  if (!status.isOk()) return Status(status.code(), path.string() + ": " + status.message());
  return std::unique_ptr<Capture>(std::move(camera));
}

}  // namespace tolman::video
