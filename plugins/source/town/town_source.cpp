// SPDX-License-Identifier: BSD-3-Clause
#include "town_source.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "buildings.hpp"
#include "depth_array.hpp"
#include "noise.hpp"
#include "tolman/geometry.hpp"

namespace tolman::town {
namespace {

constexpr int kEdgeSamples = 2;

bool isFile(const std::string& route) { return route.find_first_of("/.") != std::string::npos; }

Result<CameraRoute> findRoute(const TownParameters& p) {
  const RouteOptions options = {p.rate, p.speed, p.cameraHeight()};
  if (isFile(p.route)) return readRoute(p.route, options);
  Result<CameraRoute> route = builtInRoute(p.route, options);
  if (!route.isOk() || !p.flight) return route;
  if (route.value().building == Building::None) return flown(route.value());
  return Status::invalidParameter("flight: the route " + p.route +
                                  " is inside a building; use another, or flight: false");
}

/// The route of a vehicle on the streets, for the path of the camera.
CameraRoute streetsFor(const CameraRoute& way, const TownParameters& p) {
  if (way.building == Building::Hall) return streetBesideHall(way);
  return p.flight ? groundTrack(way) : way;
}

/// Between poses `index` (part 0) and the next (part 1), or as far before the former.
Eigen::Isometry3d poseAt(const std::vector<Eigen::Isometry3d>& poses, std::size_t index,
                         double part) {
  if (part == 0) return poses[index];
  const std::size_t from = std::min(index, poses.size() - 2);
  const Vector6d step = logSe3(poses[from].inverse() * poses[from + 1]);
  return poses[index] * expSe3(part * step);
}

Status checkLists(const TownParameters& p) {
  std::string wanted;
  if (p.camera.size() != 7) wanted = "camera: give [width, height, fx, fy, cx, cy, baseline]";
  if (p.mount.empty() || p.mount.size() > 3 || p.mount[0] < 0.5 || p.mount[0] > 4) {
    wanted = "mount: give [height, pitch, roll], the height from 0.5 to 4 m";
  }
  if (p.rig_error.size() > 6 || p.readoutMs() < 0 ||
      std::min(p.focalError(), p.baselineError()) < -0.5) {
    wanted =
        "rig_error: give at most [focal length, baseline, yaw, pitch, roll, readout], the "
        "first two above -0.5, the last not negative";
  }
  if (p.exposure_ms.empty() || p.exposure_ms.size() > 2) {
    wanted = "exposure_ms: give [time] or [time in the sun, longest]";
  }
  return wanted.empty() ? Status::ok() : Status::invalidParameter(wanted);
}

}  // namespace

Status TownSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  run_seed_ = hash(static_cast<std::uint32_t>(context.seed),
                   static_cast<std::uint32_t>(context.seed >> 32U));
  return ready_ = build(context);
}

Status TownSource::build(const Context& context) {
  if (Status status = checkLists(parameters_); !status.isOk()) return status;
  if (Status status = setRig(); !status.isOk()) return status;
  if (Status status = setRoute(); !status.isOk()) return status;
  if (Status status = setConditions(context); !status.isOk()) return status;
  buildScene();
  return Status::ok();
}

Status TownSource::setRig() {
  const Parameters& p = parameters_;
  const double s = p.scale;
  rig_.width = static_cast<int>(std::lround(p.camera[0] * s));
  rig_.height = static_cast<int>(std::lround(p.camera[1] * s));
  constexpr std::int64_t kMostPixels = std::int64_t{8192} * 8192;  // a run uses 1.5 GiB and more
  if (rig_.width < 32 || rig_.height < 32 || std::int64_t{rig_.width} * rig_.height > kMostPixels) {
    return Status::invalidParameter(
        "camera and scale make images of " + std::to_string(rig_.width) + " x " +
        std::to_string(rig_.height) + " px; choose 32 x 32 px or more, and 8192 x 8192 px at most");
  }
  rig_.calibrated = true;
  // Pixel centres are at integers, so the image spans from -0.5.
  rig_.pinhole = {p.camera[2] * s, p.camera[3] * s, (p.camera[4] + 0.5) * s - 0.5,
                  (p.camera[5] + 0.5) * s - 0.5};
  rig_.baseline = p.mono ? 0 : p.camera[6];
  std::array<TrueCamera, 2> truth = trueCameras(p, rig_);
  cameras_.clear();
  for (std::size_t i = 0; i < 2; ++i) {
    cameras_.emplace_back(p, rig_, std::move(truth[i]), i, run_seed_);
  }
  return Status::ok();
}

