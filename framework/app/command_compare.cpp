// SPDX-License-Identifier: BSD-3-Clause
// tolman compare: tables and figures of many runs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <memory>

#include "app/output_files.hpp"
#include "app/path_kind.hpp"
#include "app/program.hpp"
#include "config/named_value.hpp"
#include "experiment/comparison_figure.hpp"
#include "experiment/run_pivot.hpp"
#include "experiment/tables.hpp"
#include "record/data_files.hpp"
#include "record/output_places.hpp"
#include "report/raster.hpp"

namespace tolman::app {
namespace {

/// The ending of a file in small letters, with its point.
std::string endingOf(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
  return ending;
}

struct CompareCommand {
  std::vector<std::string> runs;
  std::vector<std::string> only;
  experiment::ComparisonOptions options;
  std::string format;  ///< empty: markdown, with --json json
  std::string out;
  std::vector<std::string> figures;
  std::string kind = "auto";
  experiment::PivotOptions pivot;
  std::vector<std::string> heads;
  std::vector<std::string> values;
  bool replace = false;
};

template <class Table>
std::string textOf(const Table& table, const std::string& format) {
  if (format == "json") return experiment::jsonOf(table);
  if (format == "latex") return experiment::latexOf(table);
  return format == "csv" ? experiment::csvOf(table) : experiment::markdownOf(table);
}

/// "a=b" as a pair; `option` for the message.
std::pair<std::string, std::string> pairOf(const std::string& text, const char* option) {
  const auto equals = text.find('=');
  if (equals != std::string::npos) return {text.substr(0, equals), text.substr(equals + 1)};
  throw Ended{ExitCode::Usage, std::string("write ") + option};
}

std::string bytesOf(const std::string& svg, const std::string& file) {
  if (endingOf(file) == ".png") return valueOrEnd(report::pngOf(svg, 4));
  return endingOf(file) == ".pdf" ? valueOrEnd(report::pdfOf(svg)) : svg;
}

std::string comparisonText(CompareCommand& command, const std::vector<experiment::RunRow>& rows,
                           std::vector<record::OutputFile>& files) {
  if (!command.pivot.columns.empty() || !command.values.empty()) {
    command.pivot.by = command.options.by;
    command.pivot.only = command.options.only;
    command.pivot.mixed_coverage = command.options.mixed_coverage;
    if (command.pivot.cell.empty()) command.pivot.cell = "{" + command.options.metric + ":.3g}";
    for (const std::string& head : command.heads) {
      command.pivot.heads.push_back(pairOf(head, "--head LABEL=CELL"));
    }
    for (const std::string& value : command.values) {
      command.pivot.values.push_back(pairOf(value, "--value HEADING=CELL"));
    }
    return textOf(valueOrEnd(experiment::pivotOf(rows, command.pivot)), command.format);
  }
  const auto comparison = valueOrEnd(experiment::compareRuns(rows, command.options));
  const auto kind = config::valueNamed<experiment::FigureKind>(command.kind);
  for (const std::string& file : command.figures) {
    const std::string svg = valueOrEnd(experiment::comparisonFigure(comparison, *kind));
    files.push_back({file, bytesOf(svg, file)});
  }
  return textOf(comparison, command.format);
}

/// Refuses options that would have no effect.
void refuseUnused(const CompareCommand& command) {
  const bool has_cells = !command.pivot.columns.empty() || !command.values.empty();
  if (has_cells && !command.figures.empty()) {
    throw Ended{ExitCode::Usage, "--figure is drawn of statistics, not with --columns or --value"};
  }
  const bool cell_options = !command.pivot.cell.empty() || !command.heads.empty();
  if (command.pivot.columns.empty() && cell_options) {
    throw Ended{ExitCode::Usage, "--cell and --head are of tables with --columns"};
  }
  if (!has_cells && !command.pivot.over.empty()) {
    throw Ended{ExitCode::Usage, "--over is of tables with --columns or --value"};
  }
}

/// Whether a file is one of those that are compared, or lies in a run or in the folder of one.
/// Files beside the runs of a sweep are free, but for its own two.
bool isOfInput(const std::filesystem::path& file, const std::filesystem::path& input) {
  if (!record::isInside(file, input)) return false;
  std::error_code ignored;
  const std::filesystem::path below = file.lexically_relative(input);
  const bool is_sweep = std::filesystem::is_directory(input, ignored) &&
                        !std::filesystem::exists(input / "run.json", ignored);
  const bool is_beside_runs = std::distance(below.begin(), below.end()) == 1;
  const bool is_own = below == "points.txt" || below == "data.json" || below == "results.csv";
  return !is_sweep || !is_beside_runs || is_own;
}

/// Refuses to write over the runs and tables that are compared.
void refuseInputs(const CompareCommand& command) {
  std::vector<std::string> files = command.figures;
  if (!command.out.empty()) files.push_back(command.out);
  for (const std::string& file : files) {
    for (const std::string& run : command.runs) {
      if (!isOfInput(record::truePath(file), record::truePath(run))) continue;
      throw Ended{ExitCode::Usage,
                  fmt::format("{}: belongs to {}, which is compared; choose a file outside of it",
                              file, run)};
    }
  }
}

/// Refuses one file for two outputs, and figures of other formats.
void refuseFiles(const CompareCommand& command) {
  std::vector<std::filesystem::path> files;
  if (!command.out.empty()) files.emplace_back(command.out);
  for (const std::string& figure : command.figures) {
    const std::string ending = endingOf(figure);
    if (ending != ".svg" && ending != ".pdf" && ending != ".png") {
      throw Ended{ExitCode::Usage, figure + ": figures are .svg, .pdf or .png"};
    }
    files.emplace_back(figure);
  }
  for (std::filesystem::path& file : files) file = record::truePath(file);
  std::ranges::sort(files);
  const auto twice = std::ranges::adjacent_find(files);
  if (twice == files.end()) return;
  throw Ended{ExitCode::Usage, twice->string() + ": is given for two outputs; give each its own"};
}

void compare(CompareCommand& command, const Invocation& invocation) {
  refuseUnused(command);
  refuseFiles(command);
  refuseInputs(command);
  refuseExisting({command.figures.begin(), command.figures.end()}, command.replace, "--figure");
  if (!command.out.empty()) refuseExisting({command.out}, command.replace, "--out");
  for (const std::string& run : command.runs) {
    requireKind(run, {PathKind::Run, PathKind::Sweep, PathKind::Table, PathKind::Folder},
                "a run directory, the folder of a sweep, or a table", ExitCode::Dataset);
  }
  if (command.format.empty()) command.format = invocation.json ? "json" : "markdown";
  for (const std::string& only : command.only) {
    command.options.only.push_back(pairOf(only, "--only FACTOR=LABEL"));
  }
  const auto rows = valueOrEnd(experiment::readRunRows({command.runs.begin(), command.runs.end()}));
  if (rows.empty()) throw Ended{ExitCode::Dataset, "no run is done"};
  for (const std::string& folder : command.runs) {
    const std::string text = experiment::unfinishedText(folder);
    if (!text.empty()) std::cerr << "warning: " + text + "\n";
  }
  std::vector<record::OutputFile> files;
  const std::string table = comparisonText(command, rows, files);
  if (!command.out.empty()) files.push_back({command.out, table});
  requireOrEnd(record::writeTogether(files, command.out.empty() ? "--figure" : "--out"));
  if (command.out.empty()) {
    std::cout << table;
    return;
  }
  std::vector<std::filesystem::path> written;
  written.reserve(files.size());
  for (const record::OutputFile& file : files) written.push_back(file.path);
  printFiles(written, invocation);
}

void addPivotOptions(CLI::App& command, CompareCommand& options) {
  command
      .add_option("--columns", options.pivot.columns,
                  "A column for each level of this factor, instead of statistics")
      ->type_name("FACTOR")
      ->check(notEmpty);
  command
      .add_option("--value", options.values,
                  "A column of these cells, instead of statistics (repeatable)")
      ->type_name("HEADING=FORMAT")
      ->allow_extra_args(false)
      ->excludes("--columns");
  command
      .add_option("--over", options.pivot.over,
                  "Cells of --columns and --value are means over this factor, and over seeds")
      ->type_name("FACTOR")
      ->allow_extra_args(false);
  command
      .add_option("--cell", options.pivot.cell,
                  "Text of the cells with metrics in braces: '{map.ate.rmse_m:.2f}'")
      ->type_name("FORMAT");
  command
      .add_option(
          "--head", options.heads,
          "A row before the others, with another cell, of the runs of the first (repeatable)")
      ->type_name("LABEL=FORMAT")
      ->allow_extra_args(false);
}

void addFigureOptions(CLI::App& command, CompareCommand& options) {
  command
      .add_option("--figure", options.figures, "Figure to write, .svg, .pdf or .png (repeatable)")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->check(notEmpty);
  command
      .add_option("--kind", options.kind,
                  "Of the figure: line over numbers, box of names (auto); success curve; position "
                  "error over distance; maps over the true path")
      ->type_name("auto|line|box|success|distance|maps")
      ->check(CLI::IsMember(std::vector<std::string>(experiment::kFigureKindNames.begin(),
                                                     experiment::kFigureKindNames.end())));
}

}  // namespace

void addCompareCommand(CLI::App& app, Invocation& invocation) {
  CLI::App* command =
      app.add_subcommand("compare", "Tables and figures of a metric over the runs of a sweep");
  auto options = std::make_shared<CompareCommand>();
  command
      ->add_option("runs", options->runs,
                   "Folder of a sweep, run directories, or tables of `sweep collect` (.csv)")
      ->type_name("RUN")
      ->required();
  command
      ->add_option("--metric", options->options.metric,
                   "Key of metrics.json, or its end (default: map.ate.rmse_m)")
      ->type_name("KEY");
  command
      ->add_option(
          "--by", options->options.by,
          "Factor whose levels are compared (repeatable; default: all but sequence and seed)")
      ->type_name("FACTOR")
      ->allow_extra_args(false);
  command
      ->add_option("--only", options->only,
                   "Only runs with this label (repeatable; labels of one factor are alternatives)")
      ->type_name("FACTOR=LABEL")
      ->allow_extra_args(false);
  command
      ->add_option("--baseline", options->options.baseline, "Level that the others are paired with")
      ->type_name("LABEL");
  command->add_flag("--mixed-coverage", options->options.mixed_coverage,
                    "Average runs that cover different shares of the truth");
  command
      ->add_option("--format", options->format,
                   "Of the table (default: markdown, with --json json)")
      ->type_name("markdown|latex|csv|json")
      ->check(CLI::IsMember({"markdown", "latex", "csv", "json"}));
  command->add_option("--out", options->out, "File for the table (default: standard output)")
      ->type_name("FILE")
      ->check(notEmpty);
  addForce(*command, options->replace, "Replace the files of --out and --figure");
  addPivotOptions(*command, *options);
  addFigureOptions(*command, *options);
  command->callback([options, &invocation] { compare(*options, invocation); });
}

}  // namespace tolman::app
