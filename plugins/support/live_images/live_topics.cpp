// SPDX-License-Identifier: BSD-3-Clause
#include "live_topics.hpp"

#include <algorithm>
#include <vector>

#include "camera_rigs.hpp"
#include "messages.hpp"

namespace tolman::live_images {
namespace {

using Published = std::map<std::string, std::string>;

bool hasImages(const std::string& type) {
  return ros2Type(type) == ros_messages::kImage || ros2Type(type) == ros_messages::kCompressedImage;
}

/// Topics of cameras. If the same images are published raw and compressed, only the raw topic.
std::vector<std::string> cameraTopics(const Published& published) {
  std::vector<std::string> found;
  for (const auto& [name, type] : published) {
    const auto plain = published.find(name.substr(0, name.rfind('/')));
    const bool repeated = name.ends_with("/compressed") && plain != published.end();
    if (hasImages(type) && !repeated && !name.ends_with("compressedDepth")) found.push_back(name);
  }
  return found;
}

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
  return text.empty() ? "none" : text;
}

/// `type`: of the messages; empty for those of images.
Status checkNamed(const Published& published, const std::string& name, std::string_view type = "") {
  const bool images = type.empty();
  const auto topic = published.find(name);
  if (topic == published.end()) {
    const std::string others = images ? "; topics with images are: " : "";
    return Status::invalidInput("nobody publishes " + name + others +
                                (images ? listed(cameraTopics(published))
                                        : "; start the camera's node, or name another topic"));
  }
  const bool fits = images ? hasImages(topic->second) : ros2Type(topic->second) == type;
  if (fits) return Status::ok();
  return Status::invalidParameter("topic " + name + " is of type " + topic->second +
                                  "; name another one");
}

Status chooseCameras(const Published& published, const LiveParameters& p,
                     const std::string& command, LiveTopics& chosen) {
  std::vector<std::string> cameras = cameraTopics(published);
  std::erase(cameras, p.depth);
  if (p.left.empty() && cameras.empty()) {
    return Status::invalidInput("nobody publishes images; start the camera's node (`" + command +
                                " list` shows the topics)");
  }
  const ros_messages::CameraNames given{p.left, p.right};
  const auto found = ros_messages::chooseCameraNames(cameras, given, p.mono);
  if (!found) {
    return Status::invalidParameter(std::string("there are several cameras; set ") +
                                    ros_messages::chooseBy(given) +
                                    " to one of: " + listed(cameras));
  }
  chosen.left = found->left;
  chosen.right = found->right;
  return Status::ok();
}

Status chooseInfos(const Published& published, const LiveParameters& p, LiveTopics& chosen) {
  if (p.isGiven()) return Status::ok();
  for (const bool right : {false, true}) {
    const std::string& camera = right ? chosen.right : chosen.left;
    const std::string& given = right ? p.right_info : p.left_info;
    std::string& info = right ? chosen.right_info : chosen.left_info;
    if (camera.empty()) continue;
    const std::string beside = ros_messages::infoBeside(camera);
    info = !given.empty() ? given : published.contains(beside) ? beside : "";
    if (info.empty()) continue;
    if (Status status = checkNamed(published, info, ros_messages::kCameraInfo); !status.isOk()) {
      return status;
    }
  }
  const bool pair = !chosen.right.empty();
  if (!pair || (!chosen.left_info.empty() && !chosen.right_info.empty())) return Status::ok();
  return Status::invalidInput(
      "nobody publishes a CameraInfo beside " + chosen.left + " and " + chosen.right +
      "; set left_info and right_info, give pinhole and baseline, or set mono: true");
}

}  // namespace

std::string ros2Type(const std::string& type) {
  const auto slash = type.find('/');
  const bool is_whole = slash == std::string::npos || slash != type.rfind('/');
  return is_whole ? type : std::string(type).insert(slash, "/msg");
}

Result<LiveTopics> chooseLiveTopics(const Published& published, const LiveParameters& p,
                                    const std::string& command) {
  LiveTopics chosen;
  chosen.depth = p.depth;
  chosen.imu = p.imu;
  chosen.odometry = p.odometry;
  Status status = chooseCameras(published, p, command, chosen);
  const auto check = [&](const std::string& name, std::string_view type = "") {
    if (status.isOk() && !name.empty()) status = checkNamed(published, name, type);
  };
  check(chosen.left);
  check(chosen.right);
  check(chosen.depth);
  check(chosen.imu, ros_messages::kImu);
  check(chosen.odometry, ros_messages::kOdometry);
  if (status.isOk()) status = chooseInfos(published, p, chosen);
  if (!status.isOk()) return status;
  return chosen;
}

}  // namespace tolman::live_images
