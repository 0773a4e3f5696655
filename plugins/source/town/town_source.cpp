// SPDX-License-Identifier: BSD-3-Clause
#include "town_source.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "bridges.hpp"
#include "car_park.hpp"
#include "flown_route.hpp"
#include "hall.hpp"
#include "level_route.hpp"
#include "noise.hpp"
#include "true_camera.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

bool isFile(const std::string& route) { return route.find_first_of("/.") != std::string::npos; }

Result<CameraRoute> findRoute(const TownParameters& p) {
  const RouteOptions options = {p.rate, p.speed, p.camera_height};
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

using Poses = std::vector<Eigen::Isometry3d>;

/// Between poses `index` (part 0) and the next (part 1), or as far before the former.
Eigen::Isometry3d poseAt(const Poses& poses, std::size_t index, double part) {
  if (part == 0) return poses[index];
  const std::size_t from = std::min(index, poses.size() - 2);
  const Vector6d step = logSe3(poses[from].inverse() * poses[from + 1]);
  return poses[index] * expSe3(part * step);
}

}  // namespace

Status TownSource::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return ready_ = bound.status();
  parameters_ = bound.value();
  run_seed_ = hash(static_cast<std::uint32_t>(context.seed),
                   static_cast<std::uint32_t>(context.seed >> 32U));
  ready_ = setRig();
  if (ready_.isOk()) ready_ = build();
  for (const std::string& warning : schedule_.warnings()) context.log.warning(warning);
  return ready_;
}

Status TownSource::setRig() {
  const Parameters& p = parameters_;
  const double s = p.scale;
  rig_.width = static_cast<int>(std::lround(static_cast<double>(p.width) * s));
  rig_.height = static_cast<int>(std::lround(static_cast<double>(p.height) * s));
  if (rig_.width < 32 || rig_.height < 32) {
    return Status::invalidParameter("scale leaves an image below 32 px; choose a larger one");
  }
  constexpr std::int64_t kMostPixels = std::int64_t{8192} * 8192;  // a run uses 1.5 GiB and more
  if (std::int64_t{rig_.width} * rig_.height > kMostPixels) {
    return Status::invalidParameter(
        "scale makes images of " + std::to_string(rig_.width) + " x " +
        std::to_string(rig_.height) +
        " px, and 8192 x 8192 px are rendered at most; choose a smaller width, height or scale");
  }
  rig_.calibrated = true;
  // Pixel centres are at integers, so the image spans from -0.5.
  rig_.pinhole = {p.fx * s, p.fy * s, (p.cx + 0.5) * s - 0.5, (p.cy + 0.5) * s - 0.5};
  rig_.baseline = p.mono ? 0 : p.baseline;
  Result<std::array<TrueCamera, 2>> truth = trueCameras(p, rig_);
  if (!truth.isOk()) return truth.status();
  cameras_.clear();
  for (std::size_t i = 0; i < 2; ++i) {
    cameras_.emplace_back(p, rig_, std::move(truth.value()[i]), i, run_seed_);
  }
  return Status::ok();
}

Status TownSource::build() {
  const Parameters& p = parameters_;
  Result<CameraRoute> route = findRoute(p);
  if (!route.isOk()) return route.status();
  route_ = streetsFor(route.value(), p);
  is_levelled_ = false;
  Result<FrameSequence> sequence = FrameSequence::make(p, route_.stamps_ns);
  if (!sequence.isOk()) return sequence.status();
  sequence_ = sequence.value();
  chooseFrames();
  if (p.crossings == Crossings::Bridge) route_ = bridged(route_, p.camera_height);
  Result<StreetPlan> plan = StreetPlan::grow(route_, p.camera_height);
  if (!plan.isOk() && p.crossings != Crossings::Refuse) {
    CameraRoute level = levelled(route_, p.camera_height);
    Result<StreetPlan> again = StreetPlan::grow(level, p.camera_height);
    if (again.isOk()) {
      route_ = std::move(level);
      plan = std::move(again);
      is_levelled_ = true;
    }
  }
  if (!plan.isOk()) return plan.status();
  plan_ = std::make_unique<StreetPlan>(std::move(plan.value()));
  Result<ConditionSchedule> schedule = ConditionSchedule::make(p, route_);
  if (!schedule.isOk()) return schedule.status();
  schedule_ = std::move(schedule.value());
  buildScene();
  const bool has_own_way = p.flight || route_.building == Building::Hall;
  return placeCameras(has_own_way ? route.value() : route_);
}

