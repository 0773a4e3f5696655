// SPDX-License-Identifier: BSD-3-Clause
// How often a part occurs in a text, overlaps included.
#pragma once

#include <string>

namespace tolman::test {

inline int countOf(const std::string& text, const std::string& part) {
  int n = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
  return n;
}

}  // namespace tolman::test
