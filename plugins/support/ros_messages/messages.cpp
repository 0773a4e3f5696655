// SPDX-License-Identifier: BSD-3-Clause
#include "messages.hpp"

#include <cmath>

#include "field_reader.hpp"

namespace tolman::ros_messages {

namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000;

/// The time at the beginning of a header, ns; in ROS 1 it follows the sequence number.
std::int64_t readStamp(FieldReader& fields) {
  const bool ros1 = fields.encoding() == Encoding::Ros1;
  if (ros1) fields.number<std::uint32_t>();
  // In ROS 1 without a sign: from 2038 on it is taken as a time before 1970, that of a wrong clock.
  const std::int64_t seconds = fields.number<std::int32_t>();
  const std::int64_t nanoseconds = fields.number<std::uint32_t>();
  if (nanoseconds >= kSecond_ns) fields.fail();
  return seconds * kSecond_ns + nanoseconds;
}

/// std_msgs/Header; the name of the frame is not used.
std::int64_t readHeader(FieldReader& fields) {
  const std::int64_t stamp_ns = readStamp(fields);
  fields.text();
  return stamp_ns;
}

template <std::size_t N>
bool areFinite(const std::array<double, N>& values) {
  for (const double value : values) {
    if (!(std::abs(value) < 1e9)) return false;  // nor NaN
  }
  return true;
}

/// Whether this is a rotation. ROS writes (0, 0, 0, 0) where an orientation is not set. 0.1:
/// chosen, not tuned; rounding, also to float, is far below it.
bool isRotation(const std::array<double, 4>& q) {
  constexpr double kMostNormError = 0.1;
  double squares = 0;
  for (const double value : q) squares += value * value;
  return std::abs(std::sqrt(squares) - 1) <= kMostNormError;
}

/// Binning and region of interest of a CameraInfo, which messages of old programs lack.
bool readsPart(FieldReader& fields, const CameraInfoMessage& info) {
  const auto binning_x = fields.number<std::uint32_t>();
  const auto binning_y = fields.number<std::uint32_t>();
  const auto left = fields.number<std::uint32_t>();
  const auto top = fields.number<std::uint32_t>();
  const auto height = fields.number<std::uint32_t>();
  const auto width = fields.number<std::uint32_t>();
  if (!fields.ok()) return false;
  const bool whole = (width == 0 || width == info.width) && (height == 0 || height == info.height);
  return binning_x > 1 || binning_y > 1 || left > 0 || top > 0 || !whole;
}

}  // namespace

double headingOf(const std::array<double, 4>& orientation) {
  const auto [x, y, z, w] = orientation;
  return std::atan2(2 * (w * z + x * y), w * w + x * x - y * y - z * z);
}

std::optional<std::int64_t> headerStamp(const Message& message) {
  FieldReader fields(message);
  const std::int64_t stamp_ns = readStamp(fields);
  if (!fields.ok()) return std::nullopt;
  return stamp_ns;
}

std::optional<ImageMessage> readImage(const Message& message) {
  FieldReader fields(message);
  ImageMessage image;
  image.stamp_ns = readHeader(fields);
  image.height = fields.number<std::uint32_t>();
  image.width = fields.number<std::uint32_t>();
  image.encoding = fields.text();
  image.big_endian = fields.number<std::uint8_t>() != 0;
  image.step = fields.number<std::uint32_t>();
  image.data = fields.bytes();
  if (!fields.ok()) return std::nullopt;
  return image;
}

std::optional<CompressedImageMessage> readCompressedImage(const Message& message) {
  FieldReader fields(message);
  CompressedImageMessage image;
  image.stamp_ns = readHeader(fields);
  image.format = fields.text();
  image.data = fields.bytes();
  if (!fields.ok()) return std::nullopt;
  return image;
}

namespace {

/// Whether a packet of H.264 or H.265 has parameters or a picture that needs no other one.
bool beginsAnew(std::string_view codec, Bytes data) {
  const bool h264 = codec.find("264") != std::string_view::npos;
  const bool h265 = codec.find("265") != std::string_view::npos;
  if (!h264 && !h265) return true;
  for (std::size_t i = 0; i + 3 < data.size(); ++i) {
    if (data[i] != 0 || data[i + 1] != 0 || data[i + 2] != 1) continue;
    const int kind = h264 ? data[i + 3] & 0x1f : data[i + 3] >> 1 & 0x3f;
    if (h264 ? kind == 5 || kind == 7 : (kind >= 16 && kind <= 21) || kind == 32) return true;
  }
  return false;
}

}  // namespace

