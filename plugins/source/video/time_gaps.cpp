// SPDX-License-Identifier: BSD-3-Clause
#include "time_gaps.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tolman::video {
namespace {

// Cameras that lengthen the exposure in the dark, or drop single pictures, stay below. Chosen, not
// fitted.
constexpr std::int64_t kLongest = 5;  // usual steps

std::string seconds(std::int64_t ns) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3g s", static_cast<double>(ns) * 1e-9);
  return text.data();
}

}  // namespace

void TimeGaps::add(std::int64_t stamp_ns) {
  if (any_) steps_.push_back(stamp_ns - last_);
  last_ = stamp_ns;
  any_ = true;
}

std::string TimeGaps::warning() const {
  if (steps_.empty()) return {};
  std::vector<std::int64_t> sorted = steps_;
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  const auto longest = std::max_element(steps_.begin(), steps_.end());
  if (*middle <= 0 || *longest / *middle < kLongest) return {};
  const auto before = longest - steps_.begin();
  return "pictures " + std::to_string(before) + " and " + std::to_string(before + 1) + " are " +
         seconds(*longest) + " apart, and others " + seconds(*middle) +
         ": if the camera did not pause there, the file is damaged; copy or record it again";
}

}  // namespace tolman::video
