// SPDX-License-Identifier: BSD-3-Clause
// All answers of one instance as hashes of their fields, to compare two runs bit by bit.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tolman/fields.hpp"

namespace tolman::conformance {

/// FNV-1a hash of all bits of a value: -0.0 and 0.0 differ. The padding of images is left out.
class BitHash {
 public:
  void add(const void* bytes, std::size_t size);
  void add(const Image& image);
  void add(const NamedArray& array);
  void add(const std::string& text);
  template <class T>
  void add(const std::vector<T>& values) {
    for (const T& value : values) add(value);
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

/// One answer: the call, and a hash for each field.
struct TranscriptEntry {
  std::string call;  ///< "frame 12"
  std::vector<std::pair<std::string, std::uint64_t>> fields;

  template <Record R>
  void add(const R& record) {
    visitFields(record, [this](const Field& field, const auto& value) {
      this->addValue(std::string(field.name), value);
    });
  }
  template <class T>
  void addValue(std::string name, const T& value) {
    BitHash hash;
    hash.add(value);
    fields.emplace_back(std::move(name), hash.value());
  }
};

using Transcript = std::vector<TranscriptEntry>;

/// "frame 12: 'T_previous_current'", or nothing when all bits agree. The first `skip` answers of
/// `expected` are ignored.
std::optional<std::string> firstDifference(const Transcript& expected, const Transcript& found,
                                           std::size_t skip = 0);

}  // namespace tolman::conformance
