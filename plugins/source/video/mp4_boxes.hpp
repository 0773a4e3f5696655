// SPDX-License-Identifier: BSD-3-Clause
// The boxes of an MP4 or MOV file (ISO/IEC 14496-12, section 4.2): size, type, content.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "container_bytes.hpp"

namespace tolman::video {

/// The number that four letters are in a file.
constexpr std::uint32_t boxType(std::string_view letters) {
  std::uint32_t type = 0;
  for (const char letter : letters) type = (type << 8U) | static_cast<std::uint8_t>(letter);
  return type;
}

struct Box {
  std::uint32_t type = 0;
  std::uint64_t begin = 0;    ///< byte of the file
  std::uint64_t content = 0;  ///< byte behind the header
  std::uint64_t end = 0;      ///< byte behind the box
};

/// "'moof' at byte 1234", with letters of ASCII only.
std::string nameOf(const Box& box);

/// Calls `visit` for each box from `begin` to `end`, until it returns a defect. Returns that, or
/// what is wrong with a header.
std::string visitBoxes(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                       const std::function<std::string(const Box&)>& visit);

/// The first box of a type between two bytes; nullopt if there is none.
std::optional<Box> findBox(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                           std::uint32_t type);
/// The same along a path of boxes, from within `box`.
std::optional<Box> findBox(ContainerBytes& file, Box box,
                           std::initializer_list<std::string_view> path);

}  // namespace tolman::video
