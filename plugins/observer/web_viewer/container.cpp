// SPDX-License-Identifier: BSD-3-Clause
#include "container.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace tolman::web_viewer {
namespace {

static_assert(std::endian::native == std::endian::little, "the wire is little-endian");

constexpr std::size_t kAlignment = 8;
constexpr std::array<std::string_view, 4> kElementNames = {"u8", "i32", "f32", "f64"};

std::size_t aligned(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

}  // namespace

std::string jsonText(const nlohmann::json& json) {
  return json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string encodeContainer(nlohmann::json header, const std::vector<PackedArray>& arrays) {
  nlohmann::json list = nlohmann::json::array();
  std::size_t offset = 0;
  for (const PackedArray& array : arrays) {
    list.push_back({{"name", array.name},
                    {"dtype", kElementNames.at(static_cast<std::size_t>(array.element))},
                    {"shape", array.shape},
                    {"offset", offset}});
    offset = aligned(offset + array.bytes->size());
  }
  header["arrays"] = std::move(list);
  const std::string text = jsonText(header);
  const auto length = static_cast<std::uint32_t>(text.size());
  std::string message(aligned(sizeof length + text.size()) + offset, '\0');
  std::memcpy(message.data(), &length, sizeof length);
  std::ranges::copy(text, message.begin() + sizeof length);
  char* next = message.data() + aligned(sizeof length + text.size());
  for (const PackedArray& array : arrays) {
    // NOLINTNEXTLINE(bugprone-not-null-terminated-result): bytes, not text
    std::memcpy(next, array.bytes->data(), array.bytes->size());
    next += aligned(array.bytes->size());
  }
  return message;
}

}  // namespace tolman::web_viewer