Status TownSource::placeCameras(const CameraRoute& flown) {
  const Parameters& p = parameters_;
  const auto turn = [](double degrees, const Eigen::Vector3d& axis) {
    return Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis);
  };
  const Eigen::Isometry3d T_route_camera(turn(p.camera_pitch, Eigen::Vector3d::UnitX()) *
                                         turn(p.camera_roll, Eigen::Vector3d::UnitZ()));
  const double ground = route_.T_town_camera.front().translation().z() - p.camera_height;
  T_town_camera_.clear();
  for (std::size_t i = 0; i < flown.T_town_camera.size(); ++i) {
    T_town_camera_.push_back(flown.T_town_camera[i] * T_route_camera);
    const double height = T_town_camera_[i].translation().z() - ground;
    if (p.flight && height < 0.3) {
      return Status::invalidInput(p.route + ": pose " + std::to_string(i) + " is " +
                                  std::to_string(height) +
                                  " m above the ground; give a larger camera_height");
    }
  }
  return Status::ok();
}

void TownSource::buildScene() {
  const Parameters& p = parameters_;
  const auto seed = static_cast<std::uint32_t>(p.seed);
  WorldOptions options = {seed, p.aliasing, p.density, p.guard_rails, {}};
  const Building building = route_.building;
  if (building == Building::CarPark) options.reserved.push_back(carParkPlot());
  if (building == Building::Hall) options.reserved.push_back(hallPlot());
  World world = buildWorld(*plan_, options);
  if (building == Building::CarPark) {
    addCarPark(world, -p.camera_height, hash(seed, 311));
  } else if (building == Building::Hall) {
    addHall(world, -p.camera_height, hash(seed, 312));
  } else {
    addBridges(world, *plan_);
  }
  trees_ = schedule_.anyBare() ? addBareTrees(world) : Exchange{};
  cars_ = schedule_.anyExchanged() ? addOtherCars(world, hash(seed, 304)) : Exchange{};
  moving_ = std::make_unique<MovingThings>(p, route_, *plan_, world);
  scene_ = std::make_unique<Scene>(std::move(world));
  shown_ = {};
  for (const Exchange* exchange : {&trees_, &cars_}) {
    for (const std::size_t hidden : exchange->other) scene_->show(hidden, false);
  }
  if (!trees_.other.empty() || !cars_.other.empty()) scene_->commit();
  renderers_.assign(2, Renderer(*scene_, *plan_, Light{}, static_cast<int>(p.edge_samples)));
}

