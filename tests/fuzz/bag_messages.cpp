// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: one message of ROS 1 or 2, decoded as each of the supported types, and its image and
// calibration.
#include <string>

#include "camera_calibration.hpp"
#include "image_conversion.hpp"
#include "input.hpp"
#include "messages.hpp"

namespace {

using namespace tolman;
using ros_messages::Bytes;
using ros_messages::Message;

void tryImage(std::string_view type, const Message& message) {
  // Larger ones are allowed, and take as much time and memory as their size: nothing to find here.
  constexpr std::int64_t kMaxPixels = 1 << 18;
  const auto size = ros_messages::imageSize(std::string(type), message);
  if (!size.isOk() || std::int64_t{size.value().width} * size.value().height > kMaxPixels) return;
  for (const bool colour : {false, true}) {
    const auto image = ros_messages::convertImage(std::string(type), message, colour);
    if (!image.isOk()) continue;
    fuzz::require(image.value().width() == size.value().width &&
                      image.value().height() == size.value().height,
                  "an image of another size than its message says");
    unsigned sum = 0;  // every pixel is there
    const int row = image.value().width() * bytesPerPixel(image.value().format());
    for (int y = 0; y < image.value().height(); ++y) {
      for (int x = 0; x < row; ++x) sum += image.value().row(y)[x];
    }
    fuzz::require(sum <= 255U * static_cast<unsigned>(row * image.value().height()), "impossible");
  }
  ros_messages::ImageSize depth_size;
  const auto depth = ros_messages::convertDepth(std::string(type), message, depth_size);
  if (!depth.isOk()) return;
  for (const float metres : depth.value()) fuzz::require(metres >= 0, "a depth that is none");
}

void tryCalibration(const ros_messages::CameraInfoMessage& info) {
  for (const bool pair : {false, true}) {
    ros_messages::CameraInfos infos{info, std::nullopt};
    if (pair) infos.right = info;
    const int width = static_cast<int>(info.width % 5000);
    const int height = static_cast<int>(info.height % 5000);
    (void)ros_messages::isRectified("/image", infos);
    const auto rig = ros_messages::rectifiedRig(infos, width, height);
    if (rig.isOk()) {
      fuzz::require(rig.value().pinhole.fx > 0 && rig.value().baseline >= 0, "a rig that is none");
    }
    const auto raw = ros_messages::rawRig(infos, width, height);
    if (raw.isOk()) fuzz::require(raw.value().cameras.size() == (pair ? 2U : 1U), "lost a camera");
  }
}

void tryMessage(const Message& message) {
  (void)ros_messages::headerStamp(message);
  (void)ros_messages::readImu(message);
  (void)ros_messages::readOdometry(message);
  tryImage(ros_messages::kImage, message);
  tryImage(ros_messages::kCompressedImage, message);
  if (const auto info = ros_messages::readCameraInfo(message)) tryCalibration(*info);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const auto encoding : {ros_messages::Encoding::Cdr, ros_messages::Encoding::Ros1}) {
    tryMessage({Bytes(data, size), encoding});
  }
  return 0;
}
