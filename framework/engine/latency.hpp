// SPDX-License-Identifier: BSD-3-Clause
// Time from the exposure of a frame to its pose in the map, in realtime runs.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace tolman::pipeline {

/// The clock for the time at which a frame was exposed.
enum class ExposureClock : std::uint8_t {
  Pace,       ///< when a camera that plays the recording at the set speed would have exposed it
  Monotonic,  ///< the stamp, which a live source takes from the machine's monotonic clock
  System,     ///< the stamp, likewise from the system clock (UTC)
};
inline constexpr std::string_view kExposureClockNames[] = {"pace", "monotonic", "system"};
constexpr std::string_view enumName(ExposureClock clock) {
  return kExposureClockNames[static_cast<std::size_t>(clock)];
}

/// Chooses the clock. Stamps are those of a live camera if the source does not know its number of
/// frames and the stamp is within the last 5 s of one of the machine's clocks.
inline ExposureClock exposureClock(bool is_endless, std::int64_t stamp_ns,
                                   std::int64_t monotonic_ns, std::int64_t system_ns) {
  constexpr std::int64_t kRecent = 5'000'000'000;  // ns
  const auto recent = [&](std::int64_t now) { return stamp_ns <= now && now - stamp_ns < kRecent; };
  if (is_endless && recent(monotonic_ns)) return ExposureClock::Monotonic;
  return is_endless && recent(system_ns) ? ExposureClock::System : ExposureClock::Pace;
}

struct Latency {
  std::int64_t frames = 0;  ///< number of measured frames; 0 in lossless runs
  double median_ms = 0;
  double p99_ms = 0;
  ExposureClock clock = ExposureClock::Pace;
};

/// Collects the latency of each frame; needs 4 bytes per frame.
class LatencyMeter {
 public:
  void add(std::chrono::nanoseconds latency) {
    all_ms_.push_back(std::chrono::duration<float, std::milli>(latency).count());
  }

  /// Median and 99th percentile: the smallest value that 50 % and 99 % of the frames do not exceed.
  Latency result(ExposureClock clock) {
    if (all_ms_.empty()) return {};
    return {static_cast<std::int64_t>(all_ms_.size()), percentile(50), percentile(99), clock};
  }

 private:
  double percentile(std::size_t percent) {
    const std::size_t rank = (all_ms_.size() * percent + 99) / 100;
    const auto at = all_ms_.begin() + static_cast<std::ptrdiff_t>(rank) - 1;
    std::nth_element(all_ms_.begin(), at, all_ms_.end());
    return static_cast<double>(*at);
  }

  std::vector<float> all_ms_;
};

}  // namespace tolman::pipeline
