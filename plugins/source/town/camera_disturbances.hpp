// SPDX-License-Identifier: BSD-3-Clause
// Parameters of deviations of the cameras from their calibration and from ideal images; all off by
// default. Lengths in px are those of scale 1.
#pragma once

#include <concepts>
#include <cstdint>
#include <tuple>
#include <vector>

#include "tolman/parameters.hpp"

namespace tolman::town {

/// Base of the source's Parameters. Lists are [left, right] unless said otherwise.
/// docs/town.md has usual values; exposure_time_max_ms is that of KITTI.
struct CameraDisturbances {
  std::int64_t camera_seed = 1;
  double warp_rms_px = 0;
  std::vector<double> focal_length_error = {0, 0};
  std::vector<double> principal_point_error_px = {0, 0, 0, 0};  ///< left x, y, right x, y
  std::vector<double> right_rotation_error_deg = {0, 0, 0};     ///< yaw, pitch, roll
  double readout_time_ms = 0;
  double exposure_time_ms = 0;
  double exposure_time_max_ms = 2;
  std::vector<double> gain = {1, 1};
  std::vector<double> gamma = {1, 1};
  std::vector<double> vignetting_error = {0, 0};
  double bloom = 0;
  double dirt = 0;
  double drops = 0;
  std::int64_t jpeg_quality = 0;
};

namespace detail {

template <class P>
constexpr auto geometryDisturbances() {
  return parameters(
      parameter<P, std::int64_t>("camera_seed", &P::camera_seed)
          .range(0, 4294967295.0)
          .doc("Seed of warp, dirt and drops: another pair of cameras in the same town."),
      parameter<P, double>("warp_rms_px", &P::warp_rms_px)
          .range(0, 10)
          .unit("px")
          .doc("Smooth displacement of each image that the calibration does not know, root mean "
               "square of its length at scale 1; left and right differ."),
      parameter<P, std::vector<double>>("focal_length_error", &P::focal_length_error)
          .range(-0.1, 0.1)
          .doc("[left, right] relative error of the calibrated focal length: true / calibrated - "
               "1."),
      parameter<P, std::vector<double>>("principal_point_error_px", &P::principal_point_error_px)
          .range(-50, 50)
          .unit("px")
          .doc("[left x, left y, right x, right y] true minus calibrated principal point at scale "
               "1."),
      parameter<P, std::vector<double>>("right_rotation_error_deg", &P::right_rotation_error_deg)
          .range(-5, 5)
          .unit("deg")
          .doc("[yaw, pitch, roll] true rotation of the right camera, unknown to the calibration: "
               "positive turns right, up, clockwise; on top of rotation_error."),
      parameter<P, double>("readout_time_ms", &P::readout_time_ms)
          .range(0, 100)
          .unit("ms")
          .doc("Rolling shutter: time from the first row to the last; the middle row is taken at "
               "the stamp. 0 is a global shutter."));
}

template <class P>
constexpr auto exposureDisturbances() {
  return parameters(
      parameter<P, double>("exposure_time_ms", &P::exposure_time_ms)
          .range(0, 100)
          .unit("ms")
          .doc("Exposure time in the sun of a clear noon; less light demands a longer one, and "
               "images blur with it. 0: neither blur nor noise depend on the light."),
      parameter<P, double>("exposure_time_max_ms", &P::exposure_time_max_ms)
          .range(0.01, 1000)
          .unit("ms")
          .doc("Longest exposure time; beyond it the camera amplifies the signal with its noise."),
      parameter<P, std::vector<double>>("gain", &P::gain)
          .range(0.1, 10)
          .doc("[left, right] factor of the grey levels of one camera."),
      parameter<P, std::vector<double>>("gamma", &P::gamma)
          .range(0.2, 5)
          .doc("[left, right] exponent of the response; 1 is linear, below 1 lifts dark tones."));
}

template <class P>
constexpr auto lensDisturbances() {
  return parameters(
      parameter<P, std::vector<double>>("vignetting_error", &P::vignetting_error)
          .range(-0.5, 0.5)
          .doc("[left, right] share of light that the corners of one camera lose in addition to "
               "vignetting."),
      parameter<P, double>("bloom", &P::bloom)
          .range(0, 1)
          .doc("Share of the light beyond saturation that spreads over the pixels around it."),
      parameter<P, double>("dirt", &P::dirt)
          .range(0, 0.9)
          .doc("Share of each image that dirt on the glass dims."),
      parameter<P, double>("drops", &P::drops)
          .range(0, 300)
          .doc("Drops of water on the glass of each camera; each stays for 2 to 8 s."),
      parameter<P, std::int64_t>("jpeg_quality", &P::jpeg_quality)
          .range(0, 100)
          .doc("Compression of the images at this JPEG quality, 1 to 100; 0: none."));
}

}  // namespace detail

template <std::derived_from<CameraDisturbances> P>
constexpr auto cameraDisturbances() {
  return std::tuple_cat(detail::geometryDisturbances<P>(), detail::exposureDisturbances<P>(),
                        detail::lensDisturbances<P>());
}

}  // namespace tolman::town
