// SPDX-License-Identifier: BSD-3-Clause
// The formulas of the source `painted`, for the plugin and for the tests that look at its frames.
#pragma once

#include "tolman/extras.hpp"
#include "tolman/roles.hpp"

namespace tolman::fixture {

inline constexpr int kPaintedWidth = 40;
inline constexpr int kPaintedHeight = 24;

inline std::uint8_t paintedPixel(std::int64_t frame, int camera, int row, int column) {
  return static_cast<std::uint8_t>(29 * frame + 101 * camera + 7 * row + 13 * column);
}

/// m; nothing in the top row, too far for 16 bits from frame 250 on.
inline float paintedDepth(std::int64_t frame, int row, int column) {
  if (row == 0) return 0;
  return static_cast<float>(frame) + 0.25F * static_cast<float>(row) +
         static_cast<float>(column) / 256;
}

/// A circle of 20 m radius, 1 m a frame: after 126 frames the car is where it was.
inline Eigen::Isometry3d paintedPose(std::int64_t frame) {
  const double angle = static_cast<double>(frame) / 20;
  const PlanarPose pose{20 * std::sin(angle), 20 - 20 * std::cos(angle), angle};
  return Eigen::Translation3d(3, 0.5, -7) * fromPlanar(pose);
}

class Painted : public Source, public ArrayDescriptions {
 public:
  struct Parameters {
    std::int64_t frames = 20;
    bool depth = false;
    bool forget_depth = false;
    bool colour = false;
    bool mono = false;
    bool calibrated = true;
    std::int64_t defect_every = 0;
    std::int64_t fail_at = -1;
    std::int64_t truth_until = 1'000'000'000;

    static constexpr auto declaration() {
      return parameters(
          parameter("frames", &Parameters::frames).doc("How many there are."),
          parameter("depth", &Parameters::depth).doc("Give depth.left."),
          parameter("forget_depth", &Parameters::forget_depth)
              .doc("Declare depth, do not give it."),
          parameter("colour", &Parameters::colour).doc("Three channels."),
          parameter("mono", &Parameters::mono).doc("No right camera."),
          parameter("calibrated", &Parameters::calibrated).doc("The pinhole is known."),
          parameter("defect_every", &Parameters::defect_every)
              .doc("The last of so many has no image."),
          parameter("fail_at", &Parameters::fail_at).doc("The frame that fails."),
          parameter("truth_until", &Parameters::truth_until).doc("Frames after have no truth."));
    }
  };

  Status configure(const Context& context) override {
    const auto bound = bindParameters<Parameters>(context.parameters);
    if (bound.isOk()) parameters_ = bound.value();
    return bound.status();
  }
  Status reset() override {
    next_ = 0;
    return Status::ok();
  }
  Status info(SourceInfo& info) override {
    info.description = "painted frames";
    info.rig.width = kPaintedWidth;
    info.rig.height = kPaintedHeight;
    info.rig.calibrated = parameters_.calibrated;
    info.rig.pinhole = {30, 30, 19.5, 11.5};
    info.rig.baseline = parameters_.mono ? 0 : 0.25;
    info.frames = parameters_.frames;
    info.has_truth = true;
    return Status::ok();
  }
  Status next(Frame& frame) override {
    if (next_ >= parameters_.frames) return Status::endOfStream();
    if (next_ == parameters_.fail_at) return Status::invalidInput("the paint ran out; buy more");
    frame.frame = next_++;
    frame.source_index = frame.frame;
    frame.stamp_ns = 50'000'001 * frame.frame;
    frame.has_truth = frame.frame < parameters_.truth_until;
    frame.T_world_camera_truth = paintedPose(frame.frame);
    if (parameters_.defect_every > 0 &&
        frame.frame % parameters_.defect_every == parameters_.defect_every - 1) {
      frame.defect = "spilt";
      return Status::ok();
    }
    frame.left = paint(frame.frame, 0);
    if (!parameters_.mono) frame.right = paint(frame.frame, 1);
    if (parameters_.depth && !parameters_.forget_depth) frame.sensors.push_back(depth(frame.frame));
    return Status::ok();
  }
  Status describe(std::vector<ArrayInfo>& arrays) const override {
    ArrayInfo depth;
    depth.name = "depth.left";
    depth.kind = ArrayKind::DepthImage;
    depth.unit = "m";
    arrays.push_back(depth);
    return Status::ok();
  }

 private:
  Image paint(std::int64_t frame, int camera) const {
    const PixelFormat format = parameters_.colour ? PixelFormat::Bgr8 : PixelFormat::Gray8;
    const int channels = bytesPerPixel(format);
    return Image::create(kPaintedWidth, kPaintedHeight, format, [&](std::uint8_t* data) {
      for (int r = 0; r < kPaintedHeight; ++r) {
        for (int c = 0; c < kPaintedWidth * channels; ++c) {
          *data++ = paintedPixel(frame, camera, r, c);
        }
      }
    });
  }
  static NamedArray depth(std::int64_t frame) {
    NamedArray array{"depth.left", {kPaintedHeight, kPaintedWidth}, {}};
    for (int r = 0; r < kPaintedHeight; ++r) {
      for (int c = 0; c < kPaintedWidth; ++c) array.values.push_back(paintedDepth(frame, r, c));
    }
    return array;
  }

  Parameters parameters_;
  std::int64_t next_ = 0;
};

}  // namespace tolman::fixture
