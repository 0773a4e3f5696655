// SPDX-License-Identifier: BSD-3-Clause
// tolman compare: tables and figures of many runs.

#include <iostream>

#include "app/options.hpp"
#include "experiment/comparison.hpp"
#include "record/atomic_file.hpp"
#include "record/digest.hpp"
#include "report/svg.hpp"

namespace tolman::app {
namespace {

struct CompareCommand {
  std::vector<std::string> runs;
  std::vector<std::string> only;
  experiment::ComparisonOptions options;
  std::string format;  ///< empty: markdown, with --json json
  Output out;
  std::vector<std::string> figures;
  bool maps = false;
  experiment::PivotOptions pivot;
  std::vector<std::string> heads;
  std::vector<std::string> values;
};

std::string textOf(const experiment::Table& table, const std::string& format) {
  if (format == "json") return experiment::jsonOf(table);
  if (format == "latex") return experiment::latexOf(table);
  return format == "csv" ? experiment::csvOf(table) : experiment::markdownOf(table);
}

std::string bytesOf(const std::string& svg, const std::string& file) {
  if (file.ends_with(".png")) return valueOf(report::pngOf(svg, 4));
  return file.ends_with(".pdf") ? valueOf(report::pdfOf(svg)) : svg;
}

/// Of the figures that are written.
std::string isFigure(const std::string& file) {
  const bool is_known = file.ends_with(".svg") || file.ends_with(".pdf") || file.ends_with(".png");
  return is_known ? "" : file + ": figures are .svg, .pdf or .png";
}

std::string comparisonText(CompareCommand& command, const std::vector<experiment::RunRow>& rows,
                           std::vector<record::OutputFile>& files) {
  if (!command.pivot.columns.empty() || !command.values.empty()) {
    command.pivot.by = command.options.by;
    command.pivot.only = command.options.only;
    if (command.pivot.cell.empty()) command.pivot.cell = "{" + command.options.metric + ":.3g}";
    for (const std::string& head : command.heads) {
      command.pivot.heads.push_back(sidesOf(head));
    }
    for (const std::string& value : command.values) {
      command.pivot.values.push_back(sidesOf(value));
    }
    return textOf(valueOf(experiment::pivotOf(rows, command.pivot)), command.format);
  }
  const auto comparison = valueOf(experiment::compareRuns(rows, command.options));
  for (const std::string& file : command.figures) {
    const std::string svg = command.maps ? valueOf(experiment::mapsFigure(comparison))
                                         : experiment::levelsFigure(comparison);
    files.push_back({file, bytesOf(svg, file)});
  }
  return textOf(experiment::tableOf(comparison), command.format);
}

void compare(CompareCommand& command, const Invocation& invocation) {
  refuseExisting({command.figures.begin(), command.figures.end()}, command.out.replace, "--figure");
  if (!command.out.path.empty()) {
    refuseExisting({command.out.path}, command.out.replace, "--out");
  }
  if (!command.pivot.over.empty() && command.pivot.columns.empty() && command.values.empty()) {
    fail(ExitCode::Usage, "--over is of --columns or --value; give one of them");
  }
  if (command.format.empty()) command.format = invocation.json ? "json" : "markdown";
  for (const std::string& only : command.only) {
    command.options.only.push_back(sidesOf(only));
  }
  const auto rows = valueOf(experiment::readRunRows({command.runs.begin(), command.runs.end()}));
  if (rows.empty()) fail(ExitCode::Dataset, "no run is done");
  for (const std::string& folder : command.runs) {
    const std::string text = experiment::unfinishedText(folder);
    if (!text.empty()) std::cerr << "warning: " + text + "\n";
  }
  std::vector<record::OutputFile> files;
  const std::string table = comparisonText(command, rows, files);
  const bool to_file = !command.out.path.empty();
  if (to_file) files.push_back({command.out.path, table});
  failUnless(record::writeOutputs(files));
  if (!to_file) {
    std::cout << table;
    return;
  }
  std::vector<std::filesystem::path> written;
  for (const record::OutputFile& file : files) written.push_back(file.path);
  printFiles(written, invocation);
}

void addPivotOptions(CLI::App& command, CompareCommand& options) {
  CLI::Option* columns = addOption(command, "--columns", options.pivot.columns, "FACTOR",
                                   "A column for each level of this factor, instead of statistics");
  columns->check(notEmpty)->excludes("--figure");
  addList(command, "--value", options.values, "HEADING=FORMAT",
          "A column of these cells, instead of statistics (repeatable)")
      ->check(isAssignment)
      ->excludes("--figure")
      ->excludes(columns);
  addList(command, "--over", options.pivot.over, "FACTOR",
          "Cells of --columns and --value are means over this factor, and over seeds");
  addOption(command, "--cell", options.pivot.cell, "FORMAT",
            "Text of the cells with metrics in braces: '{map.ate.rmse_m:.2f}'")
      ->needs(columns);
  addList(command, "--head", options.heads, "LABEL=FORMAT",
          "A row before the others, with another cell, of the runs of the first (repeatable)")
      ->check(isAssignment)
      ->needs(columns);
}

}  // namespace

void addCompareCommand(CLI::App& app, Invocation& invocation) {
  CLI::App& command =
      *app.add_subcommand("compare", "Tables and figures of a metric over the runs of a sweep");
  auto options = std::make_shared<CompareCommand>();
  addArgument(command, "runs", options->runs, "RUN",
              "Folder of a sweep, run directories, or tables of `sweep collect` (.csv)");
  addOption(command, "--metric", options->options.metric, "KEY",
            "Key of metrics.json, or its end (default: map.ate.rmse_m)");
  addList(command, "--by", options->options.by, "FACTOR",
          "Factor whose levels are compared (repeatable; default: all but sequence and seed)");
  addList(command, "--only", options->only, "FACTOR=LABEL",
          "Only runs with this label (repeatable; labels of one factor are alternatives)")
      ->check(isAssignment);
  addOption(command, "--baseline", options->options.baseline, "LABEL",
            "Level that the others are paired with");
  addChoice(command, "--format", options->format, {"markdown", "latex", "csv", "json"},
            "Of the table (default: markdown, with --json json)");
  options->out.add(command, "FILE", "File for the table (default: standard output)",
                   "Replace the files of --out and --figure");
  addList(command, "--figure", options->figures, "FILE",
          "Figure to write, .svg, .pdf or .png (repeatable)")
      ->check(isFigure);
  addPivotOptions(command, *options);
  command.add_flag("--maps", options->maps,
                   "The figure has the maps over the true path, not the metric over the factor");
  command.callback([options, &invocation] { compare(*options, invocation); });
}

}  // namespace tolman::app
