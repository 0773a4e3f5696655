// SPDX-License-Identifier: BSD-3-Clause
// One camera of the rig: what it truly is beside its calibration, and its image in grey levels.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <functional>
#include <vector>

#include "image_formation.hpp"
#include "light.hpp"
#include "parameters.hpp"
#include "renderer.hpp"
#include "shutter_blur.hpp"
#include "tolman/camera.hpp"
#include "tolman/image.hpp"

namespace tolman::town {

/// A camera that differs from the rig of the calibration.
struct TrueCamera {
  Pinhole pinhole;
  Eigen::Isometry3d T_left_camera = Eigen::Isometry3d::Identity();
  PixelWarp warp;
};

/// Left and right camera.
std::array<TrueCamera, 2> trueCameras(const TownParameters& parameters,
                                      const CameraRig& calibrated);

/// Residual distortion of an inexact calibration: sums of cosines of up to three half periods over
/// the width and two over the height, with mean 0. `rms_px` is the root mean square of the length
/// of displacements. Empty for 0.
PixelWarp makeWarp(int width, int height, double rms_px, std::uint32_t seed);

/// The moment at which a picture is taken.
struct Moment {
  /// Pose of the left camera; 0 is the stamp, 1 the stamp of the next frame.
  std::function<Eigen::Isometry3d(double part)> T_town_left;
  double interval_s = 0.1;     ///< from part 0 to part 1
  double gain = 255;           ///< grey levels for a radiance of 1
  std::uint32_t exposure = 0;  ///< number of the image in the run, different for left and right
  /// Sets the motions of objects from part `begin` to part `end`.
  std::function<void(double begin, double end, OpenShutter& shutter)> follow;
};

class TownCamera {
 public:
  /// `index`: 0 left, 1 right.
  TownCamera(const TownParameters& parameters, const CameraRig& calibrated, TrueCamera truth,
             std::size_t index, std::uint32_t run_seed);

  /// Light spreads in the lens as much as by night.
  void bloom() { blooms_ = true; }
  Image take(Renderer& renderer, const Light& light, const Moment& moment);
  /// The last rendered image, without blur: that at the stamp.
  const RenderedImage& rendered() const { return rendered_; }

 private:
  /// T_town_camera; parts as in Moment.
  Eigen::Isometry3d poseAt(const Moment& moment, double part) const;
  RenderCamera viewAt(const Moment& moment) const;
  /// Mean radiance while the shutter is open, from half of `open` (a share of the time to the next
  /// frame) before the stamp to half after.
  std::vector<float>& openShutter(Renderer& renderer, const Moment& moment, double open);
  Rain rainAt(const Light& light, const Moment& moment, double open) const;
  Sensor sensorFor(const Moment& moment, double amplification) const;

  TownParameters parameters_;
  int width_;
  int height_;
  TrueCamera truth_;
  std::size_t index_;
  std::uint32_t run_seed_;
  bool blooms_ = false;
  RenderedImage rendered_;
  std::vector<float> blurred_;
};

}  // namespace tolman::town
