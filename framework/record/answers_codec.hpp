// SPDX-License-Identifier: BSD-3-Clause
// Encodes records bit for bit, for answers.bin: the fields in order, numbers in little-endian byte
// order, a text or a list after its length (u64), a matrix after its number of columns (u64),
// column by column. Images are left out.
#pragma once

#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman::record {

static_assert(std::endian::native == std::endian::little);

class AnswersEncoder {
 public:
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_same_v<T, Image>) {
      return;
    } else if constexpr (Record<T>) {
      visitFields(value, [&](const Field&, const auto& member) { put(member); });
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      raw(&value, sizeof value);
    } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
      raw(value.matrix().data(), 16 * sizeof(double));
    } else if constexpr (std::is_base_of_v<Eigen::DenseBase<T>, T>) {
      put(static_cast<std::uint64_t>(value.cols()));
      raw(value.data(), sizeof(typename T::Scalar) * static_cast<std::size_t>(value.size()));
    } else {  // texts and lists
      put(static_cast<std::uint64_t>(value.size()));
      for (const auto& item : value) put(item);
    }
  }

  std::string take() { return std::move(bytes_); }

 private:
  void raw(const void* bytes, std::size_t count) {
    if (count > 0) bytes_.append(static_cast<const char*>(bytes), count);
  }
  std::string bytes_;
};

/// The names of all fields of R and of the records in it, in order. A reader must have the same.
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

}  // namespace tolman::record
