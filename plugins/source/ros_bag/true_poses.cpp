// SPDX-License-Identifier: BSD-3-Clause
#include "true_poses.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>

namespace tolman::ros_bag {
namespace {

using Poses = std::map<std::int64_t, Eigen::Isometry3d>;

/// 2.5 usual steps, as for a truth of evaluation.truth.
std::int64_t longestGap(const Poses& poses) {
  constexpr std::int64_t kLeast_ns = 100'000'000;
  std::vector<std::int64_t> steps;
  for (auto pose = poses.begin(); std::next(pose) != poses.end(); ++pose) {
    steps.push_back(std::next(pose)->first - pose->first);
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
  Poses poses;
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
  const auto [first_ns, last_ns] = std::pair(poses.begin()->first, poses.rbegin()->first);
  if (first_ns <= frames_ns.second && last_ns >= frames_ns.first) {
    const Eigen::Isometry3d from_first = poses.begin()->second.inverse();
    for (auto& [stamp_ns, pose] : poses) pose = from_first * pose;
    longest_gap_ns_ = longestGap(poses);
    poses_ = std::move(poses);
    return Status::ok();
  }
  findings.add({Finding::Severity::Error, topic.topic.name,
                "has no true pose at the time of any image: its messages are from " +
                    secondsText(first_ns) + " to " + secondsText(last_ns) + ", the images from " +
                    secondsText(frames_ns.first) + " to " + secondsText(frames_ns.second),
                "check the clocks of both", Finding::Kind::Contradiction});
  return Status::ok();
}

std::optional<Eigen::Isometry3d> TruePoses::at(std::int64_t stamp_ns) const {
  const auto after = poses_.lower_bound(stamp_ns);
  if (after == poses_.end()) return std::nullopt;
  if (after->first == stamp_ns) return after->second;
  if (after == poses_.begin()) return std::nullopt;
  const auto& [before_ns, a] = *std::prev(after);
  const auto& [after_ns, b] = *after;
  if (after_ns - before_ns > longest_gap_ns_) return std::nullopt;
  const double share =
      static_cast<double>(stamp_ns - before_ns) / static_cast<double>(after_ns - before_ns);
  return Eigen::Translation3d((1 - share) * a.translation() + share * b.translation()) *
         Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
}

}  // namespace tolman::ros_bag
