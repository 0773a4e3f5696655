// SPDX-License-Identifier: BSD-3-Clause
#include "side_measurements.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::ros_bag {
namespace {

float f(double value) { return static_cast<float>(value); }

}  // namespace

Status SideMeasurements::load(Bag& bag, const BagTopic* imu, const BagTopic* odometry) {
  has_imu_ = imu != nullptr;
  imu_.clear();
  poses_.clear();
  damaged_ = 0;
  first_damaged_.clear();
  coverage_ = {};
  speeds_ = {};
  restart_ = {};
  tells_lost_ = false;
  if (imu != nullptr) {
    for (const BagMessage& message : imu->index) {
      const auto bytes = bag.read(message);
      if (!bytes.isOk()) return bytes.status();
      auto measured = readImu(imu->message(bytes.value()));
      if (!measured) {
        tellDamaged(*imu, message);
        continue;
      }
      measured->stamp_ns = message.stamp_ns;
      imu_.push_back(*measured);
    }
  }
  if (odometry == nullptr) return Status::ok();
  for (const BagMessage& message : odometry->index) {
    const auto bytes = bag.read(message);
    if (!bytes.isOk()) return bytes.status();
    const auto measured = readOdometry(odometry->message(bytes.value()));
    if (!measured) {
      tellDamaged(*odometry, message);
      continue;
    }
    speeds_.add(message.stamp_ns, *measured);
    restart_.add(message.stamp_ns, measured->position);
    poses_.push_back(
        {message.stamp_ns,
         {measured->position[0], measured->position[1], headingOf(measured->orientation)}});
  }
  std::vector<std::int64_t> stamps;
  for (const Pose& pose : poses_) stamps.push_back(pose.stamp_ns);
  coverage_ = OdometryCoverage(std::move(stamps));
  return Status::ok();
}

Status SideMeasurements::judgeOdometry(const std::vector<std::int64_t>& frames_ns,
                                       std::vector<std::string>& problems) {
  if (poses_.empty() || frames_ns.size() < 2) return Status::ok();
  if (!coverage_.overlaps(frames_ns)) {
    poses_.clear();
    return Status::invalidInput("no motion between the images is measured: " +
                                coverage_.ranges(frames_ns) + "; check the clocks of both");
  }
  const std::vector<std::string> found = coverage_.problems(frames_ns);
  tells_lost_ = !found.empty();
  problems.insert(problems.end(), found.begin(), found.end());
  // A path that jumps back contradicts the velocities as well: its cause is told alone.
  std::string doubt = restart_.doubt();
  if (doubt.empty()) doubt = speeds_.doubt();
  if (!doubt.empty()) problems.push_back(std::move(doubt));
  return Status::ok();
}

void SideMeasurements::tellDamaged(const BagTopic& topic, const BagMessage& message) {
  if (++damaged_ > 1) return;
  first_damaged_ = "of " + topic.topic.name + " with the stamp " +
                   std::to_string(message.stamp_ns) + " ns (message " +
                   std::to_string(message.number) + ")";
}

PlanarPose SideMeasurements::poseAt(std::int64_t stamp_ns) const {
  const auto after =
      std::upper_bound(poses_.begin(), poses_.end(), stamp_ns,
                       [](std::int64_t stamp, const Pose& pose) { return stamp < pose.stamp_ns; });
  if (after == poses_.begin()) return poses_.front().pose;
  const Pose& before = *(after - 1);
  if (after == poses_.end()) return before.pose;
  const double part = static_cast<double>(stamp_ns - before.stamp_ns) /
                      static_cast<double>(after->stamp_ns - before.stamp_ns);
  PlanarPose pose = before.pose;
  pose.x += part * (after->pose.x - before.pose.x);
  pose.y += part * (after->pose.y - before.pose.y);
  pose.theta += part * std::remainder(after->pose.theta - before.pose.theta, 2 * M_PI);
  return pose;
}

void SideMeasurements::measureImu(std::int64_t begin_ns, std::int64_t end_ns,
                                  std::vector<NamedArray>& sensors) const {
  std::array<double, 6> sums{};
  std::size_t samples = 0;
  const auto begin = std::upper_bound(
      imu_.begin(), imu_.end(), begin_ns,
      [](std::int64_t stamp, const ImuMessage& imu) { return stamp < imu.stamp_ns; });
  for (auto imu = begin; imu != imu_.end() && imu->stamp_ns <= end_ns; ++imu, ++samples) {
    for (std::size_t i = 0; i < 3; ++i) {
      sums[i] += imu->angular_velocity[i];
      sums[i + 3] += imu->linear_acceleration[i];
    }
  }
  for (double& sum : sums) sum /= static_cast<double>(std::max<std::size_t>(samples, 1));
  sensors.push_back({"imu.angular_velocity", {3}, {f(sums[0]), f(sums[1]), f(sums[2])}});
  sensors.push_back({"imu.linear_acceleration", {3}, {f(sums[3]), f(sums[4]), f(sums[5])}});
  sensors.push_back({"imu.samples", {1}, {static_cast<float>(samples)}});
}

void SideMeasurements::measure(std::int64_t previous_ns, std::int64_t stamp_ns,
                               std::vector<NamedArray>& sensors) const {
  if (has_imu_) {
    measureImu(std::min(previous_ns, stamp_ns), std::max(previous_ns, stamp_ns), sensors);
  }
  if (poses_.empty()) return;
  const PlanarPose step = between(poseAt(previous_ns), poseAt(stamp_ns));
  sensors.push_back({"motion.planar", {3}, {f(step.x), f(step.y), f(step.theta)}});
  if (!tells_lost_) return;
  const bool lost = coverage_.kindOf(previous_ns, stamp_ns) != OdometryCoverage::Kind::Measured;
  sensors.push_back({"motion.lost", {1}, {lost && previous_ns != stamp_ns ? 1.0F : 0.0F}});
}

void SideMeasurements::describe(std::vector<ArrayInfo>& arrays) const {
  const auto add = [&arrays](const char* name, const char* unit, const char* doc,
                             std::vector<std::string> labels) {
    ArrayInfo& info = arrays.emplace_back();
    info.name = name;
    info.unit = unit;
    info.doc = doc;
    info.axes.emplace_back();
    info.axes.back().name = "component";
    info.axes.back().labels = std::move(labels);
  };
  if (has_imu_) {
    add("imu.angular_velocity", "rad/s", "mean since the frame before", {"x", "y", "z"});
    add("imu.linear_acceleration", "m/s^2", "mean since the frame before", {"x", "y", "z"});
    add("imu.samples", "", "measurements since the frame before", {"number"});
  }
  if (poses_.empty()) return;
  add("motion.planar", "", "planar motion since the frame before",
      {"x (m)", "y (m)", "theta (rad)"});
  if (tells_lost_) {
    add("motion.lost", "", "1 where motion.planar is not measured, but a guess", {"lost"});
  }
}

}  // namespace tolman::ros_bag
