// SPDX-License-Identifier: BSD-3-Clause
// Bytes of a file, and numbers in them, little-endian. Nothing is read beyond the end.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>
#include <vector>

namespace tolman::ros_messages {

using Bytes = std::span<const std::uint8_t>;

enum class Encoding : std::uint8_t { Cdr, Ros1 };

/// The bytes of one message. A view; they must outlive it.
struct Message {
  Message(Bytes of, Encoding written = Encoding::Cdr) : bytes(of), encoding(written) {}
  Message(const std::vector<std::uint8_t>& of, Encoding written = Encoding::Cdr)
      : bytes(of), encoding(written) {}

  Bytes bytes;
  Encoding encoding;
};

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

// Fields of messages. ROS 2 writes the common data representation (CDR, OMG): numbers are aligned
// to their size, counted from the end of a header of four bytes, which contains the byte order.
// ROS 1 writes little-endian numbers without padding, and texts without a terminating zero.

/// Reads fields one after another. After the end of the message all fields are 0 or empty.
class FieldReader {
 public:
  explicit FieldReader(Message message) : encoding_(message.encoding) {
    if (encoding_ == Encoding::Ros1) {
      body_ = message.bytes;
      return;
    }
    // Only plain CDR, big-endian (0) or little-endian (1); ROS 2 writes no other kind.
    const bool known = message.bytes.size() >= 4 && message.bytes[0] == 0 && message.bytes[1] <= 1;
    failed_ = !known;
    if (!known) return;
    big_endian_ = message.bytes[1] == 0;
    body_ = message.bytes.subspan(4);
  }

  template <class T>
  requires std::is_arithmetic_v<T> T number() {
    align(sizeof(T));
    const Bytes field = take(sizeof(T));
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < field.size(); ++i) {
      const std::size_t place = big_endian_ ? field.size() - 1 - i : i;
      bits |= std::uint64_t{field[i]} << (8 * place);
    }
    if constexpr (std::is_same_v<T, double>) return std::bit_cast<double>(bits);
    if constexpr (std::is_same_v<T, float>) {
      return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
    }
    if constexpr (std::is_integral_v<T>) return static_cast<T>(bits);
  }
  template <std::size_t N>
  std::array<double, N> numbers() {
    std::array<double, N> values{};
    for (double& value : values) value = number<double>();
    return values;
  }
  /// A text without its terminating zero.
  std::string_view text() {
    const std::string_view all = asText(take(number<std::uint32_t>()));
    if (encoding_ == Encoding::Ros1) return all;
    if (all.empty() || all.back() != '\0') failed_ = true;
    return failed_ ? std::string_view() : all.substr(0, all.size() - 1);
  }
  /// The bytes of a sequence of bytes.
  Bytes bytes() { return take(number<std::uint32_t>()); }

  /// Number of elements of `size` bytes of a sequence; 0 if the remaining bytes are too few.
  std::size_t count(std::size_t size) {
    const std::size_t claimed = number<std::uint32_t>();
    if (claimed > (body_.size() - at_) / size) failed_ = true;
    return failed_ ? 0 : claimed;
  }
  bool ok() const { return !failed_; }
  /// For values that no sound message has.
  void fail() { failed_ = true; }
  Encoding encoding() const { return encoding_; }

 private:
  void align(std::size_t size) {
    if (encoding_ == Encoding::Ros1) return;
    const std::size_t padding = (size - at_ % size) % size;
    if (padding > 0) take(padding);
  }
  Bytes take(std::size_t size) {
    if (size > body_.size() - at_) failed_ = true;
    if (failed_) return {};
    at_ += size;
    return body_.subspan(at_ - size, size);
  }

  Encoding encoding_;
  Bytes body_;
  std::size_t at_ = 0;
  bool big_endian_ = false;
  bool failed_ = false;
};

}  // namespace tolman::ros_messages
