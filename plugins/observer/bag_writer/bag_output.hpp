// SPDX-License-Identifier: BSD-3-Clause
// A bag that is being written.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>
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

/// Both formats have messages in chunks, each with its index, and at the end an index of the
/// chunks.
class BagOutput {
 public:
  virtual ~BagOutput() = default;

  virtual Format format() const = 0;
  /// `type`: "sensor_msgs/msg/CameraInfo". A topic is declared by its first message.
  void write(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
             const std::vector<std::uint8_t>& message) {
    constexpr std::size_t kEnough = 4U << 20;  // bytes
    if (chunk_.empty()) begin_ns_ = end_ns_ = stamp_ns;
    begin_ns_ = std::min(begin_ns_, stamp_ns);
    end_ns_ = std::max(end_ns_, stamp_ns);
    append(topic, type, stamp_ns, {message.begin(), message.end()});
    if (chunk_.size() > kEnough) endChunk();
  }
  /// Failed if the file cannot be written. To be called once; without it the file has no index.
  Status close() {
    if (!chunk_.empty()) endChunk();
    writeIndex();
    file_.close();
    return file_ ? Status::ok() : Status::failed("the bag cannot be written; is the disk full?");
  }

 protected:
  explicit BagOutput(std::ofstream file) : file_(std::move(file)) {}

  void put(const std::string& bytes) {
    file_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    at_ += bytes.size();
  }

  std::ofstream file_;
  std::uint64_t at_ = 0;  ///< bytes written
  std::string chunk_;     ///< the open one
  std::int64_t begin_ns_ = 0;
  std::int64_t end_ns_ = 0;
  std::uint32_t chunks_ = 0;  ///< written

 private:
  /// Appends the message to the chunk.
  virtual void append(const std::string& topic, const std::string& type, std::int64_t stamp_ns,
                      const std::string& message) = 0;
  virtual void writeChunk() = 0;
  virtual void writeIndex() = 0;

  void endChunk() {
    writeChunk();
    ++chunks_;
    chunk_.clear();
  }
};

std::unique_ptr<BagOutput> newMcap(std::ofstream file);
std::unique_ptr<BagOutput> newRos1Bag(std::ofstream file);

}  // namespace tolman::bag_writer
