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

std::vector<float>& TownCamera::openShutter(Renderer& renderer, const Moment& moment,
                                            double time_ms) {
  const double open = parameters_.motion_blur;
  const int shots = open > 0 ? 5 : 1;              // bounds the time
  for (int shot = shots - 1; shot >= 0; --shot) {  // the first one last, to keep its depth
    renderer.render(viewAt(moment, open * shot / shots), rendered_);
    if (shots == 1) break;
    if (shot == shots - 1) blurred_.assign(rendered_.radiance.size(), 0);
    for (std::size_t i = 0; i < blurred_.size(); ++i) {
      blurred_[i] += rendered_.radiance[i] / static_cast<float>(shots);
    }
  }
  if (time_ms <= 0) return shots > 1 ? blurred_ : rendered_.radiance;
  const double half = 0.5 * time_ms * 1e-3 / moment.interval_s;
  RenderCamera view = viewAt(moment, 0);
  blurred_ = shutterBlur(view, shots > 1 ? blurred_ : rendered_.radiance, rendered_.depth,
                         poseAt(moment, half).inverse() * poseAt(moment, -half));
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

Rain TownCamera::rainAt(const Light& light, const Moment& moment, const Exposure& exposure) const {
  const Eigen::Vector3d step =
      moment.T_town_left(1).translation() - moment.T_town_left(0).translation();
  Rain rain;
  rain.density = light.rain;
  // A little brighter than the sky behind: chosen, not tuned.
  rain.brightness = 1.1F * (light.horizon + 0.02F * light.lamps);
  if (exposure.time_ms > 0) rain.exposure_s = exposure.time_ms * 1e-3;
  rain.speed_m_s = step.norm() / moment.interval_s;
  rain.seed = hash(run_seed_, moment.exposure / 2, 404);  // one for both cameras
  return rain;
}

Image TownCamera::take(Renderer& renderer, const Light& light, const Moment& moment) {
  const TownParameters& p = parameters_;
  const Exposure exposure = exposureFor(light, p.exposure_time_ms, p.exposure_time_max_ms);
  renderer.setLight(light);
  std::vector<float>& radiance = openShutter(renderer, moment, exposure.time_ms);
  const Sensor sensor = sensorFor(moment, exposure.amplification);
  if (light.rain > 0)
    addRain(radiance, viewAt(moment, 0), truth_.T_left_camera, rainAt(light, moment, exposure));
  if (!glass_.isClean()) glass_.apply(radiance, light.horizon, moment.seconds);
  if (p.bloom > 0) {
    addBloom(radiance, width_, height_, static_cast<float>(255 / sensor.gain),
             static_cast<float>(p.bloom), p.scale);
  }
  Image image = expose(sensor, radiance, moment.exposure);
  return p.jpeg_quality > 0 ? throughJpeg(image, static_cast<int>(p.jpeg_quality)) : image;
}

}  // namespace tolman::town
