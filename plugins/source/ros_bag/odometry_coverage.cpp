// SPDX-License-Identifier: BSD-3-Clause
#include "odometry_coverage.hpp"

#include <algorithm>
#include <array>
#include <cstdio>

namespace tolman::ros_bag {
namespace {

// Both chosen, not tuned: a few lost messages are bridged by a straight line, a pause is not.
constexpr std::int64_t kHolePeriods = 10;
constexpr std::int64_t kShortestHole_ns = 500'000'000;

std::string secondsText(std::int64_t ns) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.3f s", static_cast<double>(ns) * 1e-9);
  return text.data();
}

/// The lower median of the times between messages that differ; 0 without any.
std::int64_t medianPeriod(const std::vector<std::int64_t>& stamps_ns) {
  std::vector<std::int64_t> periods;
  for (std::size_t i = 1; i < stamps_ns.size(); ++i) {
    if (stamps_ns[i] > stamps_ns[i - 1]) periods.push_back(stamps_ns[i] - stamps_ns[i - 1]);
  }
  if (periods.empty()) return 0;
  const auto middle = periods.begin() + (std::ssize(periods) - 1) / 2;
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle;
}

}  // namespace

OdometryCoverage::OdometryCoverage(std::vector<std::int64_t> stamps_ns)
    : stamps_ns_(std::move(stamps_ns)), period_ns_(medianPeriod(stamps_ns_)) {
  for (std::size_t i = 1; i < stamps_ns_.size(); ++i) {
    const std::int64_t gap = stamps_ns_[i] - stamps_ns_[i - 1];
    if (gap > kShortestHole_ns && gap / kHolePeriods > period_ns_) {
      holes_.push_back({stamps_ns_[i - 1], stamps_ns_[i]});
    }
  }
}

OdometryCoverage::Kind OdometryCoverage::kindOf(std::int64_t one_ns, std::int64_t other_ns) const {
  const auto [begin, end] = std::minmax(one_ns, other_ns);
  if (stamps_ns_.empty() || begin < stamps_ns_.front() || end > stamps_ns_.back()) {
    return Kind::Outside;
  }
  const auto hole = std::ranges::upper_bound(holes_, begin, {}, &Hole::end_ns);
  return hole != holes_.end() && hole->begin_ns < end ? Kind::InHole : Kind::Measured;
}

std::int64_t OdometryCoverage::count(const std::vector<std::int64_t>& frames_ns, Kind kind) const {
  std::int64_t frames = 0;
  for (std::size_t i = 1; i < frames_ns.size(); ++i) {
    if (kindOf(frames_ns[i - 1], frames_ns[i]) == kind) ++frames;
  }
  return frames;
}

bool OdometryCoverage::overlaps(const std::vector<std::int64_t>& frames_ns) const {
  if (stamps_ns_.empty() || frames_ns.empty()) return false;
  const auto [first, last] = std::ranges::minmax(frames_ns);
  return stamps_ns_.front() <= last && stamps_ns_.back() >= first;
}

std::string OdometryCoverage::ranges(const std::vector<std::int64_t>& frames_ns) const {
  if (stamps_ns_.empty() || frames_ns.empty()) return "it has no messages";
  const auto [first, last] = std::ranges::minmax(frames_ns);
  return "its messages are from " + secondsText(stamps_ns_.front()) + " to " +
         secondsText(stamps_ns_.back()) + ", the images from " + secondsText(first) + " to " +
         secondsText(last);
}

/// "no message for 3.600 s from 12.000 s on (usual period 0.100 s), and 2 more such holes"
std::string OdometryCoverage::holesText() const {
  const Hole& first = holes_.front();
  std::string text = "no message for " + secondsText(first.end_ns - first.begin_ns) + " from " +
                     secondsText(first.begin_ns) + " on (usual period " + secondsText(period_ns_) +
                     ")";
  if (holes_.size() > 1) text += ", and " + std::to_string(holes_.size() - 1) + " more such holes";
  return text;
}

std::vector<std::string> OdometryCoverage::problems(
    const std::vector<std::int64_t>& frames_ns) const {
  std::vector<std::string> texts;
  const auto without = [&](std::int64_t frames) {
    return ": " + std::to_string(frames) + " of " + std::to_string(frames_ns.size()) +
           " frames have no measured motion, and motion_replay reports them as lost";
  };
  if (const std::int64_t frames = count(frames_ns, Kind::Outside); frames > 0) {
    texts.push_back(ranges(frames_ns) + without(frames) + "; check the clocks, or use the images " +
                    "within these times (first, last)");
  }
  if (const std::int64_t frames = count(frames_ns, Kind::InHole); frames > 0) {
    texts.push_back(holesText() + without(frames) + "; record it again, or use the images " +
                    "before or after (first, last)");
  }
  return texts;
}

}  // namespace tolman::ros_bag
