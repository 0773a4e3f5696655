// SPDX-License-Identifier: BSD-3-Clause
// 128 bits of the values of a record, to tell whether it has changed without keeping it. Two of a
// million records that differ have the same with a probability of 1e-26.
#pragma once

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

#include "tolman/fields.hpp"

namespace tolman::record {

struct Fingerprint {
  std::uint64_t first = 0x9e3779b97f4a7c15ULL;
  std::uint64_t second = 0xc2b2ae3d27d4eb4fULL;
  bool operator==(const Fingerprint&) const = default;

  void add(std::uint64_t word) {
    first = (first ^ word) * 0x9e3779b97f4a7c15ULL;
    first ^= first >> 32U;
    second = (second + word) * 0xc2b2ae3d27d4eb4fULL;
    second ^= second >> 29U;
  }
  /// 0.0 and -0.0 are the same value.
  void add(double value) { add(std::bit_cast<std::uint64_t>(value + 0.0)); }
  void add(const std::string& text) {
    add(std::uint64_t{text.size()});
    for (const char c : text) add(std::uint64_t{static_cast<unsigned char>(c)});
  }
  void add(const Eigen::Isometry3d& T) { add(T.matrix()); }
  template <class Derived>
  void add(const Eigen::DenseBase<Derived>& values) {
    for (const auto value : values.reshaped()) add(static_cast<double>(value));
  }
  template <class T>
  requires std::is_enum_v<T> || std::is_integral_v<T>
  void add(T value) { add(static_cast<std::uint64_t>(value)); }
};

template <Record R>
Fingerprint fingerprintOf(const R& record) {
  Fingerprint fingerprint;
  visitFields(record, [&](const Field&, const auto& value) { fingerprint.add(value); });
  return fingerprint;
}

}  // namespace tolman::record
