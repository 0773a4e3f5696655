// SPDX-License-Identifier: BSD-3-Clause
#include "camera.hpp"

#include <cmath>
#include <numbers>

#include "noise.hpp"
#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {
namespace {

// Errors of cameras as on a road (docs/town.md), left and right; of camera_error 1.
constexpr double kWarp = 0.3;  // px
constexpr double kPrincipalPoint[2][2] = {{0.2, -0.2}, {0.2, 0.2}};
constexpr double kGain[2] = {0.03, -0.02};
constexpr double kDarker[2] = {0.05, 0.1};  // in the corners
constexpr double kBloom = 0.02;
constexpr double kBloomByNight = 0.03;
constexpr double kVignetting = 0.25;  // of calibrated cameras

constexpr std::uint32_t kCameraSeed = 1;

/// Adds random amplitudes of cos(pi m (u + 0.5) / width) cos(pi n (v + 0.5) / height), which have
/// no mean over the image.
std::vector<double> waves(int width, int height, RandomStream& random) {
  const auto wave = [](int half_periods, int i, int size) {
    return std::cos(std::numbers::pi * half_periods * (i + 0.5) / size);
  };
  std::vector<double> field(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int n = 0; n < 3; ++n) {
    for (int m = n == 0 ? 1 : 0; m < 4; ++m) {
      const double amplitude = random.uniform(-1, 1) / static_cast<double>(m * m + n * n);
      std::vector<double> across;
      for (int u = 0; u < width; ++u) across.push_back(wave(m, u, width));
      std::size_t at = 0;
      for (int v = 0; v < height; ++v) {
        const double row = wave(n, v, height);
        for (const double column : across) field[at++] += amplitude * row * column;
      }
    }
  }
  return field;
}

}  // namespace

PixelWarp makeWarp(int width, int height, double rms_px, std::uint32_t seed) {
  if (rms_px <= 0) return {};
  RandomStream random(seed);
  const std::vector<double> x = waves(width, height, random);
  const std::vector<double> y = waves(width, height, random);
  double squares = 0;
  for (std::size_t i = 0; i < x.size(); ++i) squares += x[i] * x[i] + y[i] * y[i];
  const double factor = rms_px / std::sqrt(squares / static_cast<double>(x.size()));
  PixelWarp warp;
  for (std::size_t i = 0; i < x.size(); ++i) {
    warp.x.push_back(static_cast<float>(factor * x[i]));
    warp.y.push_back(static_cast<float>(factor * y[i]));
  }
  return warp;
}

std::array<TrueCamera, 2> trueCameras(const TownParameters& p, const CameraRig& calibrated) {
  std::array<TrueCamera, 2> cameras;
  for (std::size_t i = 0; i < 2; ++i) {
    TrueCamera& camera = cameras[i];
    camera.pinhole = calibrated.pinhole;
    camera.pinhole.fx *= 1 + p.focalError();
    camera.pinhole.fy *= 1 + p.focalError();
    camera.pinhole.cx += p.scale * (p.camera_error * kPrincipalPoint[i][0]);
    camera.pinhole.cy += p.scale * (p.camera_error * kPrincipalPoint[i][1]);
    camera.warp = makeWarp(calibrated.width, calibrated.height, p.scale * (p.camera_error * kWarp),
                           hash(kCameraSeed, static_cast<std::uint32_t>(i), 501));
  }
  constexpr double kDegree = std::numbers::pi / 180;
  // X is right, Y down, Z forward.
  const Eigen::Vector3d turn(itemOf(p.rig_error, 3), itemOf(p.rig_error, 2),
                             itemOf(p.rig_error, 4));
  if (!turn.isZero(0)) cameras[1].T_left_camera.linear() = expSo3(turn * kDegree);
  cameras[1].T_left_camera.translation().x() = calibrated.baseline * (1 + p.baselineError());
  return cameras;
}

