// SPDX-License-Identifier: BSD-3-Clause
// One camera of the rig: its image in grey levels, with shutter and glass.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "exposure.hpp"
#include "lens_glass.hpp"
#include "light.hpp"
#include "pixel_paths.hpp"
#include "rain_streaks.hpp"
#include "renderer.hpp"
#include "sensor.hpp"
#include "tolman/image.hpp"
#include "true_camera.hpp"

namespace tolman::town {

/// The moment at which a picture is taken.
struct Moment {
  /// Pose of the left camera; 0 is the stamp, 1 the stamp of the next frame.
  std::function<Eigen::Isometry3d(double part)> T_town_left;
  double interval_s = 0.1;     ///< from part 0 to part 1
  double seconds = 0;          ///< since the start of the drive
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

  Image take(Renderer& renderer, const Light& light, const Moment& moment);
  /// The last rendered image, without blur: that at the stamp.
  const RenderedImage& rendered() const { return rendered_; }

 private:
  /// T_town_camera; parts as in Moment.
  Eigen::Isometry3d poseAt(const Moment& moment, double part) const;
  RenderCamera viewAt(const Moment& moment, double part) const;
  /// Time that the shutter is open, as a share of the time to the next frame.
  double openShare(const Moment& moment, const Exposure& exposure) const;
  /// Mean radiance while the shutter is open, from half of `open` before the stamp to half after.
  std::vector<float>& openShutter(Renderer& renderer, const Moment& moment, double open);
  Rain rainAt(const Light& light, const Moment& moment, double open) const;
  Sensor sensorFor(const Moment& moment, double amplification) const;

  TownParameters parameters_;
  int width_;
  int height_;
  TrueCamera truth_;
  std::size_t index_;
  std::uint32_t run_seed_;
  LensGlass glass_;
  RenderedImage rendered_;
  std::vector<float> blurred_;
};

}  // namespace tolman::town
