// SPDX-License-Identifier: BSD-3-Clause
// Bytes of a file, and numbers in them, little-endian. Nothing is read beyond the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace tolman::ros_messages {

using Bytes = std::span<const std::uint8_t>;

inline std::string_view asText(Bytes bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// Reads fields one after another. After the end of the bytes all fields are 0 or empty.
class ByteReader {
 public:
  explicit ByteReader(Bytes bytes) : bytes_(bytes) {}

  template <class T>
  T number() {
    const Bytes field = take(sizeof(T));
    std::uint64_t value = 0;
    for (std::size_t i = 0; i < field.size(); ++i) value |= std::uint64_t{field[i]} << (8 * i);
    return static_cast<T>(value);
  }
  /// The next `count` bytes.
  Bytes take(std::uint64_t count) {
    if (count > bytes_.size() - at_) failed_ = true;
    if (failed_) return {};
    at_ += static_cast<std::size_t>(count);
    return bytes_.subspan(at_ - static_cast<std::size_t>(count), static_cast<std::size_t>(count));
  }
  /// A text after its length, a uint32.
  std::string_view text() { return asText(take(number<std::uint32_t>())); }

  bool ok() const { return !failed_; }
  std::size_t at() const { return at_; }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  Bytes bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

}  // namespace tolman::ros_messages
