// SPDX-License-Identifier: BSD-3-Clause
// A bag that is being written.
#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "field_writer.hpp"
#include "tolman/status.hpp"

namespace tolman::bag_writer {

using ros_map::Format;

/// The bytes of a number, little-endian.
template <class T>
requires std::is_arithmetic_v<T> std::string raw(T value) {
  return {reinterpret_cast<const char*>(&value), sizeof value};
}
/// A text after its length, a uint32.
inline std::string prefixed(const std::string& text) {
  return raw(static_cast<std::uint32_t>(text.size())) + text;
}

class BagOutput {
 public:
  virtual ~BagOutput() = default;

  virtual Format format() const = 0;
  /// `type`: "sensor_msgs/msg/CameraInfo". A topic is declared by its first message.
  virtual void write(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
                     const std::vector<std::uint8_t>& message) = 0;
  /// Failed if the file cannot be written. To be called once; without it the file has no index.
  virtual Status close() = 0;
};

std::unique_ptr<BagOutput> newMcap(std::ofstream file);
std::unique_ptr<BagOutput> newRos1Bag(std::ofstream file);

}  // namespace tolman::bag_writer
