// SPDX-License-Identifier: BSD-3-Clause
#include "mp4_boxes.hpp"

namespace tolman::video {
namespace {

constexpr std::uint64_t kBoxHeader = 8;       // size and type
constexpr std::uint64_t kLongBoxHeader = 16;  // with a size of 8 bytes

/// The box at `begin`; nullopt if none can be there.
std::optional<Box> boxAt(ContainerBytes& file, std::uint64_t begin, std::uint64_t end) {
  const auto size = file.number(begin, 4);
  const auto type = file.number(begin + 4, 4);
  if (!size || !type) return std::nullopt;
  Box box{static_cast<std::uint32_t>(*type), begin, begin + kBoxHeader, end};
  std::uint64_t length = *size;
  if (length == 0) return box;  // to the end
  if (length == 1) {
    const auto long_size = file.number(box.content, 8);
    if (!long_size || *long_size < kLongBoxHeader) return std::nullopt;
    length = *long_size;
    box.content = begin + kLongBoxHeader;
  }
  if (length < kBoxHeader || length > end - begin) return std::nullopt;
  box.end = begin + length;
  return box;
}

}  // namespace

std::string nameOf(const Box& box) {
  std::string name = "'";
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    const auto letter = static_cast<char>((box.type >> shift) & 0xffU);
    name += letter >= ' ' && letter <= '~' ? letter : '?';
  }
  return name + "' at byte " + std::to_string(box.begin);
}

std::string visitBoxes(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                       const std::function<std::string(const Box&)>& visit) {
  while (begin < end) {
    const std::optional<Box> box = boxAt(file, begin, end);
    if (!box) return "is damaged at byte " + std::to_string(begin) + ": no whole box begins there";
    if (std::string defect = visit(*box); !defect.empty()) return defect;
    begin = box->end;
  }
  return {};
}

std::optional<Box> findBox(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                           std::uint32_t type) {
  std::optional<Box> found;
  visitBoxes(file, begin, end, [&](const Box& box) -> std::string {
    if (box.type != type) return {};
    found = box;
    return "found";  // ends the search
  });
  return found;
}

std::optional<Box> findBox(ContainerBytes& file, Box box,
                           std::initializer_list<std::string_view> path) {
  for (const std::string_view letters : path) {
    const auto inner = findBox(file, box.content, box.end, boxType(letters));
    if (!inner) return std::nullopt;
    box = *inner;
  }
  return box;
}

}  // namespace tolman::video
