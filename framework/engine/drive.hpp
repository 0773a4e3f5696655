// SPDX-License-Identifier: BSD-3-Clause
// Drives all frames of a source through the stages.
#pragma once

#include <string_view>

#include "config/settings.hpp"
#include "engine/chain.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

/// The clock for the time at which a frame was exposed.
enum class ExposureClock : std::uint8_t {
  Pace,       ///< when a camera that plays the recording at the set speed would have exposed it
  Monotonic,  ///< the stamp, which a live source takes from the machine's monotonic clock
  System,     ///< the stamp, likewise from the system clock (UTC)
};
inline constexpr std::array<std::string_view, 3> kExposureClockNames = {"pace", "monotonic",
                                                                        "system"};
constexpr std::span<const std::string_view> enumNames(ExposureClock) { return kExposureClockNames; }

/// The clock of stamps: those of a live camera if the source does not know its number of frames and
/// the stamp is within the last 5 s of one of the machine's clocks.
ExposureClock exposureClock(bool is_endless, std::int64_t stamp_ns, std::int64_t monotonic_ns,
                            std::int64_t system_ns);

/// Time from the exposure of a frame to its pose in the map, in realtime runs.
struct Latency {
  std::int64_t frames = 0;  ///< number of measured frames; 0 in lossless runs
  double median_ms = 0;
  double p99_ms = 0;
  ExposureClock clock = ExposureClock::Pace;
};

struct DriveResult {
  std::optional<Failure> failure;
  bool interrupted = false;  ///< cancellation ended it early; all frames until then are complete
  RunCounters counters;      ///< also whether odometry was lost at the end
  StageTimes finish_times_ns{};  ///< time that finish() of each stage took
  Latency latency{};             ///< of a realtime run
};

/// The number of threads for a setting `threads` (0: all cores).
int concurrency(int threads);

/// Processes all frames and finishes all stages. Stages are finished also after a failure or a
/// cancellation, to keep the results so far. `threads` bounds the parallelism (0: all cores).
DriveResult drive(Chain& chain, const config::PipelineSettings& options, int threads,
                  const Cancellation& cancellation);

}  // namespace tolman::engine
