// SPDX-License-Identifier: BSD-3-Clause
// tolman compare: tables and figures of many runs.
#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "app/program.hpp"
#include "experiment/comparison_figure.hpp"
#include "experiment/comparison_text.hpp"
#include "record/atomic_file.hpp"
#include "report/raster.hpp"

namespace tolman::app {
namespace {

struct CompareCommand {
  std::vector<std::string> runs;
  std::vector<std::string> only;
  experiment::ComparisonOptions options;
  std::string format = "markdown";
  std::string out;
  std::string figure;
};

std::string tableOf(const experiment::Comparison& comparison, const std::string& format) {
  if (format == "latex") return experiment::latexOf(comparison);
  return format == "csv" ? experiment::csvOf(comparison) : experiment::markdownOf(comparison);
}

void compare(CompareCommand& command, const Invocation& invocation) {
  for (const std::string& only : command.only) {
    const auto equals = only.find('=');
    if (equals == std::string::npos) throw Ended{ExitCode::Usage, "write --only FACTOR=LABEL"};
    command.options.only.emplace_back(only.substr(0, equals), only.substr(equals + 1));
  }
  const auto rows = valueOrEnd(experiment::readRunRows({command.runs.begin(), command.runs.end()}));
  if (rows.empty()) throw Ended{ExitCode::Dataset, "no run is done"};
  const auto comparison = valueOrEnd(experiment::compareRuns(rows, command.options));
  std::vector<std::filesystem::path> written;
  if (!command.figure.empty()) {
    std::string picture = experiment::comparisonFigure(comparison);
    if (command.figure.ends_with(".png")) picture = valueOrEnd(report::pngOf(picture, 4));
    requireOrEnd(record::writeAtomically(command.figure, picture));
    written.emplace_back(command.figure);
  }
  const std::string table = tableOf(comparison, command.format);
  if (command.out.empty()) {
    std::cout << table;
    return;
  }
  requireOrEnd(record::writeAtomically(command.out, table));
  written.emplace_back(command.out);
  printFiles(written, invocation);
}

}  // namespace

void addCompareCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("compare", "Tables and figures of a metric over the runs of a sweep");
  auto options = std::make_shared<CompareCommand>();
  command->add_option("runs", options->runs, "Folder of a sweep, or run directories")
      ->type_name("RUN")
      ->required();
  command
      ->add_option("--metric", options->options.metric,
                   "Key of metrics.json, or its end (default: map.ate.rmse_m)")
      ->type_name("KEY");
  command->add_option("--by", options->options.by, "Factor whose levels are compared (repeatable)")
      ->type_name("FACTOR")
      ->allow_extra_args(false);
  command->add_option("--only", options->only, "Only runs with this label (repeatable)")
      ->type_name("FACTOR=LABEL")
      ->allow_extra_args(false);
  command
      ->add_option("--baseline", options->options.baseline, "Level that the others are paired with")
      ->type_name("LABEL");
  command->add_flag("--mixed-coverage", options->options.mixed_coverage,
                    "Average runs that cover different shares of the truth");
  command->add_option("--format", options->format, "Of the table (default: markdown)")
      ->type_name("markdown|latex|csv")
      ->check(CLI::IsMember({"markdown", "latex", "csv"}));
  command->add_option("--out", options->out, "File for the table (default: standard output)")
      ->type_name("FILE")
      ->check(notEmpty);
  command->add_option("--figure", options->figure, "Figure to write, .svg or .png")
      ->type_name("FILE")
      ->check(notEmpty);
  command->callback([options, &invocation] { compare(*options, invocation); });
}

}  // namespace tolman::app
