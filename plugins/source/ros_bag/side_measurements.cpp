// SPDX-License-Identifier: BSD-3-Clause
#include "side_measurements.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace tolman::ros_bag {

namespace {

float f(double value) { return static_cast<float>(value); }

}  // namespace

std::string secondsText(std::int64_t ns) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", static_cast<double>(ns) * 1e-9);
  return text.data();
}

Status SideMeasurements::load(Bag& bag, const BagTopic* imu, const BagTopic* odometry,
                              std::pair<std::int64_t, std::int64_t> frames_ns,
                              FindingCollector& findings) {
  has_imu_ = imu != nullptr;
  imu_.clear();
  poses_.clear();
  const auto visit = [&](const BagTopic* topic, const auto& take) {
    if (topic == nullptr) return Status::ok();
    for (const BagMessage& message : topic->index) {
      const auto bytes = bag.read(message);
      if (!bytes.isOk()) return bytes.status();
      if (take(topic->message(bytes.value()), message.stamp_ns)) continue;
      findings.add({Finding::Severity::Error,
                    "message " + std::to_string(message.number) + " of " + topic->topic.name,
                    "is damaged", "record it again", Finding::Kind::Damaged});
    }
    return Status::ok();
  };
  Status status = visit(imu, [this](const Message& message, std::int64_t stamp_ns) {
    auto measured = readImu(message);
    if (!measured) return false;
    measured->stamp_ns = stamp_ns;
    imu_.push_back(*measured);
    return true;
  });
  if (!status.isOk()) return status;
  status = visit(odometry, [this](const Message& message, std::int64_t stamp_ns) {
    const auto measured = readOdometry(message);
    if (!measured) return false;
    poses_.push_back(
        {stamp_ns,
         {measured->position[0], measured->position[1], headingOf(measured->orientation)}});
    return true;
  });
  const bool apart = !poses_.empty() && (poses_.front().stamp_ns > frames_ns.second ||
                                         poses_.back().stamp_ns < frames_ns.first);
  if (!apart) return status;
  findings.add({Finding::Severity::Error, odometry->topic.name,
                "measures no motion between the images: its messages are from " +
                    secondsText(poses_.front().stamp_ns) + " to " +
                    secondsText(poses_.back().stamp_ns) + ", the images from " +
                    secondsText(frames_ns.first) + " to " + secondsText(frames_ns.second),
                "check the clocks of both", Finding::Kind::Contradiction});
  poses_.clear();
  return status;
}

bool SideMeasurements::isMeasured(std::int64_t begin_ns, std::int64_t end_ns) const {
  constexpr std::int64_t kPause_ns =
      500'000'000;  // chosen, not tuned: a straight line bridges less
  if (begin_ns < poses_.front().stamp_ns || end_ns > poses_.back().stamp_ns) return false;
  auto next = std::ranges::upper_bound(poses_, begin_ns, {}, &Pose::stamp_ns);
  for (; next != poses_.end() && (next - 1)->stamp_ns < end_ns; ++next) {
    if (next->stamp_ns - (next - 1)->stamp_ns > kPause_ns) return false;
  }
  return true;
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
  if (poses_.empty()) return;
  add("motion.planar", "", "planar motion since the frame before",
      {"x (m)", "y (m)", "theta (rad)"});
  add("motion.lost", "", "1 where motion.planar is not measured, but a guess", {"lost"});
}

namespace {

std::int64_t distance(const BagMessage& a, const BagMessage& b) {
  return std::abs(a.stamp_ns - b.stamp_ns);
}

std::int64_t smallestDistance(const std::vector<BagMessage>& left,
                              const std::vector<BagMessage>& right) {
  std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
  std::size_t r = 0;
  for (const BagMessage& message : left) {
    while (r + 1 < right.size() && distance(message, right[r + 1]) <= distance(message, right[r])) {
      ++r;
    }
    smallest = std::min(smallest, distance(message, right[r]));
  }
  return smallest;
}

/// `others` is never beside `left`. `remedy`: beside setting the tolerance.
Status neverBeside(const BagTopic& left, const BagTopic& others, const char* remedy) {
  const double apart_s = static_cast<double>(smallestDistance(left.index, others.index)) * 1e-9;
  return Status::invalidInput("no image of " + others.topic.name + " has the stamp of one of " +
                              left.topic.name + ": the nearest are " + std::to_string(apart_s) +
                              " s apart; set tolerance, or " + remedy);
}

}  // namespace

std::vector<std::optional<std::size_t>> matchStamps(const std::vector<BagMessage>& left,
                                                    const std::vector<BagMessage>& others,
                                                    std::int64_t tolerance_ns) {
  std::vector<std::optional<std::size_t>> matches(left.size());
  std::size_t next = 0;
  for (std::size_t l = 0; l < left.size() && next < others.size(); ++l) {
    std::size_t best = next;
    while (best + 1 < others.size() &&
           distance(left[l], others[best + 1]) < distance(left[l], others[best])) {
      ++best;
    }
    if (distance(left[l], others[best]) > tolerance_ns) continue;
    const bool nearer_to_next = l + 1 < left.size() && distance(left[l + 1], others[best]) <
                                                           distance(left[l], others[best]);
    if (nearer_to_next) continue;
    matches[l] = best;
    next = best + 1;
  }
  return matches;
}

Result<FrameTable> makeFrameTable(const BagTopic& left, const BagTopic* right,
                                  const BagTopic* depth, std::int64_t tolerance_ns) {
  std::vector<std::optional<std::size_t>> pairs;
  std::vector<std::optional<std::size_t>> depths(left.index.size());
  if (right != nullptr) pairs = matchStamps(left.index, right->index, tolerance_ns);
  if (depth != nullptr) depths = matchStamps(left.index, depth->index, tolerance_ns);
  FrameTable table;
  for (std::size_t l = 0; l < left.index.size(); ++l) {
    if (right != nullptr && !pairs[l]) {
      ++table.left_alone;
      continue;
    }
    table.rows.push_back({l, right == nullptr ? 0 : *pairs[l], depths[l]});
    if (depth != nullptr && !depths[l]) ++table.without_depth;
  }
  if (right != nullptr) table.right_alone = right->index.size() - table.rows.size();
  if (table.rows.empty()) return neverBeside(left, *right, "mono: true");
  const bool is_depth_useless = depth != nullptr && table.without_depth == table.rows.size();
  if (is_depth_useless) return neverBeside(left, *depth, "leave out depth");
  return table;
}

}  // namespace tolman::ros_bag