Status TownSource::setRoute() {
  const Parameters& p = parameters_;
  Result<CameraRoute> route = findRoute(p);
  if (!route.isOk()) return route.status();
  route_ = streetsFor(route.value(), p);
  Result<FrameSequence> sequence = FrameSequence::make(p, route_.stamps_ns);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = sequence.value();
  arriving_.clear();
  for (std::int64_t k = 0; k < sequence_.size(); ++k) {
    const bool lost = k > 0 && unit(hash(run_seed_, static_cast<std::uint32_t>(k), 401)) <
                                   static_cast<float>(p.faults);
    if (!lost) arriving_.push_back(k);
  }
  Result<StreetPlan> plan = StreetPlan::grow(route_, p.cameraHeight());
  is_levelled_ = false;
  if (!plan.isOk()) {
    CameraRoute level = groundTrack(route_);
    Result<StreetPlan> again = StreetPlan::grow(level, p.cameraHeight());
    if (!again.isOk()) return plan.status();
    route_ = std::move(level);
    plan = std::move(again);
    is_levelled_ = true;
  }
  plan_ = std::make_unique<StreetPlan>(std::move(plan.value()));
  const bool has_own_way = p.flight || route_.building == Building::Hall;
  return setMotion(has_own_way ? route.value() : route_);
}

Status TownSource::setMotion(const CameraRoute& carried) {
  const Parameters& p = parameters_;
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
  };
  const Eigen::Isometry3d T_route_camera(turn(itemOf(p.mount, 1), Eigen::Vector3d::UnitX()) *
                                         turn(itemOf(p.mount, 2), Eigen::Vector3d::UnitZ()));
  const double ground = route_.T_town_camera.front().translation().z() - p.cameraHeight();
  T_town_camera_.clear();
  for (const Eigen::Isometry3d& T_town_route : carried.T_town_camera) {
    T_town_camera_.push_back(T_town_route * T_route_camera);
    const double height = T_town_camera_.back().translation().z() - ground;
    if (p.flight && height < 0.3) {
      return Status::invalidInput(p.route + ": pose " + std::to_string(T_town_camera_.size() - 1) +
                                  " is " + std::to_string(height) +
                                  " m above the ground; give mount a larger height");
    }
  }
  return Status::ok();
}

Status TownSource::setConditions(const Context& context) {
  const auto seed = static_cast<std::uint32_t>(parameters_.seed);
  Result<Conditions> conditions = Conditions::make(parameters_.conditions, route_, seed);
  if (!conditions.isOk()) return conditions.status();
  conditions_ = std::move(conditions.value());
  for (const std::string& warning : conditions_.warnings()) context.log.warning(warning);
  if (conditions_.any([](const Condition& c) { return c.is_night; })) {
    for (TownCamera& camera : cameras_) camera.bloom();
  }
  return Status::ok();
}

void TownSource::buildScene() {
  const Parameters& p = parameters_;
  const auto seed = static_cast<std::uint32_t>(p.seed);
  WorldOptions options;
  options.seed = seed;
  options.aliasing = p.aliasing;
  if (route_.building == Building::CarPark) options.reserved.push_back(carParkPlot());
  if (route_.building == Building::Hall) options.reserved.push_back(hallPlot());
  if (route_.is_highway) options.density = 0.12;  // open land
  options.guard_rails = route_.is_highway;
  World world = buildWorld(*plan_, options);
  if (route_.building == Building::CarPark) addCarPark(world, -p.cameraHeight(), hash(seed, 311));
  if (route_.building == Building::Hall) addHall(world, -p.cameraHeight(), hash(seed, 312));
  const bool any_bare = conditions_.any([](const Condition& c) { return c.bare; });
  const bool any_exchanged = conditions_.any([](const Condition& c) { return c.exchanged; });
  trees_ = any_bare ? addBareTrees(world) : Exchange{};
  cars_ = any_exchanged ? addOtherCars(world, hash(seed, 304)) : Exchange{};
  traffic_ = Traffic(route_, *plan_, p.traffic, seed, world);
  scene_ = std::make_unique<Scene>(std::move(world));
  shown_ = {};
  for (const Exchange* exchange : {&trees_, &cars_}) {
    for (const std::size_t hidden : exchange->other) scene_->show(hidden, false);
  }
  if (any_bare || any_exchanged) scene_->commit();
  renderers_.assign(2, Renderer(*scene_, *plan_, Light{}, kEdgeSamples));
}

Status TownSource::reset() {
  next_ = 0;
  return ready_;
}

Status TownSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.rig = rig_;
  info.frames = static_cast<std::int64_t>(arriving_.size());
  info.has_truth = true;
  info.description = "town, route " + route_.name + (is_levelled_ ? " (levelled), " : ", ") +
                     std::to_string(info.frames) +
                     (parameters_.mono ? " images of " : " stereo pairs of ") +
                     std::to_string(rig_.width) + "x" + std::to_string(rig_.height);
  return Status::ok();
}

