// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>

#include "experiment/bench_odometry.hpp"

namespace tolman::bench {
namespace {

struct Times {
  double least = 0;
  double median = 0;
};

/// Seconds per frame.
Times timesOf(const std::vector<BenchPass>& passes, double BenchPass::*time) {
  std::vector<double> times;
  for (const BenchPass& pass : passes) {
    if (pass.frames > 0) times.push_back(pass.*time / static_cast<double>(pass.frames));
  }
  if (times.empty()) return {};
  std::sort(times.begin(), times.end());
  return {times.front(), 0.5 * (times[(times.size() - 1) / 2] + times[times.size() / 2])};
}

std::string odometryPassesText(std::string_view what, const std::vector<BenchPass>& passes) {
  std::string text;
  int repeat = 0;
  for (const BenchPass& pass : passes) {
    const double to_ms = 1e3 / static_cast<double>(std::max<std::int64_t>(pass.frames, 1));
    text += fmt::format("{:<20}{:>6}{:>8}{:>10.2f}{:>10.2f}{:>10.0f}\n", what, ++repeat,
                        pass.frames, pass.cpu_s * to_ms, pass.seconds * to_ms, pass.peak_mib);
  }
  return text;
}

nlohmann::ordered_json odometryPassesJson(const std::vector<BenchPass>& passes) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const BenchPass& pass : passes) {
    list.push_back({{"frames", pass.frames},
                    {"cpu_seconds", pass.cpu_s},
                    {"wall_seconds", pass.seconds},
                    {"peak_mib", pass.peak_mib}});
  }
  return list;
}

nlohmann::ordered_json ratioJson(const TimeRatio& ratio) {
  return {{"best", ratio.best}, {"median", ratio.median}};
}

}  // namespace

TimeRatio timeRatio(const OdometryBench& bench, double BenchPass::*time) {
  const Times decoding = timesOf(bench.decoding, time);
  const Times odometry = timesOf(bench.odometry, time);
  if (!(decoding.least > 0)) return {};
  return {odometry.least / decoding.least, odometry.median / decoding.median};
}

std::string odometryBenchText(const OdometryBench& bench) {
  std::string text = fmt::format("{}: {}\n", bench.name, bench.source);
  text += fmt::format("{:<20}{:>6}{:>8}{:>10}{:>10}{:>10}\n", "ms a frame", "repeat", "frames",
                      "CPU", "wall", "peak MiB");
  text += odometryPassesText("cv::imread alone", bench.decoding);
  text += odometryPassesText("source and odometry", bench.odometry);
  const TimeRatio cpu = timeRatio(bench, &BenchPass::cpu_s);
  const TimeRatio wall = timeRatio(bench, &BenchPass::seconds);
  return text + fmt::format("\n{:<20}{:>34}{:>10}\n", "ratio", "CPU", "wall") +
         fmt::format("{:<20}{:>34.2f}{:>10.2f}\n", "best over best", cpu.best, wall.best) +
         fmt::format("{:<20}{:>34.2f}{:>10.2f}\n", "median over median", cpu.median, wall.median) +
         fmt::format("cv::imread on one thread, source and odometry on {}\n", bench.threads);
}

nlohmann::ordered_json odometryBenchJson(const OdometryBench& bench) {
  return {{"name", bench.name},
          {"source", bench.source},
          {"threads", bench.threads},
          {"interrupted", bench.interrupted},
          {"decoding_passes", odometryPassesJson(bench.decoding)},
          {"odometry_passes", odometryPassesJson(bench.odometry)},
          {"cpu_ratio", ratioJson(timeRatio(bench, &BenchPass::cpu_s))},
          {"wall_ratio", ratioJson(timeRatio(bench, &BenchPass::seconds))}};
}

}  // namespace tolman::bench
