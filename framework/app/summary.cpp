// SPDX-License-Identifier: BSD-3-Clause
#include "app/summary.hpp"

#include <fmt/format.h>

namespace tolman::app {

std::string trajectoryText(std::string_view name, const evaluation::TrajectoryMetrics& metrics) {
  std::string text =
      fmt::format("{:<10}path {:.2f} m over {} poses", name, metrics.path_length_m, metrics.poses);
  if (!metrics.scores) return text + fmt::format("; no error figures: {}\n", metrics.reason);
  const evaluation::Scores& s = *metrics.scores;
  text += fmt::format("; matched {} ({:.1f} % of the truth)\n", metrics.matched, 100 * s.coverage);
  text +=
      fmt::format("{:<10}ATE rmse {:.3f} m  (mean {:.3f}, median {:.3f}, min {:.3f}, max {:.3f})\n",
                  "", s.ate_m.rmse, s.ate_m.mean, s.ate_m.median, s.ate_m.min, s.ate_m.max);
  if (s.kitti.segments > 0) {
    text += fmt::format("{:<10}drift {:.3f} %, {:.3f} deg/100 m  ({} segments, {} lengths)\n", "",
                        s.kitti.t_rel_percent, s.kitti.r_rel_deg_per_100m, s.kitti.segments,
                        s.kitti.lengths.name);
  }
  return text;
}

std::string healthText(const pipeline::Outcome& outcome, double wall_seconds) {
  const pipeline::Counters& n = outcome.counters;
  std::string text =
      fmt::format("{:<10}{} processed, {} dropped, {} skipped, {} without image, {} lost\n",
                  "frames", n.frames, n.dropped, n.skipped, n.defects, n.lost);
  text += fmt::format("{:<10}{} templates, {} experiences, {} links, {} loop{}\n", "memory",
                      n.templates, n.experiences, n.links, n.loops, n.loops == 1 ? "" : "s");
  const double rate = wall_seconds > 0 ? static_cast<double>(n.frames) / wall_seconds : 0;
  text += fmt::format("{:<10}{:.1f} s, {:.1f} frames/s", "time", wall_seconds, rate);
  const std::int64_t last_ns = outcome.finish_times_ns[static_cast<std::size_t>(Role::Map)];
  return text +
         fmt::format("; the map's last work {:.2f} s\n", 1e-9 * static_cast<double>(last_ns));
}

std::string figuresText(const evaluation::Metrics& metrics) {
  std::string text = fmt::format("{:<10}mean: ", "stages");
  for (const auto& [stage, timing] : metrics.timing) {
    text += fmt::format("{} {:.2f} ms  ", stage, timing.mean_ms);
  }
  text += "\n";
  if (metrics.sessions.size() > 1 || metrics.parts > 1) {
    const std::string unjoined = evaluation::unjoinedText(metrics);
    text += fmt::format("{:<10}{}; {}\n", "sessions", metrics.sessions.size(),
                        unjoined.empty() ? "all of the map hangs together" : unjoined);
  }
  text += fmt::format("{:<10}{}\n", "alignment", enumName(metrics.alignment));
  return text + trajectoryText("odometry", metrics.odometry) + trajectoryText("map", metrics.map);
}

}  // namespace tolman::app
