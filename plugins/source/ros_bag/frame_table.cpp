// SPDX-License-Identifier: BSD-3-Clause
#include "frame_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace tolman::ros_bag {

std::string secondsText(std::int64_t ns) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", static_cast<double>(ns) * 1e-9);
  return text.data();
}

Result<SideMeasurements> loadMeasurements(Bag& bag, const BagTopic* imu, const BagTopic* odometry,
                                          std::pair<std::int64_t, std::int64_t> frames_ns,
                                          FindingCollector& findings) {
  SideMeasurements side(imu != nullptr, odometry != nullptr);
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
  Status status = visit(imu, [&](const Message& message, std::int64_t stamp_ns) {
    return side.addImu(message, stamp_ns);
  });
  if (!status.isOk()) return status;
  status = visit(odometry, [&](const Message& message, std::int64_t stamp_ns) {
    return side.addPose(message, stamp_ns);
  });
  if (!status.isOk()) return status;
  const bool apart = side.hasPoses() &&
                     (side.firstPoseNs() > frames_ns.second || side.lastPoseNs() < frames_ns.first);
  if (apart) {
    findings.add({Finding::Severity::Error, odometry->topic.name,
                  "measures no motion between the images: its messages are from " +
                      secondsText(side.firstPoseNs()) + " to " + secondsText(side.lastPoseNs()) +
                      ", the images from " + secondsText(frames_ns.first) + " to " +
                      secondsText(frames_ns.second),
                  "check the clocks of both", Finding::Kind::Contradiction});
  }
  if (apart || !side.hasPoses()) side.dropPoses();
  return side;
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
