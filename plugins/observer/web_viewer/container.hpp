// SPDX-License-Identifier: BSD-3-Clause
// The one form of all binary bodies: a length, a JSON header that lists arrays, and the arrays.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::web_viewer {

enum class Element : std::uint8_t { U8, I32, F32, F64 };

/// A named array of a container. The bytes are shared, so that one encoding serves many messages.
struct PackedArray {
  std::string name;
  Element element = Element::U8;
  std::vector<std::size_t> shape;
  std::shared_ptr<const std::string> bytes;
};

template <class T>
constexpr Element elementOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return Element::U8;
  if constexpr (std::is_same_v<T, std::int32_t>) return Element::I32;
  if constexpr (std::is_same_v<T, float>) return Element::F32;
  if constexpr (std::is_same_v<T, double>) return Element::F64;
}

/// Copies `values`, row-major.
template <class T>
PackedArray pack(std::string name, std::vector<std::size_t> shape, std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  auto copy = std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes.data()),
                                                  bytes.size());
  return {std::move(name), elementOf<T>(), std::move(shape), std::move(copy)};
}

/// `header` gets the member "arrays"; it is an object.
std::string encodeContainer(nlohmann::json header, const std::vector<PackedArray>& arrays);

/// JSON of what may hold bytes that are no UTF-8: those are replaced.
std::string jsonText(const nlohmann::json& json);

}  // namespace tolman::web_viewer
