// SPDX-License-Identifier: BSD-3-Clause
#include "matroska_elements.hpp"

#include <bit>

namespace tolman::video {
namespace {

/// The element at `begin`, of size 0 if none can be there.
Element elementAt(ContainerBytes& file, std::uint64_t begin, std::uint64_t end) {
  Element element{0, begin, begin, begin};
  const auto first = static_cast<std::uint8_t>(file.number(begin, 1).value_or(0));
  const auto id_bytes = static_cast<unsigned>(std::countl_zero(first)) + 1;
  if (id_bytes > sizeof(element.id)) return element;
  const auto id = file.number(begin, id_bytes);
  const VariableNumber size = variableNumber(file, begin + id_bytes);
  if (!id || size.bytes == 0) return element;
  element.id = static_cast<std::uint32_t>(*id);
  element.content = begin + id_bytes + size.bytes;
  element.endless = size.unknown;
  if (element.content > end || (!size.unknown && size.value > end - element.content)) {
    return element;
  }
  element.end = size.unknown ? end : element.content + size.value;
  return element;
}

}  // namespace

VariableNumber variableNumber(ContainerBytes& file, std::uint64_t at) {
  const auto first = static_cast<std::uint8_t>(file.number(at, 1).value_or(0));
  const auto bytes = static_cast<unsigned>(std::countl_zero(first)) + 1;
  const auto all = bytes <= 8 ? file.number(at, bytes) : std::nullopt;
  if (!all) return {};
  const std::uint64_t marker = std::uint64_t{1} << (7 * bytes);
  const std::uint64_t value = *all & (marker - 1);
  return {value, bytes, value == marker - 1};
}

std::string visitElements(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                          const std::function<Next(const Element&, std::string&)>& visit) {
  while (begin < end) {
    const Element element = elementAt(file, begin, end);
    if (element.end == begin) {
      return "is damaged at byte " + std::to_string(begin) + ": no whole element begins there";
    }
    std::string defect;
    const Next next = visit(element, defect);
    if (!defect.empty()) return defect;
    begin = next == Next::Enter ? element.content : element.end;
  }
  return {};
}

std::uint64_t numberOf(ContainerBytes& file, const Element& element) {
  const std::uint64_t size = element.end - element.content;
  return size > 8 ? 0 : file.number(element.content, static_cast<unsigned>(size)).value_or(0);
}

}  // namespace tolman::video
