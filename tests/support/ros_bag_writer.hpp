// SPDX-License-Identifier: BSD-3-Clause
// Writes ROS 2 messages and bags, for tests of their readers.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::test {

/// CDR, with the header of four bytes.
class CdrWriter {
 public:
  explicit CdrWriter(bool big_endian = false)
      : big_endian_(big_endian), bytes_{'\0', big_endian ? '\0' : '\1', '\0', '\0'} {}

  template <class T>
  CdrWriter& number(T value) {
    while ((bytes_.size() - 4) % sizeof(T) != 0) bytes_ += '\0';
    std::array<char, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    if (big_endian_) return append(std::string(raw.rbegin(), raw.rend()));
    return append({raw.data(), raw.size()});
  }
  CdrWriter& numbers(const std::vector<double>& values) {
    for (const double value : values) number(value);
    return *this;
  }
  CdrWriter& text(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size() + 1));
    return append(std::string(value) + '\0');
  }
  CdrWriter& data(std::string_view value) {
    number(static_cast<std::uint32_t>(value.size()));
    return append(std::string(value));
  }
  CdrWriter& header(std::int64_t stamp_ns, const std::string& frame = "camera") {
    number(static_cast<std::int32_t>(stamp_ns / 1'000'000'000));
    return number(static_cast<std::uint32_t>(stamp_ns % 1'000'000'000)).text(frame);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  CdrWriter& append(const std::string& raw) {
    bytes_ += raw;
    return *this;
  }
  bool big_endian_;
  std::string bytes_;
};

struct RosImage {
  std::int64_t stamp_ns = 0;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string encoding;
  std::string pixels;
  bool big_endian = false;    ///< of pixels of 16 and 32 bit
  std::uint32_t padding = 0;  ///< bytes after each row, which `pixels` has too
};
/// Rows are as long as the pixels say. `big_endian`: of the message.
std::string imageMessage(const RosImage& image, bool big_endian = false);
std::string compressedImageMessage(std::int64_t stamp_ns, const std::string& format,
                                   const std::string& coded);

struct RosCamera {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string model = "plumb_bob";
  std::vector<double> D;
  std::vector<double> K;  ///< 9
  std::vector<double> R;  ///< 9
  std::vector<double> P;  ///< 12
  std::uint32_t binning = 0;
};
/// An undistorted camera with this focal length in the middle of the image.
RosCamera plainCamera(std::uint32_t width, std::uint32_t height, double focal, double baseline);
std::string cameraInfoMessage(const RosCamera& camera);
std::string imuMessage(std::int64_t stamp_ns, const std::vector<double>& angular_velocity,
                       const std::vector<double>& linear_acceleration);
/// A robot at (x, y) with this heading.
std::string odometryMessage(std::int64_t stamp_ns, double x, double y, double theta,
                            double speed = 0, const std::string& frame = "odom",
                            double turn_rate = 0);

struct RosMessage {
  std::string topic;
  std::string type;
  std::int64_t log_ns = 0;
  std::string bytes;
};

struct McapStyle {
  std::string compression;  ///< "", "zstd" or "lz4"
  bool chunks = true;
  std::size_t per_chunk = 3;  ///< messages
  bool sums = true;           ///< check sums of chunks
  std::string encoding = "cdr";
  bool indexed = false;  ///< chunks are followed by indices, and the data by a summary
  int summed_from = -1;  ///< the data have a check sum: from byte 0, or 8, behind the magic bytes
  bool totals_only = false;  ///< the summary does not count the messages of each channel
};
std::string mcapBytes(const std::vector<RosMessage>& messages, const McapStyle& style = {});
void writeBytes(const std::filesystem::path& file, const std::string& bytes);

/// `compressed`: each message by itself, as rosbag2 does.
void writeDb3(const std::filesystem::path& file, const std::vector<RosMessage>& messages,
              bool compressed = false);
std::string packedByZstd(const std::string& bytes);

}  // namespace tolman::test
