// SPDX-License-Identifier: BSD-3-Clause
// The binary form of all messages: length of the header (uint32), JSON header that lists the
// arrays, arrays aligned to 8 bytes; little-endian.
#pragma once

#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tolman::web_viewer {

enum class ElementType : std::uint8_t { U8, I32, F32, F64 };

/// A named array of a container. The bytes are shared between messages.
struct PackedArray {
  std::string name;
  ElementType element = ElementType::U8;
  std::vector<std::size_t> shape;
  std::shared_ptr<const std::string> bytes;
};

template <class T>
constexpr ElementType elementOf() {
  if constexpr (std::is_same_v<T, std::uint8_t>) return ElementType::U8;
  if constexpr (std::is_same_v<T, std::int32_t>) return ElementType::I32;
  if constexpr (std::is_same_v<T, float>) return ElementType::F32;
  if constexpr (std::is_same_v<T, double>) return ElementType::F64;
}

/// Copies `values`, row-major.
template <class T>
PackedArray pack(std::string name, std::vector<std::size_t> shape, std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  auto copy = std::make_shared<const std::string>(reinterpret_cast<const char*>(bytes.data()),
                                                  bytes.size());
  return {std::move(name), elementOf<T>(), std::move(shape), std::move(copy)};
}

/// `header` is an object; the member "arrays" is added to it.
std::string encodeContainer(nlohmann::json header, const std::vector<PackedArray>& arrays);

/// JSON text; invalid UTF-8 is replaced.
std::string jsonText(const nlohmann::json& json);

}  // namespace tolman::web_viewer
