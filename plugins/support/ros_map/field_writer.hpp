// SPDX-License-Identifier: BSD-3-Clause
// Writes fields of messages one after another, as ROS 2 (CDR, little-endian) or ROS 1 does.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tolman::ros_map {

enum class Format : std::uint8_t { Ros2, Ros1 };

class FieldWriter {
 public:
  explicit FieldWriter(Format format = Format::Ros2) : format_(format) {
    if (format == Format::Ros2) bytes_ = {0, 1, 0, 0};  // plain CDR, little-endian
  }

  template <class T>
  requires std::is_arithmetic_v<T> FieldWriter& number(T value) {
    static_assert(std::endian::native == std::endian::little);
    while (format_ == Format::Ros2 && (bytes_.size() - 4) % sizeof(T) != 0) bytes_.push_back(0);
    std::array<std::uint8_t, sizeof(T)> raw{};
    std::memcpy(raw.data(), &value, sizeof(T));
    bytes_.insert(bytes_.end(), raw.begin(), raw.end());
    return *this;
  }
  FieldWriter& count(std::size_t elements) { return number(static_cast<std::uint32_t>(elements)); }
  FieldWriter& numbers(std::span<const double> values) {
    for (const double value : values) number(value);
    return *this;
  }
  FieldWriter& zeros(std::size_t doubles) {
    for (; doubles > 0; --doubles) number(0.0);
    return *this;
  }
  FieldWriter& text(std::string_view value) {
    const bool ros2 = format_ == Format::Ros2;
    count(value.size() + (ros2 ? 1 : 0));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    if (ros2) bytes_.push_back(0);
    return *this;
  }
  /// A sequence of bytes.
  FieldWriter& bytes(std::string_view values) {
    count(values.size());
    bytes_.insert(bytes_.end(), values.begin(), values.end());
    return *this;
  }
  FieldWriter& time(std::int64_t ns) {
    constexpr std::int64_t kSecond_ns = 1'000'000'000;
    number(static_cast<std::int32_t>(ns / kSecond_ns));
    return number(static_cast<std::uint32_t>(ns % kSecond_ns));
  }
  /// std_msgs/Header.
  FieldWriter& header(std::int64_t stamp_ns, std::string_view frame) {
    if (format_ == Format::Ros1) number(std::uint32_t{0});
    return time(stamp_ns).text(frame);
  }

  Format format() const { return format_; }
  const std::vector<std::uint8_t>& message() const { return bytes_; }

 private:
  Format format_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace tolman::ros_map
