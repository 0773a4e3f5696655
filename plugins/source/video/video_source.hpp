// SPDX-License-Identifier: BSD-3-Clause
// Source `video`: a video file, a pipe or a camera, read forward; a camera until the run is
// stopped.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "capture.hpp"
#include "file_access.hpp"
#include "given_pinhole.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"

namespace tolman::video {

/// The cameras in one picture.
enum class PictureLayout : std::uint8_t {
  Mono,        ///< one camera
  SideBySide,  ///< left camera in the left half, right camera in the right half
  TopBottom,   ///< left camera in the upper half, right camera in the lower half
};
inline constexpr std::array<std::string_view, 3> kPictureLayoutNames = {"mono", "side_by_side",
                                                                        "top_bottom"};
constexpr std::span<const std::string_view> enumNames(PictureLayout) { return kPictureLayoutNames; }

/// Size of one camera's image. InvalidParameter for a picture that cannot be halved.
Result<PictureSize> cameraSize(PictureSize picture, PictureLayout layout);

/// The image of the left (or only) camera, a view of the same pixels.
Image leftImage(const Image& picture, PictureLayout layout);
/// The image of the right camera; empty for one camera.
Image rightImage(const Image& picture, PictureLayout layout);

struct VideoParameters : FrameSelection, source_parameters::GivenPinhole {
  std::string path;
  PictureLayout layout = PictureLayout::Mono;
  bool colour = false;
  double rate = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;

  static constexpr auto declaration() {
    using P = VideoParameters;
    return std::tuple_cat(
        parameters(
            parameter("path", &P::path)
                .path()
                .required()
                .doc("Video file, named pipe, or camera such as /dev/video0."),
            parameter("layout", &P::layout)
                .doc("mono: one camera; side_by_side, top_bottom: a rectified pair in one picture, "
                     "left camera first."),
            parameter("colour", &P::colour)
                .doc("Provide colour images; otherwise pictures are converted to grey."),
            parameter("rate", &P::rate)
                .range(0, 1e6)
                .unit("Hz")
                .doc("Pictures a second; 0 for the times in the file. A camera is asked for this "
                     "rate."),
            parameter("width", &P::width)
                .range(0, 1e5)
                .unit("px")
                .doc("Width that a camera is asked for; 0 for its own."),
            parameter("height", &P::height)
                .range(0, 1e5)
                .unit("px")
                .doc("Height that a camera is asked for; 0 for its own.")),
        source_parameters::pinholeParameter<P>(), source_parameters::baselineParameter<P>(),
        selectionParameters<P>());
  }
};

class VideoSource final : public Source {
 public:
  using Parameters = VideoParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status next(Frame& frame) override;

 private:
  Status prepare(const Context& context);
  Status open();
  Status atEnd();
  void reportDamage(std::string what);
  Status give(Picture& picture, std::int64_t index, Frame& frame);
  Result<std::int64_t> stampNs(const Picture& picture, std::int64_t index) const;

  Parameters parameters_;
  PathKind kind_ = PathKind::File;
  FindingCollector* findings_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  const Clock* clock_ = nullptr;
  OpenFile pipe_;  ///< read by capture_
  std::unique_ptr<Capture> capture_;
  CameraRig rig_;
  std::string description_;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_frame_ = 0;
  std::int64_t next_picture_ = 0;  ///< index of the next picture of capture_
};

}  // namespace tolman::video
