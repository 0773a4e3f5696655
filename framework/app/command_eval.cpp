// SPDX-License-Identifier: BSD-3-Clause
// tolman eval: errors of trajectory files against the truth.
#include <fmt/format.h>

#include <iostream>

#include "app/eval_scoring.hpp"
#include "app/options.hpp"
#include "app/summary.hpp"
#include "evaluation/trajectory.hpp"
#include "experiment/tables.hpp"
#include "record/atomic_file.hpp"
#include "report/axes.hpp"

namespace tolman::app {
namespace {

using evaluation::Statistics;
using Json = nlohmann::ordered_json;

struct EvalFiles {
  std::string truth;
  std::vector<std::string> estimates;
  std::string figure;
  bool replace = false;
  EvalOptions options;
};

void warn(const std::string& text, const Invocation& invocation) {
  if (!invocation.quiet) std::cerr << "warning: " + text + "\n";
}

std::string figuresOf(const Statistics& s, const std::string& unit) {
  return fmt::format("rmse {:.4f} {}, mean {:.4f}, median {:.4f}, max {:.4f}", s.rmse, unit, s.mean,
                     s.median, s.max);
}

std::string detailsText(const Evaluated& found) {
  const evaluation::Scores& scores = *found.metrics.scores;
  std::string text;
  if (scores.rotation_deg.count > 0) {
    text += row("", "rotation " + figuresOf(scores.rotation_deg, "deg"));
  }
  for (std::size_t i = 0; i < scores.steps.size(); ++i) {
    const evaluation::RelativeError& error = scores.steps[i];
    text += row(i == 0 ? "steps" : "",
                fmt::format("{}, {} pairs: {}", evaluation::textOf(found.protocol.steps[i]),
                            error.translation_m.count, figuresOf(error.translation_m, "m")));
    text += row("", "  rotation " + figuresOf(error.rotation_deg, "deg"));
  }
  for (const evaluation::SegmentMean& mean : scores.kitti.table) {
    if (mean.segments == 0) continue;
    text += row(&mean == scores.kitti.table.data() ? "segments" : "",
                fmt::format("{:>5g} m  {:.3f} %, {:.3f} deg/100 m  ({})", mean.length_m,
                            mean.t_rel_percent, mean.r_rel_deg_per_100m, mean.segments));
  }
  if (scores.path) {
    text +=
        row("path", fmt::format("without time: {}; Hausdorff distance {:.4f} m",
                                figuresOf(scores.path->to_truth_m, "m"), scores.path->hausdorff_m));
  }
  for (const evaluation::TrajectoryMetrics& part : found.parts) {
    text += trajectoryText(fmt::format("part {}", &part - found.parts.data() + 1), part);
  }
  return text;
}

std::string textOf(const Evaluated& found) {
  const evaluation::AlignmentRule& rule = found.protocol.alignment;
  std::string text = row("alignment", std::string(enumName(rule.kind)));
  const double scale = found.metrics.scores->scale;
  if (scale != 1) text += row("scale", fmt::format("{:.6f}", scale));
  if (found.clock) {
    text += row("clock", fmt::format("{:.4f} +- {:.4f} s added to the stamps of the estimate",
                                     found.clock->seconds, found.clock->sigma));
  }
  if (found.body) text += bodyText(*found.body);
  return text + trajectoryText("estimate", found.metrics) + detailsText(found);
}

Json jsonOf(const Evaluated& found) {
  Json json = evaluation::toJson(found.metrics);
  json.update(evaluation::detailsJson(*found.metrics.scores, found.protocol.steps));
  json["alignment"] = enumName(found.protocol.alignment.kind);
  if (found.clock) {
    json["clock"] = {{"offset_s", found.clock->seconds}, {"sigma_s", found.clock->sigma}};
  }
  if (found.body) json["body"] = evaluation::toJson(*found.body);
  for (const auto& part : found.parts) json["parts"].push_back(evaluation::toJson(part));
  return json;
}

/// One line per estimate.
std::string tableOf(const std::vector<std::string>& names, const std::vector<Evaluated>& all) {
  experiment::Table table{
      {"estimate", "ATE rmse", "mean", "max", "drift %", "deg/100m", "scale", "coverage", ""}, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    const evaluation::Scores& s = *all[i].metrics.scores;
    const auto text = [](double value) { return fmt::format("{:.3f}", value); };
    const bool known = s.kitti.segments > 0;
    const std::string& warning = all[i].metrics.warning;
    table.rows.push_back({names[i], text(s.ate_m.rmse), text(s.ate_m.mean), text(s.ate_m.max),
                          known ? text(s.kitti.t_rel_percent) : "-",
                          known ? text(s.kitti.r_rel_deg_per_100m) : "-",
                          fmt::format("{:.4f}", s.scale), fmt::format("{:.1f} %", 100 * s.coverage),
                          warning.empty() ? "" : "WARNING"});
    if (!warning.empty()) table.notes.push_back(names[i] + ": WARNING " + warning);
  }
  return experiment::textOf(table);
}

void writeFigure(const EvalFiles& files, const std::vector<Evaluated>& all) {
  std::vector<report::Curve> curves;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const evaluation::Scores& scores = *all[i].metrics.scores;
    curves.push_back({std::filesystem::path(files.estimates[i]).filename().string(),
                      report::lineColour(i), scores.pairs.driven,
                      evaluation::positionErrors(scores)});
  }
  const auto free = report::Range::none();
  const std::string svg = report::curveFigure(
      {"Position error after alignment", "driven path (m)", "error (m)", free, free, {}}, curves,
      {880, 380});
  failUnless(record::writeOutputs({{files.figure, svg}}));
}

void evaluateAll(const EvalFiles& files, const Invocation& invocation) {
  if (!files.figure.empty()) refuseExisting({files.figure}, files.replace, "--figure");
  const auto read = [&](const std::string& file) {
    return valueOf(evaluation::readTrajectory(file, files.options.readsMatrices()),
                   ExitCode::Dataset);
  };
  const auto truth = read(files.truth);
  std::vector<Evaluated> all;
  for (const std::string& name : files.estimates) {
    const auto estimate = read(name);
    const Evaluated& found =
        all.emplace_back(evaluate(files.options, truth, estimate, files.truth, name));
    for (const std::string& text : found.warnings) warn(text, invocation);
    if (found.metrics.matched * 20 < std::min(truth.size(), estimate.size())) {
      warn(fmt::format("{}: only {} of {} poses have a true pose at their time; are both stamps in "
                       "seconds, and of one clock?",
                       name, found.metrics.matched, estimate.size()),
           invocation);
    }
  }
  if (!files.figure.empty()) writeFigure(files, all);
  if (all.size() == 1) {
    std::cout << (invocation.json ? jsonText(jsonOf(all[0])) : textOf(all[0]));
    return;
  }
  if (!invocation.json) {
    std::cout << tableOf(files.estimates, all);
    return;
  }
  Json json;
  for (std::size_t i = 0; i < all.size(); ++i) json[files.estimates[i]] = jsonOf(all[i]);
  std::cout << jsonText(json);
}

}  // namespace

void addEvalCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command = *app.add_subcommand(
      "eval", "Score trajectories (TUM, KITTI, EuRoC or CSV files) against the truth");
  auto files = std::make_shared<EvalFiles>();
  addArgument(command, "truth", files->truth, "FILE", "True trajectory");
  addArgument(command, "estimate", files->estimates, "FILE...", "Estimated trajectories");
  files->options.addTo(command);
  addOption(command, "--figure", files->figure, "FILE", "Draw the errors over the path (SVG)");
  command.add_flag("--force", files->replace, "Replace FILE of --figure");
  command.callback([files, &invocation] { evaluateAll(*files, invocation); });
}

}  // namespace tolman::app
