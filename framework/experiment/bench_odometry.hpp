// SPDX-License-Identifier: BSD-3-Clause
// Measures the cost of source and odometry relative to decoding the same images by cv::imread.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "experiment/bench.hpp"

namespace tolman::bench {

struct OdometryBench {
  std::string name;
  std::string source;  ///< as the source describes itself
  int threads = 0;     ///< of the odometry passes
  /// Passes of both kinds alternate, so that other load on the machine affects both.
  std::vector<BenchPass> decoding;  ///< cv::imread of all images, on one thread
  std::vector<BenchPass> odometry;  ///< source and odometry, overlapping as in a run
  bool interrupted = false;         ///< the passes listed are complete
};

/// The source must read image files; see ImageFiles. Throws run::Failed.
OdometryBench runOdometryBench(const run::SystemOptions& system, const BenchOptions& options,
                               run::RunLog& log, const Cancellation& cancellation);

/// Time of the odometry passes over that of the decoding passes.
struct TimeRatio {
  double best = 0;    ///< least over least
  double median = 0;  ///< median over median
};
TimeRatio timeRatio(const OdometryBench& bench, double BenchPass::*time);

std::string odometryBenchText(const OdometryBench& bench);
nlohmann::ordered_json odometryBenchJson(const OdometryBench& bench);

}  // namespace tolman::bench
