// SPDX-License-Identifier: BSD-3-Clause
#include "side_measurements.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::ros_messages {

namespace {

float f(double value) { return static_cast<float>(value); }

}  // namespace

bool SideMeasurements::addImu(const Message& message, std::int64_t stamp_ns) {
  auto measured = readImu(message);
  if (!measured) return false;
  measured->stamp_ns = stamp_ns;
  if (imu_.empty() || imu_.back().stamp_ns <= stamp_ns) imu_.push_back(*measured);
  return true;
}

bool SideMeasurements::addPose(const Message& message, std::int64_t stamp_ns) {
  const auto measured = readOdometry(message);
  if (!measured) return false;
  if (poses_.empty() || poses_.back().stamp_ns < stamp_ns) {
    poses_.push_back(
        {stamp_ns,
         {measured->position[0], measured->position[1], headingOf(measured->orientation)}});
  }
  return true;
}

void SideMeasurements::dropPoses() {
  has_odometry_ = false;
  poses_.clear();
}

void SideMeasurements::forgetBefore(std::int64_t stamp_ns) {
  std::erase_if(imu_, [&](const ImuMessage& imu) { return imu.stamp_ns <= stamp_ns; });
  const auto after = std::ranges::upper_bound(poses_, stamp_ns, {}, &Pose::stamp_ns);
  if (after - poses_.begin() > 1) poses_.erase(poses_.begin(), after - 1);
}

bool SideMeasurements::isMeasured(std::int64_t begin_ns, std::int64_t end_ns) const {
  constexpr std::int64_t kPause_ns =
      500'000'000;  // chosen, not tuned: a straight line bridges less
  if (poses_.empty()) return false;
  if (begin_ns < poses_.front().stamp_ns || end_ns > poses_.back().stamp_ns) return false;
  auto next = std::ranges::upper_bound(poses_, begin_ns, {}, &Pose::stamp_ns);
  for (; next != poses_.end() && (next - 1)->stamp_ns < end_ns; ++next) {
    if (next->stamp_ns - (next - 1)->stamp_ns > kPause_ns) return false;
  }
  return true;
}

PlanarPose SideMeasurements::poseAt(std::int64_t stamp_ns) const {
  if (poses_.empty()) return {};
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
  if (!has_odometry_) return;
  const PlanarPose step = between(poseAt(previous_ns), poseAt(stamp_ns));
  sensors.push_back({"motion.planar", {3}, {f(step.x), f(step.y), f(step.theta)}});
  const auto [begin_ns, end_ns] = std::minmax(previous_ns, stamp_ns);
  const bool lost = begin_ns != end_ns && !isMeasured(begin_ns, end_ns);
  sensors.push_back({"motion.lost", {1}, {lost ? 1.0F : 0.0F}});
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
  if (!has_odometry_) return;
  add("motion.planar", "", "planar motion since the frame before",
      {"x (m)", "y (m)", "theta (rad)"});
  add("motion.lost", "", "1 where motion.planar is not measured, but a guess", {"lost"});
}

}  // namespace tolman::ros_messages