std::optional<VideoMessage> readVideo(std::string_view type, const Message& message) {
  FieldReader fields(message);
  VideoMessage video;
  readHeader(fields);
  if (type == kVideoPacket) {
    fields.number<std::int32_t>();  // width and height
    fields.number<std::int32_t>();
    video.codec = fields.text();
    fields.number<std::uint64_t>();  // the coder's own time
    video.is_key = (fields.number<std::uint8_t>() & 1U) != 0;
    fields.number<std::uint8_t>();  // order of bytes of the pictures before they were coded
    video.data = fields.bytes();
  } else {
    video.data = fields.bytes();
    video.codec = fields.text();
    video.is_key = beginsAnew(video.codec, video.data);
  }
  if (!fields.ok() || video.data.empty()) return std::nullopt;
  return video;
}

std::string untransported(const std::string& topic) {
  for (const std::string_view transport : {"/compressed", "/ffmpeg"}) {
    if (topic.ends_with(transport)) return topic.substr(0, topic.size() - transport.size());
  }
  return topic;
}

std::optional<CameraInfoMessage> readCameraInfo(const Message& message) {
  FieldReader fields(message);
  CameraInfoMessage info;
  readHeader(fields);
  info.height = fields.number<std::uint32_t>();
  info.width = fields.number<std::uint32_t>();
  info.model = fields.text();
  info.D.resize(fields.count(sizeof(double)));
  for (double& coefficient : info.D) coefficient = fields.number<double>();
  info.K = fields.numbers<9>();
  info.R = fields.numbers<9>();
  info.P = fields.numbers<12>();
  bool finite = areFinite(info.K) && areFinite(info.R) && areFinite(info.P);
  for (const double coefficient : info.D) finite = finite && std::abs(coefficient) < 1e9;
  if (!fields.ok() || !finite) return std::nullopt;
  info.is_part = readsPart(fields, info);
  return info;
}

std::optional<ImuMessage> readImu(const Message& message) {
  FieldReader fields(message);
  ImuMessage imu;
  imu.stamp_ns = readHeader(fields);
  fields.numbers<4 + 9>();  // orientation and its covariance
  imu.angular_velocity = fields.numbers<3>();
  fields.numbers<9>();
  imu.linear_acceleration = fields.numbers<3>();
  const bool finite = areFinite(imu.angular_velocity) && areFinite(imu.linear_acceleration);
  if (!fields.ok() || !finite) return std::nullopt;
  return imu;
}

namespace {

OdometryMessage readPose(FieldReader& fields, bool has_child) {
  OdometryMessage pose;
  pose.stamp_ns = readStamp(fields);
  pose.frame = fields.text();
  if (has_child) pose.child_frame = fields.text();
  pose.position = fields.numbers<3>();
  pose.orientation = fields.numbers<4>();
  const bool finite = areFinite(pose.position) && areFinite(pose.orientation);
  if (!finite || !isRotation(pose.orientation)) fields.fail();
  return pose;
}

}  // namespace

std::optional<std::vector<OdometryMessage>> readPoses(std::string_view type,
                                                      const Message& message) {
  FieldReader fields(message);
  const bool many = isTransforms(type);
  std::vector<OdometryMessage> poses;
  for (std::size_t left = many ? fields.count(1) : 1; left > 0 && fields.ok(); --left) {
    poses.push_back(readPose(fields, many || type == kOdometry || type == kTransform));
  }
  if (!fields.ok()) return std::nullopt;
  return poses;
}

std::optional<OdometryMessage> readOdometry(const Message& message) {
  FieldReader fields(message);
  OdometryMessage odometry = readPose(fields, true);
  if (!fields.ok()) return std::nullopt;
  fields.numbers<36>();  // covariance
  const std::array<double, 3> velocity = fields.numbers<3>();
  const std::array<double, 3> angular_velocity = fields.numbers<3>();
  if (!fields.ok() || !areFinite(velocity) || !areFinite(angular_velocity)) return odometry;
  odometry.velocity = velocity;
  odometry.angular_velocity = angular_velocity;
  return odometry;
}

}  // namespace tolman::ros_messages
