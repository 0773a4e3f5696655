// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `video`.
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "picture_layout.hpp"
#include "tolman/frame_selection.hpp"

namespace tolman::video {

enum class OnCorrupt : std::uint8_t {
  Stop,  ///< next() fails
  Skip,  ///< a frame without images, with `defect`
};
inline constexpr std::array<std::string_view, 2> kOnCorruptNames = {"stop", "skip"};
constexpr std::span<const std::string_view> enumNames(OnCorrupt) { return kOnCorruptNames; }

struct VideoParameters : FrameSelection {
  std::string path;
  PictureLayout layout = PictureLayout::Mono;
  bool colour = false;
  OnCorrupt on_corrupt = OnCorrupt::Stop;
  double rate = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;
  double fx = 0;
  double fy = 0;
  double cx = 0;
  double cy = 0;
  double baseline = 0;

  static constexpr auto declaration();
};

/// The calibration, by the same names as those of the source `images`.
constexpr auto calibrationParameters() {
  using P = VideoParameters;
  return parameters(parameter("fx", &P::fx)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Focal length; 0 for an uncalibrated camera."),
                    parameter("fy", &P::fy)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Vertical focal length; 0 for the same as fx."),
                    parameter("cx", &P::cx)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Principal point; 0 for the centre of the image."),
                    parameter("cy", &P::cy)
                        .range(0, 1e6)
                        .unit("px")
                        .doc("Principal point; 0 for the centre of the image."),
                    parameter("baseline", &P::baseline)
                        .range(0, 5)
                        .unit("m")
                        .doc("Distance of the right camera from the left one."));
}

constexpr auto VideoParameters::declaration() {
  using P = VideoParameters;
  return std::tuple_cat(
      parameters(parameter("path", &P::path)
                     .path()
                     .required()
                     .doc("Video file, named pipe, or camera such as /dev/video0."),
                 parameter("layout", &P::layout)
                     .doc("mono: one camera; side_by_side, top_bottom: a rectified pair in one "
                          "picture, left camera first."),
                 parameter("colour", &P::colour)
                     .doc("Provide colour images; otherwise pictures are converted to grey."),
                 parameter("on_corrupt", &P::on_corrupt)
                     .doc("Damaged pictures: stop the run, or skip: give a frame without images."),
                 parameter("rate", &P::rate)
                     .range(0, 1e6)
                     .unit("Hz")
                     .doc("Pictures a second; 0 for the times in the file. A camera is asked for "
                          "this rate."),
                 parameter("width", &P::width)
                     .range(0, 1e5)
                     .unit("px")
                     .doc("Width that a camera is asked for; 0 for its own."),
                 parameter("height", &P::height)
                     .range(0, 1e5)
                     .unit("px")
                     .doc("Height that a camera is asked for; 0 for its own.")),
      calibrationParameters(), selectionParameters<P>());
}

}  // namespace tolman::video
