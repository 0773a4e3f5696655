// SPDX-License-Identifier: BSD-3-Clause
// Common data representation (CDR, OMG): how ROS 2 writes messages. Numbers are aligned to their
// size, counted from the end of a header of four bytes, which also says the order of bytes.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <type_traits>

#include "bytes.hpp"

namespace tolman::ros_bag {

/// Reads fields one after another; after the first that is not there everything is 0 and empty.
class CdrReader {
 public:
  explicit CdrReader(Bytes message) {
    // Only plain CDR, big-endian (0) or little-endian (1); ROS 2 writes no other kind.
    const bool known = message.size() >= 4 && message[0] == 0 && message[1] <= 1;
    failed_ = !known;
    if (!known) return;
    big_endian_ = message[1] == 0;
    body_ = message.subspan(4);
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
  /// Without the zero at its end.
  std::string_view text() {
    const std::string_view all = asText(take(number<std::uint32_t>()));
    if (all.empty() || all.back() != '\0') failed_ = true;
    return failed_ ? std::string_view() : all.substr(0, all.size() - 1);
  }
  /// The bytes of a sequence of bytes.
  Bytes bytes() { return take(number<std::uint32_t>()); }

  /// How many elements of `size` bytes a sequence has, if as many can follow.
  std::size_t count(std::size_t size) {
    const std::size_t claimed = number<std::uint32_t>();
    if (claimed > (body_.size() - at_) / size) failed_ = true;
    return failed_ ? 0 : claimed;
  }
  bool ok() const { return !failed_; }

 private:
  void align(std::size_t size) {
    const std::size_t padding = (size - at_ % size) % size;
    if (padding > 0) take(padding);
  }
  Bytes take(std::size_t size) {
    if (size > body_.size() - at_) failed_ = true;
    if (failed_) return {};
    at_ += size;
    return body_.subspan(at_ - size, size);
  }

  Bytes body_;
  std::size_t at_ = 0;
  bool big_endian_ = false;
  bool failed_ = false;
};

}  // namespace tolman::ros_bag