void TownSource::chooseFrames() {
  arriving_.clear();
  for (std::int64_t k = 0; k < sequence_.size(); ++k) {
    const bool lost = k > 0 && unit(hash(run_seed_, static_cast<std::uint32_t>(k), 401)) <
                                   static_cast<float>(parameters_.dropped);
    if (!lost) arriving_.push_back(k);
  }
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

MovingThings::Instant TownSource::instantAt(std::size_t index, double part) const {
  return {secondsAt(index) + part * intervalAt(index), poseAt(route_.T_town_camera, index, part)};
}

void TownSource::arrangeScene(std::size_t index) {
  const Condition& now = schedule_.at(index);
  const auto exchange = [&](const Exchange& both, bool other) {
    for (const std::size_t i : both.usual) scene_->show(i, !other);
    for (const std::size_t i : both.other) scene_->show(i, other);
  };
  const bool is_changed = now.bare != shown_.bare || now.exchanged != shown_.exchanged;
  if (now.bare != shown_.bare) exchange(trees_, now.bare);
  if (now.exchanged != shown_.exchanged) exchange(cars_, now.exchanged);
  shown_ = now;
  const bool moves = moving_->arrange(*scene_, instantAt(index, 0));
  if (is_changed || moves) scene_->commit();
}

void TownSource::setLight(std::size_t index) {
  light_ = schedule_.lightAt(index);
  if (light_.sun > 0) scene_->setSun(light_.to_sun);
  const Eigen::Isometry3d& T_town_left = route_.T_town_camera[index];
  // The lamps of the camera's car: below and ahead of it, one in the middle for both.
  const Eigen::Vector3d from = T_town_left * Eigen::Vector3d(0, 0.95, 1.6);
  const Eigen::Vector3d ahead = T_town_left.linear().col(2);
  const auto toVec3 = [](const Eigen::Vector3d& v) {
    return Vec3{static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
  };
  light_.headlights = {toVec3(from), toVec3(ahead)};
  moving_->addHeadlights(light_, T_town_left);
  light_.glass = static_cast<float>(parameters_.glass);
  light_.puddles = static_cast<float>(parameters_.puddles);
  light_.wind = static_cast<float>(parameters_.wind);
  light_.seconds = static_cast<float>(secondsAt(index));
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

Image TownSource::takePicture(std::size_t index, bool right) {
  const std::size_t camera = right ? 1 : 0;
  Moment moment;
  moment.T_town_left = [this, index](double part) { return poseAt(T_town_camera_, index, part); };
  moment.follow = [this, index](double begin, double end, OpenShutter& shutter) {
    moving_->follow(instantAt(index, begin), instantAt(index, end), shutter);
  };
  moment.interval_s = intervalAt(index);
  moment.seconds = secondsAt(index);
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
      static_cast<float>(parameters_.corrupt)) {
    frame.defect = "town: corrupt image, as the parameter corrupt demands";
  } else {
    arrangeScene(index);
    setLight(index);
    const auto left = [&] { frame.left = takePicture(index, false); };
    const auto right = [&] {
      if (rig_.isStereo()) frame.right = takePicture(index, true);
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
  ArrayInfo depth;
  depth.name = "depth.left";
  depth.kind = ArrayKind::DepthImage;
  depth.unit = "m";
  depth.doc = "true depth of the left image along the optical axis; 0 for the sky";
  depth.axes.resize(2);
  depth.axes[0].name = "row";
  depth.axes[1].name = "column";
  arrays.push_back(std::move(depth));
  return Status::ok();
}

Status TownSource::inspect(std::vector<Finding>& findings) {
  const auto note = [&](Finding::Severity severity, const std::string& message) {
    findings.push_back({severity, parameters_.route, message});
  };
  if (!ready_.isOk()) {
    note(Finding::Severity::Error, std::string(ready_.message()));
    return Status::ok();
  }
  double length = 0;
  for (std::size_t i = 1; i < T_town_camera_.size(); ++i) {
    length += (T_town_camera_[i].translation() - T_town_camera_[i - 1].translation()).norm();
  }
  double streets = 0;
  for (const StreetSection& section : plan_->sections()) streets += section.points.back().s;
  const auto metres = [](double m) { return std::to_string(std::lround(m)) + " m"; };
  note(Finding::Severity::Note, std::to_string(T_town_camera_.size()) + " poses over " +
                                    metres(length) + ", " + metres(streets) + " of streets in " +
                                    std::to_string(plan_->sections().size()) + " sections");
  if (is_levelled_) {
    note(Finding::Severity::Note,
         "passes crossed at different heights; the poses were levelled (crossings: level)");
  }
  if (route_.building == Building::None && !plan_->decks().empty()) {
    note(Finding::Severity::Note, std::to_string(plan_->decks().size()) + " bridges");
  }
  note(Finding::Severity::Note, std::to_string(scene_->triangles()) + " triangles and " +
                                    std::to_string(scene_->instances()) +
                                    " trees, bushes and cars");
  return Status::ok();
}

}  // namespace tolman::town
