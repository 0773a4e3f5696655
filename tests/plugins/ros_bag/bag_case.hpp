// SPDX-License-Identifier: BSD-3-Clause
// Small bags for the tests of their source, and the source on them.
#pragma once

#include <string>
#include <vector>

#include "bag_source.hpp"
#include "support/context.hpp"
#include "support/data.hpp"
#include "support/ros_bag_writer.hpp"

namespace tolman::ros_bag {

inline Bytes asBytes(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

/// The stamp of image `index`, on the wall clock of 2025 as in real bags.
inline std::int64_t stampOf(int index) { return 1'749'315'324'903'302'144 + index * 50'000'000LL; }

/// A grey image of 8x6 px, all of the value 10 * index + 100 * camera.
inline test::RosMessage greyImage(const std::string& topic, int index, int camera = 0,
                                  std::int64_t later_ns = 0) {
  const std::int64_t stamp = stampOf(index) + later_ns;
  const std::string pixels(48, static_cast<char>(10 * index + 100 * camera));
  return {topic, std::string(kImage), stamp + 3'000'000,
          test::imageMessage({stamp, 8, 6, "mono8", pixels})};
}

inline test::RosMessage cameraInfo(const std::string& topic, const test::RosCamera& camera) {
  return {topic, std::string(kCameraInfo), stampOf(0), test::cameraInfoMessage(camera)};
}

/// A rectified pair of `count` images.
inline std::vector<test::RosMessage> pairMessages(int count, std::int64_t later_ns = 0) {
  std::vector<test::RosMessage> messages = {
      cameraInfo("/left/camera_info", test::plainCamera(8, 6, 7, 0)),
      cameraInfo("/right/camera_info", test::plainCamera(8, 6, 7, 0.12))};
  for (int i = 0; i < count; ++i) {
    messages.push_back(greyImage("/left/image_rect", i));
    messages.push_back(greyImage("/right/image_rect", i, 1, later_ns));
  }
  return messages;
}

/// A configured source and what it gave.
struct Played {
  explicit Played(const std::filesystem::path& path, ParameterValues values = {})
      : context(withPath(path, std::move(values))) {
    Status status = source.configure(context);
    if (status.isOk()) status = source.info(info);
    while (status.isOk()) {
      Frame frame;
      status = source.next(frame);
      if (status.isOk()) frames.push_back(frame);
    }
    if (status.code() != StatusCode::EndOfStream) message = status.message();
  }
  static ParameterValues withPath(const std::filesystem::path& path, ParameterValues values) {
    values["path"] = path.string();
    return values;
  }
  /// "error /left: has 3 messages without a time in their header", notes aside.
  std::vector<std::string> findings() const {
    std::vector<std::string> texts;
    for (const Finding& f : context.findings) {
      if (f.severity == Finding::Severity::Note) continue;
      texts.push_back(std::string(enumName(f.severity)) + " " + f.where + ": " + f.message);
    }
    return texts;
  }

  test::TestContext context;
  BagSource source;
  SourceInfo info;
  std::vector<Frame> frames;
  std::string message;  ///< of the failure; empty after the end
};

/// What a file of a bag gives.
struct ReadFile {
  explicit ReadFile(BagFile& file) {
    std::vector<MessagePlace> places;
    file.visit(
        [&](const Topic& topic, std::int64_t log_ns, const MessagePlace& place, Bytes message) {
          messages.push_back(topic.name + " " + topic.type + " " + std::to_string(log_ns) + " " +
                             std::string(asText(message)));
          places.push_back(place);
        },
        [&](const std::string& what) { damage.push_back(what); });
    for (auto place = places.rbegin(); place != places.rend(); ++place) {
      const auto message = file.read(*place);
      again.insert(again.begin(), message.isOk() ? std::string(asText(message.value()))
                                                 : message.status().message());
    }
  }
  std::vector<std::string> messages;
  std::vector<std::string> again;  ///< the bytes, read once more from the last to the first
  std::vector<std::string> damage;
};

}  // namespace tolman::ros_bag
