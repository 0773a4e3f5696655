// SPDX-License-Identifier: BSD-3-Clause
#include "town_camera.hpp"

#include <algorithm>

#include "bloom.hpp"
#include "jpeg_noise.hpp"
#include "noise.hpp"
#include "shutter_blur.hpp"

namespace tolman::town {

TownCamera::TownCamera(const TownParameters& parameters, const CameraRig& calibrated,
                       TrueCamera truth, std::size_t index, std::uint32_t run_seed)
    : parameters_(parameters),
      width_(calibrated.width),
      height_(calibrated.height),
      truth_(std::move(truth)),
      index_(index),
      run_seed_(run_seed),
      glass_({width_, height_, parameters.scale}, parameters.dirt, parameters.drops,
             hash(static_cast<std::uint32_t>(parameters.camera_seed),
                  static_cast<std::uint32_t>(index), 502)) {}

Eigen::Isometry3d TownCamera::poseAt(const Moment& moment, double part) const {
  return moment.T_town_left(part) * truth_.T_left_camera;
}

RenderCamera TownCamera::viewAt(const Moment& moment, double part) const {
  RenderCamera view;
  view.T_town_camera = poseAt(moment, part);
  view.pinhole = truth_.pinhole;
  view.width = width_;
  view.height = height_;
  view.warp = &truth_.warp;
  const double readout = parameters_.readout_time_ms * 1e-3 / moment.interval_s;
  for (int row = 0; readout > 0 && row < height_; ++row) {
    view.T_town_rows.push_back(poseAt(moment, part + readout * ((row + 0.5) / height_ - 0.5)));
  }
  return view;
}

double TownCamera::openShare(const Moment& moment, const Exposure& exposure) const {
  return std::max(parameters_.motion_blur, exposure.time_ms * 1e-3 / moment.interval_s);
}

std::vector<float>& TownCamera::openShutter(Renderer& renderer, const Moment& moment, double open) {
  const RenderCamera view = viewAt(moment, 0);
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
  sensor.gain = moment.gain * p.gain[index_];
  sensor.gamma = p.gamma[index_];
  sensor.vignetting = p.vignetting + p.vignetting_error[index_];
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
  const Exposure exposure = exposureFor(light, p.exposure_time_ms, p.exposure_time_max_ms);
  renderer.setLight(light);
  const double open = openShare(moment, exposure);
  std::vector<float>& radiance = openShutter(renderer, moment, open);
  const Sensor sensor = sensorFor(moment, exposure.amplification);
  if (light.rain > 0)
    addRain(radiance, viewAt(moment, 0), truth_.T_left_camera, rainAt(light, moment, open));
  if (!glass_.isClean()) glass_.apply(radiance, light.horizon, moment.seconds);
  if (p.bloom > 0) {
    addBloom(radiance, width_, height_, static_cast<float>(255 / sensor.gain),
             static_cast<float>(p.bloom), p.scale);
  }
  Image image = expose(sensor, radiance, moment.exposure);
  return p.jpeg_quality > 0 ? throughJpeg(image, static_cast<int>(p.jpeg_quality)) : image;
}

}  // namespace tolman::town
