// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "config/text.hpp"
#include "experiment/comparison.hpp"

namespace tolman::experiment {
namespace {

/// Text, then a metric; the last part has no metric.
struct CellPart {
  std::string text{};
  std::string metric{};
  std::string format{};  ///< "{:.2f}"
};

Result<std::vector<CellPart>> partsOf(const std::string& cell) {
  std::vector<CellPart> parts(1);
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] != '{') {
      parts.back().text += cell[i];
      continue;
    }
    const auto end = cell.find('}', i);
    if (end == std::string::npos) return Status::invalidParameter("'" + cell + "': '}' is missing");
    const std::string field = cell.substr(i + 1, end - i - 1);
    const auto colon = std::min(field.find(':'), field.size());
    parts.back().metric = field.substr(0, colon);
    parts.back().format = "{" + field.substr(colon) + "}";
    parts.emplace_back();
    i = end;
  }
  return parts;
}

/// The text of a cell, with means over its runs; a dash for a metric that one of them lacks.
Result<std::string> filled(const std::vector<CellPart>& parts, const RunPointers& runs) {
  std::string text;
  for (const CellPart& part : parts) {
    text += part.text;
    if (part.metric.empty()) continue;
    double sum = 0;
    const bool is_known = std::ranges::all_of(runs, [&](const RunRow* run) {
      const auto found = run->metrics.find(part.metric);
      if (found == run->metrics.end()) return false;
      sum += found->second;
      return true;
    });
    try {
      text += is_known
                  ? fmt::format(fmt::runtime(part.format), sum / static_cast<double>(runs.size()))
                  : "-";
    } catch (const fmt::format_error& error) {
      return Status::invalidParameter("'" + part.format + "': " + error.what());
    }
  }
  return text;
}

class Pivot {
 public:
  Pivot(const std::vector<RunRow>& rows, const PivotOptions& options)
      : rows_of_runs_(rows), options_(options) {}

  Result<Table> table() {
    const Result<Names> by = fullFactors(rows_of_runs_, options_.by);
    const Result<Names> over = fullFactors(rows_of_runs_, options_.over);
    const Result<Names> columns =
        fullFactors(rows_of_runs_, options_.values.empty() ? Names{options_.columns} : Names());
    for (const Result<Names>* names : {&by, &over, &columns}) {
      if (!names->isOk()) return names->status();
    }
    by_ = by.value();
    averaged_ = over.value();
    averaged_.emplace_back("seed");
    if (!columns.value().empty()) across_ = columns.value().front();
    for (const std::string& name : factorNames(rows_of_runs_)) {
      if (options_.by.empty() && !isAveraged(name) && name != across_) by_.push_back(name);
    }
    fill();
    Table table{{fmt::format("{}", fmt::join(by_, ", "))}, {}};
    for (const Column& column : columns_) table.heading.push_back(column.heading);
    for (const auto& [label, cell] : options_.heads) rows_.push_back({label, levels_[0], cell});
    for (const std::string& level : levels_) rows_.push_back({level, level, ""});
    for (const Row& row : rows_) {
      std::vector<std::string>& cells = table.rows.emplace_back(1, row.label);
      for (const Column& column : columns_) {
        const Result<std::string> cell = cellOf(row, column);
        if (!cell.isOk()) return cell.status();
        cells.push_back(cell.value());
      }
    }
    std::set<std::size_t> sizes;
    for (const auto& [place, runs] : cells_) sizes.insert(runs.size());
    if (sizes.size() > 1) {
      table.notes.push_back(fmt::format("Cells are means of different numbers of runs, {} to {}.",
                                        *sizes.begin(), *sizes.rbegin()));
    }
    return table;
  }

 private:
  using Names = std::vector<std::string>;
  struct Column {
    std::string heading;
    std::string label;  ///< of the factor of the columns
    std::string cell;
  };
  struct Row {
    std::string label;
    std::string level;
    std::string cell;  ///< empty: that of the column
  };

  bool isAveraged(const std::string& factor) const {
    return std::ranges::find(averaged_, factor) != averaged_.end();
  }

  /// Levels and columns are in the order of their first occurrence.
  void fill() {
    for (const auto& [heading, cell] : options_.values) columns_.push_back({heading, "", cell});
    for (const RunRow& run : rows_of_runs_) {
      const std::string level = levelName(run, by_);
      const std::string label = run.label(across_);
      if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
      cells_[{level, label}].push_back(&run);
      const bool is_known = std::ranges::find(columns_, label, &Column::label) != columns_.end();
      if (options_.values.empty() && !is_known) columns_.push_back({label, label, options_.cell});
    }
  }

  /// Empty if there are no such runs.
  Result<std::string> cellOf(const Row& row, const Column& column) const {
    const auto parts = partsOf(row.cell.empty() ? column.cell : row.cell);
    if (!parts.isOk()) return parts.status();
    Names metrics;
    for (const CellPart& part : parts.value()) {
      if (part.metric.empty()) continue;
      metrics.push_back(part.metric);
      const bool is_known = std::ranges::any_of(
          rows_of_runs_, [&](const RunRow& run) { return run.metrics.contains(part.metric); });
      if (!is_known) {
        return Status::invalidParameter("no run has the metric '" + part.metric + "'");
      }
    }
    const auto runs = cells_.find({row.level, column.label});
    if (runs == cells_.end()) return std::string();
    Status status = oneKind(runs->second);
    if (status.isOk()) status = refuseMixtures(runs->second, metrics, options_.mixed_coverage);
    if (!status.isOk()) return status;
    return filled(parts.value(), runs->second);
  }

  /// Ok if the runs of a cell differ only in factors over which it is a mean.
  Status oneKind(const RunPointers& runs) const {
    const RunRow& first = *runs.front();
    for (const RunRow* run : runs) {
      for (const RunRow* with : {run, &first}) {  // either may have factors that the other lacks
        for (const auto& [name, label] : with->factors) {
          if (isAveraged(name) || run->label(name) == first.label(name)) continue;
          return Status::invalidInput("'" + first.name + "' and '" + run->name +
                                      "' would be one cell; name '" + name +
                                      "' with --by, --only or --over");
        }
      }
    }
    return Status::ok();
  }

  const std::vector<RunRow>& rows_of_runs_;
  const PivotOptions& options_;
  Names by_;
  Names averaged_;
  std::string across_;  ///< factor of the columns; empty for none
  std::vector<Column> columns_;
  std::vector<Row> rows_;
  Names levels_;
  std::map<std::pair<std::string, std::string>, RunPointers> cells_;  ///< by level and column
};

}  // namespace

Result<Table> pivotOf(const std::vector<RunRow>& rows, const PivotOptions& options) {
  Result<std::vector<RunRow>> wanted = selectRuns(rows, options.only);
  if (!wanted.isOk()) return wanted.status();
  const Result<std::string> repeated = mergeRepeats(wanted.value());
  if (!repeated.isOk()) return repeated.status();
  Result<Table> table = Pivot(wanted.value(), options).table();
  if (!table.isOk()) return table;
  std::vector<std::string>& notes = table.value().notes;
  std::ranges::move(trackingNotes(wanted.value()), std::back_inserter(notes));
  if (!repeated.value().empty()) notes.push_back(repeated.value());
  return table;
}

}  // namespace tolman::experiment
