// SPDX-License-Identifier: BSD-3-Clause
// The messages of ROS that sources read, decoded. Views are of the message's bytes.
// Units are those of ROS: rad/s, m/s^2, m.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "field_reader.hpp"

namespace tolman::ros_messages {

inline constexpr std::string_view kImage = "sensor_msgs/msg/Image";
inline constexpr std::string_view kCompressedImage = "sensor_msgs/msg/CompressedImage";
/// One packet of a video: of image_transport's plugin for FFmpeg, and of Foxglove.
inline constexpr std::string_view kVideoPacket = "ffmpeg_image_transport_msgs/msg/FFMPEGPacket";
inline constexpr std::string_view kCompressedVideo = "foxglove_msgs/msg/CompressedVideo";
inline constexpr std::array kImageTypes = {kImage, kCompressedImage, kVideoPacket,
                                           kCompressedVideo};
inline bool isVideo(std::string_view type) {
  return type == kVideoPacket || type == kCompressedVideo;
}
inline constexpr std::string_view kCameraInfo = "sensor_msgs/msg/CameraInfo";
inline constexpr std::string_view kImu = "sensor_msgs/msg/Imu";
inline constexpr std::string_view kOdometry = "nav_msgs/msg/Odometry";
inline constexpr std::string_view kTransform = "geometry_msgs/msg/TransformStamped";
inline constexpr std::array<std::string_view, 6> kPoseTypes = {
    kOdometry,
    kTransform,
    "geometry_msgs/msg/PoseStamped",
    "geometry_msgs/msg/PoseWithCovarianceStamped",
    "tf2_msgs/msg/TFMessage",
    "tf/msg/tfMessage"};
inline bool isPoses(std::string_view type) {
  return std::ranges::find(kPoseTypes, type) != kPoseTypes.end();
}
/// Messages of tf, with any number of poses.
inline bool isTransforms(std::string_view type) { return isPoses(type) && type.starts_with("tf"); }

struct ImageMessage {
  std::int64_t stamp_ns = 0;
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string_view encoding;  ///< "mono8", "bgr8", "16UC1", ...
  bool big_endian = false;
  std::uint32_t step = 0;  ///< bytes from row to row
  Bytes data;
};

struct CompressedImageMessage {
  std::int64_t stamp_ns = 0;
  std::string_view format;
  Bytes data;
};

struct VideoMessage {
  std::string codec;    ///< "h264", "hevc", ...
  bool is_key = false;  ///< decoding can begin here
  Bytes data;
};

struct CameraInfoMessage {
  std::uint32_t height = 0;
  std::uint32_t width = 0;
  std::string model;           ///< "plumb_bob", "rational_polynomial", "equidistant"
  std::vector<double> D;       ///< distortion
  std::array<double, 9> K{};   ///< raw images
  std::array<double, 9> R{};   ///< rotation from the raw to the rectified camera
  std::array<double, 12> P{};  ///< rectified images
  bool is_part = false;        ///< the images are binned, or only a region of interest
};

struct ImuMessage {
  std::int64_t stamp_ns = 0;
  std::array<double, 3> angular_velocity{};
  std::array<double, 3> linear_acceleration{};
};

struct OdometryMessage {
  std::int64_t stamp_ns = 0;
  std::string_view frame;        ///< in which the pose is
  std::string_view child_frame;  ///< of which it is the pose
  std::array<double, 3> position{};
  std::array<double, 4> orientation{};       ///< x, y, z, w
  std::array<double, 3> velocity{};          ///< m/s; often zero where it is not measured
  std::array<double, 3> angular_velocity{};  ///< rad/s; likewise
};

/// The topic of the images that image_transport made these of: /left/image_raw for
/// /left/image_raw/compressed and /left/image_raw/ffmpeg.
std::string untransported(const std::string& topic);

/// Heading, rad, of an orientation (x, y, z, w) of any length in axes with z upwards.
double headingOf(const std::array<double, 4>& orientation);

/// Time in the header of these messages, ns: 0 if it is not set, negative if a clock was wrong.
/// Empty if the message ends before it.
std::optional<std::int64_t> headerStamp(const Message& message);

/// Empty if the message is incomplete or not of that type, or has numbers that are not finite or an
/// orientation that is no unit quaternion.
std::optional<ImageMessage> readImage(const Message& message);
std::optional<CompressedImageMessage> readCompressedImage(const Message& message);
std::optional<VideoMessage> readVideo(std::string_view type, const Message& message);
std::optional<CameraInfoMessage> readCameraInfo(const Message& message);
std::optional<ImuMessage> readImu(const Message& message);
std::optional<OdometryMessage> readOdometry(const Message& message);
/// The poses of a message of kPoseTypes, without velocities.
std::optional<std::vector<OdometryMessage>> readPoses(std::string_view type,
                                                      const Message& message);

}  // namespace tolman::ros_messages
