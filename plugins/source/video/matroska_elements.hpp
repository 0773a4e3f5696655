// SPDX-License-Identifier: BSD-3-Clause
// The elements of a Matroska or WebM file (RFC 8794, section 5): identifier, size, content.
#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "container_bytes.hpp"

namespace tolman::video {

struct Element {
  std::uint32_t id = 0;
  std::uint64_t begin = 0;    ///< byte of the file
  std::uint64_t content = 0;  ///< byte behind identifier and size
  std::uint64_t end = 0;      ///< byte behind the element; of its parent if `endless`
  bool endless = false;       ///< its size is not known, as of a live recording
};

/// A number of variable length and how many bytes it takes, 0 if none is there.
struct VariableNumber {
  std::uint64_t value = 0;
  unsigned bytes = 0;
  bool unknown = false;  ///< all bits are set: a size that is not known
};
VariableNumber variableNumber(ContainerBytes& file, std::uint64_t at);

/// What visitElements() does after an element.
enum class Next : std::uint8_t { Continue, Enter };

/// Calls `visit(element, defect)` for each element from `begin` to `end`, and for the content of
/// one after which it says Enter. Returns the first defect, or what is wrong with a header.
std::string visitElements(ContainerBytes& file, std::uint64_t begin, std::uint64_t end,
                          const std::function<Next(const Element&, std::string&)>& visit);

/// The number that an element has as its content.
std::uint64_t numberOf(ContainerBytes& file, const Element& element);

}  // namespace tolman::video