TownCamera::TownCamera(const TownParameters& parameters, const CameraRig& calibrated,
                       TrueCamera truth, std::size_t index, std::uint32_t run_seed)
    : parameters_(parameters),
      width_(calibrated.width),
      height_(calibrated.height),
      truth_(std::move(truth)),
      index_(index),
      run_seed_(run_seed) {}

Eigen::Isometry3d TownCamera::poseAt(const Moment& moment, double part) const {
  return moment.T_town_left(part) * truth_.T_left_camera;
}

RenderCamera TownCamera::viewAt(const Moment& moment) const {
  RenderCamera view = {poseAt(moment, 0), truth_.pinhole, width_, height_, &truth_.warp, {}};
  const double readout = parameters_.readoutMs() * 1e-3 / moment.interval_s;
  for (int row = 0; readout > 0 && row < height_; ++row) {
    view.T_town_rows.push_back(poseAt(moment, readout * ((row + 0.5) / height_ - 0.5)));
  }
  return view;
}

std::vector<float>& TownCamera::openShutter(Renderer& renderer, const Moment& moment, double open) {
  const RenderCamera view = viewAt(moment);
  renderer.render(view, rendered_);
  if (open <= 0) return rendered_.radiance;
  const auto fromMiddle = [&](double part) {
    return poseAt(moment, part).inverse() * view.T_town_camera;
  };
  OpenShutter shutter;
  shutter.camera = {fromMiddle(-open / 2), fromMiddle(open / 2)};
  moment.follow(-open / 2, open / 2, shutter);
  blurred_ = shutterBlur(view, rendered_, shutter);
  return blurred_;
}

Sensor TownCamera::sensorFor(const Moment& moment, double amplification) const {
  const TownParameters& p = parameters_;
  Sensor sensor;
  sensor.width = width_;
  sensor.height = height_;
  sensor.gain = moment.gain * (1 + p.camera_error * kGain[index_]);
  sensor.vignetting = kVignetting + p.camera_error * kDarker[index_];
  // Grey levels, and grey levels^2 per grey level; together about 1.5 grey levels (docs/town.md).
  // Chosen, not tuned.
  sensor.read_noise = 0.8 * p.noise * amplification;
  sensor.shot_noise = 0.015 * p.noise * p.noise * amplification;
  sensor.seed = run_seed_;
  return sensor;
}

Rain TownCamera::rainAt(const Light& light, const Moment& moment, double open) const {
  const Eigen::Vector3d step =
      moment.T_town_left(1).translation() - moment.T_town_left(0).translation();
  Rain rain;
  rain.density = light.rain;
  // A little brighter than the sky behind: chosen, not tuned.
  rain.brightness = 1.1F * (light.horizon + 0.02F * light.lamps);
  if (open > 0) rain.exposure_s = open * moment.interval_s;
  rain.speed_m_s = step.norm() / moment.interval_s;
  rain.seed = hash(run_seed_, moment.exposure / 2, 404);  // one for both cameras
  return rain;
}

Image TownCamera::take(Renderer& renderer, const Light& light, const Moment& moment) {
  const TownParameters& p = parameters_;
  const Exposure exposure = exposureFor(light, p.exposure_ms);
  renderer.setLight(light);
  const double open = exposure.time_ms * 1e-3 / moment.interval_s;
  std::vector<float>& radiance = openShutter(renderer, moment, open);
  const Sensor sensor = sensorFor(moment, exposure.amplification);
  const ImageSize size = {width_, height_, p.scale};
  if (light.rain > 0) {
    addRain(radiance, viewAt(moment), truth_.T_left_camera, rainAt(light, moment, open));
  }
  const double bloom = std::max(p.camera_error * kBloom, blooms_ ? kBloomByNight : 0.0);
  if (bloom > 0) {
    addBloom(radiance, size, static_cast<float>(255 / sensor.gain), static_cast<float>(bloom));
  }
  return expose(sensor, radiance, moment.exposure);
}

}  // namespace tolman::town
