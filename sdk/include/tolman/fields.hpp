// SPDX-License-Identifier: BSD-3-Clause
// One declaration, many uses: how a record lists its fields.
//
// A record is a plain struct with a name, `static constexpr const char* kRecord`, and one function
//
//   template <class Self, class Visit>
//   static void fields(Self& self, Visit&& visit) {
//     TOLMAN_FIELD(stamp_ns, "ns", "data time of the exposure");
//   }
//
// From that list come the tables of run.sqlite, JSON, the NaN check at the plugin boundary, the
// channel of an isolated stage and the reference page. Members may be: bool, integers, float,
// double, enumerations with enumNames(), std::string, Eigen vectors and matrices of float or
// double, Eigen::Isometry3d, Image, NamedArray, other records, and std::vector of records.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>
#include <concepts>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "tolman/image.hpp"

namespace tolman {

/// Name, unit (SI where not said, "" for none) and one line about a record's field.
struct Field {
  std::string_view name;
  std::string_view unit;
  std::string_view doc;
};

/// Names one member inside fields(); the member's name is the field's name.
#define TOLMAN_FIELD(member, unit, doc) visit(::tolman::Field{#member, unit, doc}, self.member)

template <class T>
concept Record = requires {
  { T::kRecord } -> std::convertible_to<std::string_view>;
};

/// Calls visit(Field, member) for each field, in the order of declaration.
template <class R, class Visit>
requires Record<std::remove_const_t<R>>
void visitFields(R& record, Visit&& visit) { std::remove_const_t<R>::fields(record, visit); }

/// A named numeric array: neural activity for a viewer, or a sensor beside the images.
struct NamedArray {
  std::string name;           ///< e.g. "hd.activity"
  std::vector<int> shape;     ///< e.g. {36} or {rows, columns}; row-major
  std::vector<float> values;  ///< as many as the product of shape
};

/// An enumeration with names, listed in the order of its values from 0, by a function in the
/// namespace of the enumeration (for a nested one: a friend of the class):
///
///   enum class Colour : std::uint8_t { Red, Green };
///   inline constexpr std::array<std::string_view, 2> kColourNames = {"red", "green"};
///   constexpr std::span<const std::string_view> enumNames(Colour) { return kColourNames; }
template <class E>
concept NamedEnum = std::is_enum_v<E> && requires(E e) {
  { enumNames(e) } -> std::convertible_to<std::span<const std::string_view>>;
};

template <NamedEnum E>
constexpr std::string_view enumName(E value) {
  const std::span<const std::string_view> names = enumNames(value);
  const auto index = static_cast<std::size_t>(value);
  return index < names.size() ? names[index] : std::string_view("invalid");
}

namespace detail {

template <class T>
bool allFinite(const T& value);

template <class T>
bool allFinite(const std::vector<T>& values) {
  for (const T& value : values) {
    if (!allFinite(value)) return false;
  }
  return true;
}

template <class T>
bool allFinite(const T& value) {
  if constexpr (std::is_floating_point_v<T>) {
    return std::isfinite(value);
  } else if constexpr (NamedEnum<T>) {
    return static_cast<std::size_t>(value) < enumNames(value).size();
  } else if constexpr (std::is_same_v<T, NamedArray>) {
    return allFinite(value.values);
  } else if constexpr (std::is_same_v<T, Eigen::Isometry3d>) {
    return value.matrix().allFinite();
  } else if constexpr (Record<T>) {
    bool finite = true;
    visitFields(value, [&](const Field&, const auto& v) { finite = finite && allFinite(v); });
    return finite;
  } else if constexpr (std::is_base_of_v<Eigen::DenseBase<T>, T>) {
    return value.allFinite();
  } else {
    return true;  // integers, text, pixels
  }
}

}  // namespace detail

/// The name of the first field that holds NaN, infinity or an impossible enumeration value;
/// empty when all is well.
template <Record R>
std::string firstInvalidField(const R& record) {
  std::string bad;
  visitFields(record, [&](const Field& field, const auto& value) {
    if (bad.empty() && !detail::allFinite(value)) bad = field.name;
  });
  return bad;
}

}  // namespace tolman
