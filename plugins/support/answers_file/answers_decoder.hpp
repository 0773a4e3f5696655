// SPDX-License-Identifier: BSD-3-Clause
// Decodes the records of answers.bin: the fields in order, numbers in little-endian byte order, a
// text or a list after its length (u64), a matrix after its number of columns (u64). Images are not
// stored. A read beyond the end gives zeros and makes complete() false.
#pragma once

#include <bit>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>

#include "tolman/fields.hpp"

namespace tolman::answers_file {

static_assert(std::endian::native == std::endian::little);

class AnswersDecoder {
 public:
  explicit AnswersDecoder(std::string_view bytes) : bytes_(bytes) {}

  template <class T>
  void get(T& value) {
    if constexpr (std::is_same_v<T, Image>) {
      return;
    } else if constexpr (Record<T>) {
      visitFields(value, [&](const Field&, auto& member) { get(member); });
    } else if constexpr (std::is_same_v<T, bool>) {
      std::uint8_t byte = 0;
      raw(&byte, 1);
      value = byte != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
      raw(value.matrix().data(), 16 * sizeof(double));
    } else if constexpr (std::is_base_of_v<Eigen::DenseBase<T>, T>) {
      using Scalar = typename T::Scalar;
      const std::size_t columns = count(sizeof(Scalar) * T::RowsAtCompileTime);
      if (T::ColsAtCompileTime != Eigen::Dynamic &&
          columns != static_cast<std::size_t>(T::ColsAtCompileTime)) {
        overrun_ = true;
        return;
      }
      value.resize(T::RowsAtCompileTime, static_cast<Eigen::Index>(columns));
      raw(value.data(), sizeof(Scalar) * static_cast<std::size_t>(value.size()));
    } else {  // texts and lists
      value.resize(count(1));
      for (auto& item : value) get(item);
    }
  }
  template <class T>
  T next() {
    T value{};
    get(value);
    return value;
  }
  /// A text, without copying it.
  std::string_view text() {
    const std::size_t size = count(1);
    const std::string_view found = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    return found;
  }
  /// Whether exactly all bytes were read.
  bool complete() const { return !overrun_ && bytes_.empty(); }

 private:
  /// Reads a number of elements of at least `least` bytes each; 0 if the remaining bytes are too
  /// few.
  std::size_t count(std::size_t least) {
    std::uint64_t number = 0;
    raw(&number, sizeof number);
    if (number <= bytes_.size() / least) return number;
    overrun_ = true;
    return 0;
  }
  void raw(void* destination, std::size_t size) {
    overrun_ = overrun_ || size > bytes_.size();
    if (overrun_ || size == 0) return;
    std::memcpy(destination, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

  std::string_view bytes_;
  bool overrun_ = false;
};

/// The names of all fields of R and of the records in it, in order.
template <Record R>
std::string fieldNames() {
  std::string names = std::string(R::kRecord) + "(";
  const R record{};
  visitFields(record, [&](const Field& field, const auto& value) {
    using T = std::remove_cvref_t<decltype(value)>;
    names.append(field.name);
    if constexpr (Record<T>) {
      names += fieldNames<T>();
    } else if constexpr (requires { typename T::value_type; }) {
      if constexpr (Record<typename T::value_type>) names += fieldNames<typename T::value_type>();
    }
    names += ",";
  });
  return names + ")";
}

}  // namespace tolman::answers_file
