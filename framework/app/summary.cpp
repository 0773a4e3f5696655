// SPDX-License-Identifier: BSD-3-Clause
#include "app/summary.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>
#include <numbers>
#include <vector>

#include "app/program.hpp"
#include "record/run_directory.hpp"

namespace tolman::app {
namespace {

std::string errorText(const char* name, const evaluation::Statistics& error,
                      const std::string& unit) {
  if (error.count == 0) return "";
  return fmt::format("{} error median {:.1f}, 90 % {:.1f} {}", name, error.median, error.p90, unit);
}

/// "1 link", "2 links".
std::string counted(std::int64_t number, std::string_view thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

}  // namespace

std::string trajectoryText(std::string_view name, const evaluation::TrajectoryMetrics& metrics) {
  std::string text = fmt::format("{:<10}path {:.2f} {} over {} poses", name, metrics.path_length_m,
                                 metrics.in_metres ? "m" : "units of unknown scale", metrics.poses);
  if (!metrics.scores) return text + fmt::format("; no error figures: {}\n", metrics.reason);
  const evaluation::Scores& s = *metrics.scores;
  text += fmt::format("; {} with truth; coverage {:.1f} %\n", metrics.matched, 100 * s.coverage);
  text +=
      fmt::format("{:<10}ATE rmse {:.3f} m  (mean {:.3f}, median {:.3f}, min {:.3f}, max {:.3f})\n",
                  "", s.ate_m.rmse, s.ate_m.mean, s.ate_m.median, s.ate_m.min, s.ate_m.max);
  if (!metrics.warning.empty()) text += row("", "WARNING " + metrics.warning);
  if (s.vertical_m.count > 0) {
    text += row("", fmt::format("horizontal rmse {:.3f} m, vertical rmse {:.3f} m",
                                s.horizontal_m.rmse, s.vertical_m.rmse));
  } else if (!s.no_horizontal.empty()) {
    text += row("", "horizontal and vertical error: " + s.no_horizontal);
  }
  if (s.kitti.segments > 0) {
    const std::string left_out =
        s.kitti.segments_in_gaps == 0
            ? ""
            : fmt::format("; {} that end in gaps are left out", s.kitti.segments_in_gaps);
    text += fmt::format("{:<10}drift {:.3f} %, {:.3f} deg/100 m  ({} segments, {} lengths{})\n", "",
                        s.kitti.t_rel_percent, s.kitti.r_rel_deg_per_100m, s.kitti.segments,
                        s.kitti.lengths.name, left_out);
  }
  return text;
}

std::string bodyText(const evaluation::Extrinsic& body) {
  const double degrees = Eigen::AngleAxisd(body.R).angle() * 180 / std::numbers::pi;
  return row("body", "the truth is measured at " + evaluation::armText(body) +
                         (degrees > 0 ? fmt::format(", turned by {:.2f} degrees", degrees) : ""));
}

std::string cellsText(const evaluation::CellFigures& cells) {
  std::vector<std::string> parts;
  for (const evaluation::PopulationFigures& ring : cells.rings) {
    parts.push_back(errorText("heading", ring.error_deg, "deg"));
  }
  if (!cells.reason.empty()) parts.push_back("no errors: " + cells.reason);
  std::erase(parts, "");
  return parts.empty() ? "" : fmt::format("{:<10}{}\n", "cells", fmt::join(parts, "; "));
}

std::string healthText(const engine::Outcome& outcome) {
  const engine::RunCounters& n = outcome.counters;
  std::string text =
      fmt::format("{:<10}{} of {} frames, {} initialising, {} lost{}\n", "tracking", n.tracked(),
                  n.frames, n.initialising, n.lost, n.lost_at_end ? "; lost at the end" : "");
  if (!n.endText().empty()) text += fmt::format("{:<10}{}\n", "", n.endText());
  text += fmt::format("{:<10}{} processed, {} dropped, {} skipped, {} without image\n", "frames",
                      n.frames, n.dropped, n.skipped, n.defects);
  text +=
      fmt::format("{:<10}{}, {}, {}, of them {} ({})\n", "memory", counted(n.templates, "template"),
                  counted(n.experiences, "experience"), counted(n.links, "link"),
                  counted(n.loop_links, "loop link"), counted(n.loop_decisions, "loop decision"));
  const double rate = outcome.wall_s > 0 ? static_cast<double>(n.frames) / outcome.wall_s : 0;
  text += fmt::format("{:<10}{}, {:.1f} frames/s", "time", durationText(outcome.wall_s), rate);
  const std::int64_t last_ns = outcome.finish_times_ns[static_cast<std::size_t>(Role::Map)];
  text += fmt::format("; final optimisation of the map {}\n",
                      durationText(1e-9 * static_cast<double>(last_ns)));
  if (outcome.latency.frames == 0) return text;
  return text + fmt::format("{:<10}image to pose median {:.1f} ms, 99 % {:.1f} ms\n", "latency",
                            outcome.latency.median_ms, outcome.latency.p99_ms);
}

namespace {

/// Alignment, coverage, ATE, drift, for odometry and map, cells, and time per stage.
std::string figuresText(const evaluation::Metrics& metrics) {
  std::string text = fmt::format("{:<10}mean: ", "stages");
  for (const auto& [stage, timing] : metrics.timing) {
    text += fmt::format("{} {:.2f} ms  ", stage, timing.mean_ms);
  }
  text += "\n";
  if (metrics.sessions.size() > 1 || metrics.parts > 1) {
    const std::string unjoined = evaluation::unjoinedText(metrics);
    text += fmt::format("{:<10}{}; {}\n", "sessions", metrics.sessions.size(),
                        unjoined.empty() ? "all parts of the map are joined" : unjoined);
  }
  text += row("alignment", evaluation::alignmentText(metrics));
  if (metrics.body) text += bodyText(*metrics.body);
  text += trajectoryText("odometry", metrics.odometry) + trajectoryText("map", metrics.map);
  return metrics.cells ? text + cellsText(*metrics.cells) : text;
}

/// One line for each verdict.
std::string verdictsText(const evaluation::Metrics& metrics) {
  std::string text;
  for (const std::string& verdict : evaluation::verdictsOf(metrics)) {
    text += row(text.empty() ? "verdict" : "", verdict);
  }
  return text;
}

}  // namespace

ExitCode printOutcome(const engine::Outcome& outcome, const Invocation& invocation) {
  const std::filesystem::path& directory = outcome.directory;
  if (invocation.json && !directory.empty()) {
    nlohmann::ordered_json json = record::RunDirectory::readRunFile(directory);
    json["directory"] = directory.string();
    if (outcome.metrics) json["metrics"] = evaluation::toJson(*outcome.metrics);
    std::cout << jsonText(json);
  } else if (!invocation.quiet && !directory.empty()) {
    if (outcome.metrics) std::cout << verdictsText(*outcome.metrics);
    std::cout << healthText(outcome) << fmt::format("{:<10}{}\n", "run", directory.string());
    if (outcome.metrics) {
      std::cout << figuresText(*outcome.metrics)
                << fmt::format("{:<10}{}\n", "report", (directory / "report.html").string());
    }
  }
  if (outcome.failure) return printFailure(exitCode(outcome), outcome.failure->message);
  const ExitCode code = exitCode(outcome);
  if (invocation.quiet && code == ExitCode::TrackingLost) std::cerr << healthText(outcome);
  return code;
}

}  // namespace tolman::app
