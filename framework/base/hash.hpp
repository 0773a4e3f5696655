// SPDX-License-Identifier: BSD-3-Clause
// A 64-bit hash of values, to tell whether they are the same bit for bit. Not cryptographic; two of
// a million that differ are the same with a probability of 1e-7. For bytes of files see
// record/digest.hpp.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman {

/// -0.0 and 0.0 differ. The padding of images is left out.
class BitHash {
 public:
  void add(const void* bytes, std::size_t size) {
    const char* next = static_cast<const char*>(bytes);
    for (std::size_t taken = 8; size > 0; next += taken, size -= taken) {
      taken = size < 8 ? size : 8;
      std::uint64_t word = 0;
      std::memcpy(&word, next, taken);
      hash_ = (hash_ ^ word) * 0x9e3779b97f4a7c15ULL;
      hash_ ^= hash_ >> 32U;
    }
  }
  void add(const Image& image) {
    const int shape[] = {image.width(), image.height(), static_cast<int>(image.format())};
    add(shape, sizeof shape);
    const auto bytes =
        static_cast<std::size_t>(std::ptrdiff_t{image.width()} * bytesPerPixel(image.format()));
    for (int r = 0; r < image.height(); ++r) add(image.row(r), bytes);
  }
  void add(const std::string& text) { add(text.c_str(), text.size() + 1); }
  template <class T>
  void add(const std::vector<T>& values) {
    if constexpr (std::is_arithmetic_v<T>) {
      add(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) add(value);
    }
    const std::size_t size = values.size();
    add(&size, sizeof size);
  }
  template <class T>
  void add(const T& value) {
    if constexpr (Record<T>) {
      visitFields(value, [this](const Field&, const auto& v) { this->add(v); });
    } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
      add(value.matrix().data(), sizeof(double) * 16);
    } else if constexpr (requires { value.derived(); }) {  // Eigen
      const Eigen::Index shape[] = {value.rows(), value.cols()};
      add(shape, sizeof shape);
      add(value.data(), sizeof(typename T::Scalar) * static_cast<std::size_t>(value.size()));
    } else {
      static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
      add(&value, sizeof value);
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325ULL;
};

template <class T>
std::uint64_t bitHash(const T& value) {
  BitHash hash;
  hash.add(value);
  return hash.value();
}

}  // namespace tolman
