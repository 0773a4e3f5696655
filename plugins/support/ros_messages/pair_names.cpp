// SPDX-License-Identifier: BSD-3-Clause
#include "pair_names.hpp"

#include <algorithm>
#include <cctype>

namespace tolman::ros_messages {

bool isPair(const std::string& left, const std::string& right) {
  if (const auto at = left.find("left"); at != std::string::npos) {
    for (auto from = at; from != std::string::npos; from = left.find("left", from + 1)) {
      std::string other = left;
      if (other.replace(from, 4, "right") == right) return true;
    }
  }
  if (left.size() != right.size()) return false;
  const auto [a, b] = std::mismatch(left.begin(), left.end(), right.begin());
  if (a == left.end() || std::isdigit(static_cast<unsigned char>(*a)) == 0) return false;
  return *b == *a + 1 && *b <= '9' && std::equal(a + 1, left.end(), b + 1);
}

std::optional<CameraNames> chooseCameraNames(const std::vector<std::string>& cameras,
                                             const CameraNames& named, bool mono) {
  CameraNames chosen = named;
  if (named.left.empty() && named.right.empty() && cameras.size() == 1) chosen.left = cameras[0];
  std::vector<CameraNames> pairs;
  for (const std::string& left : cameras) {
    for (const std::string& right : cameras) {
      const bool fits = (chosen.left.empty() || chosen.left == left) &&
                        (chosen.right.empty() || chosen.right == right);
      if (fits && isPair(left, right)) pairs.push_back({left, right});
    }
  }
  const bool complete = !chosen.left.empty() && (!chosen.right.empty() || mono || pairs.empty());
  if (!complete && pairs.size() != 1) return std::nullopt;
  if (!complete) chosen = pairs.front();
  if (mono) chosen.right.clear();
  return chosen;
}

std::string infoBeside(const std::string& images) {
  std::string folder = images;
  if (folder.ends_with("/compressed")) folder.erase(folder.rfind('/'));
  return folder.substr(0, folder.rfind('/')) + "/camera_info";
}

}  // namespace tolman::ros_messages
