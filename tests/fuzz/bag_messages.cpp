// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: one message of a bag, taken for each of the types that are read, and its image and
// calibration.
#include <string>

#include "camera_calibration.hpp"
#include "image_conversion.hpp"
#include "input.hpp"
#include "messages.hpp"

namespace {

using namespace tolman;
using ros_bag::Bytes;

void tryImage(std::string_view type, Bytes message) {
  // Larger ones are allowed, and take as much time and memory as their size: nothing to find here.
  constexpr std::int64_t kMostPixels = 1 << 18;
  const auto size = ros_bag::imageSize(std::string(type), message);
  if (!size.isOk() || std::int64_t{size.value().width} * size.value().height > kMostPixels) return;
  for (const bool colour : {false, true}) {
    const auto image = ros_bag::convertImage(std::string(type), message, colour);
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
  ros_bag::ImageSize depth_size;
  const auto depth = ros_bag::convertDepth(message, depth_size);
  if (!depth.isOk()) return;
  for (const float metres : depth.value()) fuzz::require(metres >= 0, "a depth that is none");
}

void tryCalibration(const ros_bag::CameraInfoMessage& info) {
  for (const bool pair : {false, true}) {
    ros_bag::CameraInfos infos{info, std::nullopt};
    if (pair) infos.right = info;
    const int width = static_cast<int>(info.width % 5000);
    const int height = static_cast<int>(info.height % 5000);
    (void)ros_bag::isRectified("/image", infos);
    const auto rig = ros_bag::rectifiedRig(infos, width, height);
    if (rig.isOk()) {
      fuzz::require(rig.value().pinhole.fx > 0 && rig.value().baseline >= 0, "a rig that is none");
    }
    const auto raw = ros_bag::rawRig(infos, width, height);
    if (raw.isOk()) fuzz::require(raw.value().cameras.size() == (pair ? 2U : 1U), "lost a camera");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Bytes message(data, size);
  (void)ros_bag::headerStamp(message);
  (void)ros_bag::readImu(message);
  (void)ros_bag::readOdometry(message);
  tryImage(ros_bag::kImage, message);
  tryImage(ros_bag::kCompressedImage, message);
  if (const auto info = ros_bag::readCameraInfo(message)) tryCalibration(*info);
  return 0;
}
