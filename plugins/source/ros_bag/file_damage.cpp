// SPDX-License-Identifier: BSD-3-Clause
#include "file_damage.hpp"

namespace tolman::ros_bag {

std::string lostText(const std::map<std::string, LostMessages>& lost) {
  std::string text;
  std::size_t left = lost.size();
  for (const auto& [name, of] : lost) {
    --left;
    if (!text.empty()) text += left == 0 ? " and " : ", ";
    text += std::to_string(of.messages) + (of.messages == 1 ? " message of " : " messages of ") +
            (name.empty() ? "topics that are not known" : name);
  }
  return text;
}

std::string furtherText(std::int64_t count) {
  return count < 2 ? "" : ", and " + std::to_string(count - 1) + " more like it";
}

std::string Repeated::text() const { return first_ + furtherText(count_); }

}  // namespace tolman::ros_bag
