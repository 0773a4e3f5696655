// SPDX-License-Identifier: BSD-3-Clause
// Measures an odometry against decoding its images: how much more time than looking at the data
// does it take to know the motion?
#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <variant>
#include <vector>

#include "app/bench.hpp"

namespace tolman::app {

/// What one drive through the data took.
struct DrivePass {
  std::int64_t frames = 0;
  double wall_s = 0;
  double cpu_s = 0;  ///< of all threads of the process
  double peak_mib = 0;
};

struct OdometryBench {
  std::string name;
  std::string source;  ///< as the source describes itself
  int threads = 0;     ///< that source and odometry had
  /// Pass i of each kind one after the other, so that a busy machine is busy for both.
  std::vector<DrivePass> decoding;  ///< cv::imread of all images, on one thread
  std::vector<DrivePass> odometry;  ///< source and odometry side by side
  bool interrupted = false;         ///< the passes that are here are whole
};

/// The source must have the parameter `yardstick`.
std::variant<OdometryBench, Failure> runOdometryBench(const SystemOptions& system,
                                                      const BenchOptions& options, RunLog& log,
                                                      const Cancellation& cancellation);

/// Time of the odometry passes over that of the decoding passes.
struct TimeRatio {
  double best = 0;    ///< least over least
  double median = 0;  ///< median over median
};
TimeRatio timeRatio(const OdometryBench& bench, double DrivePass::*time);

std::string odometryBenchText(const OdometryBench& bench);
nlohmann::ordered_json odometryBenchJson(const OdometryBench& bench);

}  // namespace tolman::app
