// SPDX-License-Identifier: BSD-3-Clause
#include "topic_choice.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "camera_rigs.hpp"
#include "image_conversion.hpp"
#include "messages.hpp"

namespace tolman::ros_bag {
namespace {

using Topics = std::map<std::string, BagTopic>;
using Types = std::span<const std::string_view>;

Types one(const std::string_view& type) { return {&type, 1}; }

bool isOf(const BagTopic& topic, Types types) {
  // A topic of damaged messages alone is chosen, too: the source then reports what is wrong.
  return (!topic.index.empty() || !topic.findings.empty()) &&
         std::find(types.begin(), types.end(), topic.topic.type) != types.end();
}

bool isOfRos(const BagTopic& topic) {
  return topic.topic.encoding == kCdrEncoding || topic.topic.encoding == kRos1Encoding;
}

std::string listed(const std::vector<const BagTopic*>& topics) {
  std::string text;
  for (const BagTopic* topic : topics) text += (text.empty() ? "" : ", ") + topic->topic.name;
  return text.empty() ? "none" : text;
}

std::vector<const BagTopic*> topicsOf(const Topics& topics, Types types) {
  std::vector<const BagTopic*> found;
  for (const auto& [name, topic] : topics) {
    if (isOf(topic, types)) found.push_back(&topic);
  }
  return found;
}

/// The topic that a parameter names.
Result<const BagTopic*> named(const Topics& topics, const char* parameter, const std::string& name,
                              Types types) {
  const auto topic = topics.find(name);
  if (topic != topics.end() && isOf(topic->second, types)) return &topic->second;
  std::string what = "the bag has no topic " + name;
  if (topic != topics.end()) {
    what = isOfRos(topic->second)
               ? "topic " + name + " is of type " + topic->second.topic.type
               : "messages of topic " + name + " are encoded as '" + topic->second.topic.encoding +
                     "', not as those of ROS 2 (cdr) or 1 (ros1)";
  }
  return Status::invalidParameter(what + "; set " + parameter +
                                  " to one of: " + listed(topicsOf(topics, types)));
}

/// By the encoding of its first image, whatever the name of the topic.
bool isDepth(const BagTopic& topic) {
  return !topic.first.empty() && ros_messages::isDepth(topic.topic.type, topic.firstMessage());
}

/// Topics of cameras. If the same images are there raw and compressed, only the raw topic.
std::vector<const BagTopic*> cameraTopics(const Topics& topics) {
  std::vector<const BagTopic*> found;
  for (const BagTopic* topic : topicsOf(topics, kImageTypes)) {
    const std::string& name = topic->topic.name;
    const auto plain = topics.find(untransported(name));
    const bool repeated =
        plain != topics.end() && &plain->second != topic && plain->second.isOf(kImage);
    if (!repeated && !isDepth(*topic)) found.push_back(topic);
  }
  return found;
}

Status chooseCameras(const Topics& topics, const BagParameters& p, ChosenTopics& chosen) {
  const auto choose = [&](const char* parameter, const std::string& name, const BagTopic*& topic) {
    if (name.empty()) return Status::ok();
    const auto found = named(topics, parameter, name, kImageTypes);
    if (found.isOk()) topic = found.value();
    return found.status();
  };
  if (Status status = choose("left", p.left, chosen.left); !status.isOk()) return status;
  if (Status status = choose("right", p.right, chosen.right); !status.isOk()) return status;
  const std::vector<const BagTopic*> cameras = cameraTopics(topics);
  if (cameras.empty() && chosen.left == nullptr) {
    const std::vector<const BagTopic*> depth = topicsOf(topics, kImageTypes);
    return Status::invalidInput(
        depth.empty() ? "the bag has no images; `tolman dataset check` lists its topics"
                      : "the bag has images of depth only (" + listed(depth) +
                            "); record those of a camera as well, or in an encoding such as mono8 "
                            "or mono16");
  }
  std::vector<std::string> names;
  names.reserve(cameras.size());
  for (const BagTopic* camera : cameras) names.push_back(camera->topic.name);
  const CameraNames given{p.left, p.right};
  const auto found = chooseCameraNames(names, given, p.mono);
  if (!found) {
    return Status::invalidParameter(std::string("the bag has several cameras; set ") +
                                    chooseBy(given) + " to one of: " + listed(cameras));
  }
  chosen.left = &topics.at(found->left);
  chosen.right = found->right.empty() ? nullptr : &topics.at(found->right);
  return Status::ok();
}

/// The topic of CameraInfo for images: /left/camera_info for /left/image_raw.
const BagTopic* besides(const Topics& topics, const BagTopic& camera) {
  const auto topic = topics.find(infoBeside(camera.topic.name));
  if (topic != topics.end() && isOf(topic->second, one(kCameraInfo))) return &topic->second;
  return nullptr;
}

Status chooseInfo(const Topics& topics, const char* parameter, const std::string& name,
                  const BagTopic* camera, const BagTopic*& info) {
  if (camera == nullptr) return Status::ok();
  if (name.empty()) {
    info = besides(topics, *camera);
    return Status::ok();
  }
  const auto found = named(topics, parameter, name, one(kCameraInfo));
  if (found.isOk()) info = found.value();
  return found.status();
}

/// The topic of a sensor: the named one, or the only one of its type beside the truth.
Status chooseSensor(const Topics& topics, const char* parameter, const std::string& name,
                    std::string_view type, const BagTopic* truth, const BagTopic*& sensor,
                    std::vector<Finding>& undecided) {
  if (!name.empty()) {
    const auto found = named(topics, parameter, name, one(type));
    if (found.isOk()) sensor = found.value();
    return found.status();
  }
  std::vector<const BagTopic*> all = topicsOf(topics, one(type));
  std::erase(all, truth);
  if (all.size() == 1) sensor = all.front();
  if (all.size() > 1) {
    undecided.push_back({Finding::Severity::Warning, listed(all),
                         "are topics of one type, so none of them is used",
                         "set " + std::string(parameter) + " to one of them"});
  }
  return Status::ok();
}

}  // namespace

Result<ChosenTopics> chooseTopics(const Topics& topics, const BagParameters& p) {
  ChosenTopics chosen;
  Status status = chooseCameras(topics, p, chosen);
  const auto then = [&status](Status next) {
    if (status.isOk()) status = std::move(next);
  };
  then(chooseInfo(topics, "left_info", p.left_info, chosen.left, chosen.left_info));
  then(chooseInfo(topics, "right_info", p.right_info, chosen.right, chosen.right_info));
  if (status.isOk() && !p.depth.empty()) {
    const auto depth = named(topics, "depth", p.depth, kImageTypes);
    if (depth.isOk()) chosen.depth = depth.value();
    then(depth.status());
  }
  if (status.isOk() && !p.truth.empty()) {
    const auto truth = named(topics, "truth", TruthName::of(p.truth).topic, kPoseTypes);
    if (truth.isOk()) chosen.truth = truth.value();
    then(truth.status());
  }
  const auto sensor = [&](const char* parameter, const std::string& name, std::string_view type,
                          const BagTopic*& topic) {
    then(chooseSensor(topics, parameter, name, type, chosen.truth, topic, chosen.undecided));
  };
  sensor("imu", p.imu, kImu, chosen.imu);
  sensor("odometry", p.odometry, kOdometry, chosen.odometry);
  if (!status.isOk()) return status;
  return chosen;
}

}  // namespace tolman::ros_bag
