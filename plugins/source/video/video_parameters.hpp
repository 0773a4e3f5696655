// SPDX-License-Identifier: BSD-3-Clause
// Parameters of the source `video`.
#pragma once

#include <string>
#include <tuple>

#include "given_pinhole.hpp"
#include "on_corrupt.hpp"
#include "picture_layout.hpp"
#include "tolman/frame_selection.hpp"

namespace tolman::video {

using source_parameters::GivenPinhole;
using source_parameters::OnCorrupt;

struct VideoParameters : FrameSelection, GivenPinhole {
  std::string path;
  PictureLayout layout = PictureLayout::Mono;
  bool colour = false;
  int bits = 16;
  OnCorrupt on_corrupt = OnCorrupt::Stop;
  double rate = 0;
  std::int64_t width = 0;
  std::int64_t height = 0;

  static constexpr auto declaration();
};

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
                 parameter("bits", &P::bits)
                     .range(8, 16)
                     .doc("Bits that grey pictures of 16 bits use, from the lowest; the 8 highest "
                          "of them are taken."),
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
      source_parameters::pinholeParameters<P>(), selectionParameters<P>());
}

}  // namespace tolman::video