double TownSource::secondsAt(std::size_t index) const {
  return static_cast<double>(route_.stamps_ns[index] - route_.stamps_ns[0]) * 1e-9;
}

double TownSource::intervalAt(std::size_t index) const {
  const std::vector<std::int64_t>& stamps = route_.stamps_ns;
  const std::size_t from = std::min(index, stamps.size() - 2);
  return static_cast<double>(stamps[from + 1] - stamps[from]) * 1e-9;
}

Traffic::Instant TownSource::instantAt(std::size_t index, double part) const {
  return {secondsAt(index) + part * intervalAt(index), poseAt(route_.T_town_camera, index, part)};
}

void TownSource::arrange(std::size_t index) {
  const Condition& now = conditions_.at(index);
  const auto exchange = [&](const Exchange& both, bool other) {
    for (const std::size_t i : both.usual) scene_->show(i, !other);
    for (const std::size_t i : both.other) scene_->show(i, other);
  };
  const bool is_changed = now.bare != shown_.bare || now.exchanged != shown_.exchanged;
  if (now.bare != shown_.bare) exchange(trees_, now.bare);
  if (now.exchanged != shown_.exchanged) exchange(cars_, now.exchanged);
  shown_ = now;
  const bool moves = traffic_.arrange(*scene_, instantAt(index, 0));
  if (is_changed || moves) scene_->commit();
  light_ = conditions_.lightAt(index);
  if (light_.sun > 0) scene_->setSun(light_.to_sun);
  // The lamps of the camera's car: below and ahead of it, one in the middle for both.
  const Eigen::Isometry3d& T_town_left = route_.T_town_camera[index];
  light_.headlights = {toVec3(T_town_left * Eigen::Vector3d(0, 0.95, 1.6)),
                       toVec3(T_town_left.linear().col(2))};
}

double TownSource::gainAt(std::size_t index) const {
  // Sunlit asphalt (albedo 0.2) has a grey level of about 110 of 255 at any hour; chosen, not
  // tuned.
  const double asphalt = 0.2 * static_cast<double>(light_.level());
  const double seconds = static_cast<double>(route_.stamps_ns[index]) * 1e-9;
  const double wander =
      static_cast<double>(noise2(static_cast<float>(seconds / 4), 0.5F, hash(run_seed_, 402)));
  return 110 / asphalt * std::exp(parameters_.exposure_change * wander);
}

Image TownSource::takePicture(std::size_t index, std::size_t camera) {
  Moment moment;
  moment.T_town_left = [this, index](double part) { return poseAt(T_town_camera_, index, part); };
  moment.follow = [this, index](double begin, double end, OpenShutter& shutter) {
    traffic_.follow(instantAt(index, begin), instantAt(index, 0), instantAt(index, end), shutter);
  };
  moment.interval_s = intervalAt(index);
  moment.gain = gainAt(index);
  moment.exposure = static_cast<std::uint32_t>(2 * next_ + camera);
  return cameras_[camera].take(renderers_[camera], light_, moment);
}

Status TownSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_ >= arriving_.size()) return Status::endOfStream();
  const std::int64_t k = arriving_[next_];
  const auto index = static_cast<std::size_t>(sequence_.sourceIndex(k));
  frame.frame = static_cast<std::int64_t>(next_);
  frame.stamp_ns = sequence_.stampNs(k);
  frame.source_index = static_cast<std::int64_t>(index);
  frame.has_truth = true;
  frame.T_world_camera_truth = T_town_camera_.front().inverse() * T_town_camera_[index];
  if (unit(hash(run_seed_, static_cast<std::uint32_t>(k), 403)) <
      static_cast<float>(parameters_.faults)) {
    frame.defect = "town: no image, as the parameter faults demands";
  } else {
    arrange(index);
    const auto left = [&] { frame.left = takePicture(index, 0); };
    const auto right = [&] {
      if (rig_.isStereo()) frame.right = takePicture(index, 1);
    };
    oneapi::tbb::parallel_invoke(left, right);
    if (parameters_.depth) {
      frame.sensors.push_back(
          {"depth.left", {rig_.height, rig_.width}, cameras_[0].rendered().depth});
    }
  }
  ++next_;
  return Status::ok();
}

Status TownSource::describe(std::vector<ArrayInfo>& arrays) const {
  if (!parameters_.depth) return Status::ok();
  arrays.push_back(source_parameters::depthArray(
      "depth.left", "true depth of the left image along the optical axis; 0 for the sky"));
  return Status::ok();
}

}  // namespace tolman::town
