// SPDX-License-Identifier: BSD-3-Clause
#include "true_poses.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace tolman::ros_bag {
namespace {

/// 2.5 usual steps, as for a truth of evaluation.truth.
std::int64_t longestGap(const std::vector<std::int64_t>& stamps_ns) {
  constexpr std::int64_t kLeast_ns = 100'000'000;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) {
    steps.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  }
  if (steps.empty()) return kLeast_ns;
  const auto median = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::ranges::nth_element(steps, median);
  return std::max(kLeast_ns, *median * 5 / 2);
}

Eigen::Isometry3d poseOf(const OdometryMessage& message) {
  const auto [x, y, z, w] = message.orientation;
  const auto& p = message.position;
  return Eigen::Translation3d(p[0], p[1], p[2]) * Eigen::Quaterniond(w, x, y, z).normalized();
}

}  // namespace

TruthName TruthName::of(const std::string& parameter) {
  TruthName name;
  std::istringstream(parameter) >> name.topic >> name.frame >> name.child_frame;
  return name;
}

Status TruePoses::load(Bag& bag, const BagTopic& topic, const TruthName& name,
                       std::pair<std::int64_t, std::int64_t> frames_ns,
                       FindingCollector& findings) {
  const bool of_many = isTransforms(topic.topic.type);
  std::map<std::int64_t, Eigen::Isometry3d> poses;
  std::set<std::string> others;
  for (const BagMessage& message : topic.index) {
    const auto bytes = bag.read(message);
    if (!bytes.isOk()) return bytes.status();
    const auto found = readPoses(topic.topic.type, topic.message(bytes.value()));
    if (!found) {
      findings.add({Finding::Severity::Error,
                    "message " + std::to_string(message.number) + " of " + topic.topic.name,
                    "is damaged", "record it again", Finding::Kind::Damaged});
      continue;
    }
    for (const OdometryMessage& pose : *found) {
      if (!of_many) {
        poses.emplace(message.stamp_ns, poseOf(pose));
      } else if (pose.frame == name.frame && pose.child_frame == name.child_frame) {
        poses.emplace(pose.stamp_ns, poseOf(pose));
      } else {
        others.insert(std::string(pose.frame) + " " + std::string(pose.child_frame));
      }
    }
  }
  if (poses.empty() && !of_many) {
    return Status::invalidInput(topic.topic.name +
                                ": has no message that can be used; record it again");
  }
  if (poses.empty()) {
    std::string listed;
    for (const std::string& other : others) listed += (listed.empty() ? "" : ", ") + other;
    return Status::invalidParameter("truth: " + topic.topic.name + " has no pose of '" +
                                    name.child_frame + "' in '" + name.frame +
                                    "'; name topic, frame and child frame, one of: " + listed);
  }
  for (const auto& [stamp_ns, pose] : poses) {
    poses_.stamps_ns.push_back(stamp_ns);
    poses_.T_world_camera.push_back(poses.begin()->second.inverse() * pose);
  }
  longest_gap_ns_ = longestGap(poses_.stamps_ns);
  if (poses_.stamps_ns.front() <= frames_ns.second && poses_.stamps_ns.back() >= frames_ns.first) {
    return Status::ok();
  }
  findings.add({Finding::Severity::Error, topic.topic.name,
                "has no true pose at the time of any image: its messages are from " +
                    secondsText(poses_.stamps_ns.front()) + " to " +
                    secondsText(poses_.stamps_ns.back()) + ", the images from " +
                    secondsText(frames_ns.first) + " to " + secondsText(frames_ns.second),
                "check the clocks of both", Finding::Kind::Contradiction});
  poses_ = {};
  return Status::ok();
}

std::optional<Eigen::Isometry3d> TruePoses::at(std::int64_t stamp_ns) const {
  return source_parameters::poseAt(poses_, stamp_ns, longest_gap_ns_, longest_gap_ns_);
}

}  // namespace tolman::ros_bag
