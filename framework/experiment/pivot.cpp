// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

#include "base/must.hpp"
#include "config/text.hpp"
#include "experiment/comparison.hpp"

namespace tolman::experiment {
namespace {

[[noreturn]] void refuseCell(const std::string& what, const std::string& why) {
  throw Refused{Status::invalidParameter("'" + what + "': " + why)};
}

/// The text of a cell. `valueOf` gives that of a metric in braces, with a format such as "{:.2f}".
template <class ValueOf>
std::string filled(const std::string& cell, ValueOf&& valueOf) {
  std::string text;
  for (std::size_t i = 0; i < cell.size(); ++i) {
    if (cell[i] != '{') {
      text += cell[i];
      continue;
    }
    const auto end = cell.find('}', i);
    if (end == std::string::npos) refuseCell(cell, "'}' is missing");
    const std::string field = cell.substr(i + 1, end - i - 1);
    const auto colon = std::min(field.find(':'), field.size());
    text += valueOf(field.substr(0, colon), "{" + field.substr(colon) + "}");
    i = end;
  }
  return text;
}

/// The mean of a metric; a dash where one of the runs lacks it.
std::string meanText(const std::string& metric, const std::string& format,
                     const RunPointers& runs) {
  double sum = 0;
  for (const RunRow* run : runs) {
    const auto found = run->metrics.find(metric);
    if (found == run->metrics.end()) return "-";
    sum += found->second;
  }
  try {
    return fmt::format(fmt::runtime(format), sum / static_cast<double>(runs.size()));
  } catch (const fmt::format_error& error) {
    refuseCell(format, error.what());
  }
}

class Pivot {
 public:
  Pivot(const std::vector<RunRow>& rows, const PivotOptions& options)
      : runs_(rows), options_(options) {}

  Table table() {
    by_ = fullFactors(runs_, options_.by);
    averaged_ = fullFactors(runs_, options_.over);
    averaged_.emplace_back("seed");
    if (options_.values.empty()) across_ = fullFactors(runs_, {options_.columns}).front();
    for (const std::string& name : factorNames(runs_)) {
      if (options_.by.empty() && !isAveraged(name) && name != across_) by_.push_back(name);
    }
    fill();
    Table table{{fmt::format("{}", fmt::join(by_, ", "))}, {}};
    for (const Column& column : columns_) table.heading.push_back(column.heading);
    for (const auto& [label, cell] : options_.heads) rows_.push_back({label, levels_[0], cell});
    for (const std::string& level : levels_) rows_.push_back({level, level, ""});
    for (const Row& row : rows_) {
      std::vector<std::string>& cells = table.rows.emplace_back(1, row.label);
      for (const Column& column : columns_) cells.push_back(cellOf(row, column));
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
    for (const RunRow& run : runs_) {
      const std::string level = levelName(run, by_);
      const std::string label = run.label(across_);
      if (std::ranges::find(levels_, level) == levels_.end()) levels_.push_back(level);
      cells_[{level, label}].push_back(&run);
      const bool is_known = std::ranges::find(columns_, label, &Column::label) != columns_.end();
      if (options_.values.empty() && !is_known) columns_.push_back({label, label, options_.cell});
    }
  }

  /// Empty if there are no such runs.
  std::string cellOf(const Row& row, const Column& column) const {
    const std::string& cell = row.cell.empty() ? column.cell : row.cell;
    Names metrics;
    (void)filled(cell, [&](const std::string& metric, const std::string&) {
      const auto has = [&](const RunRow& run) { return run.metrics.contains(metric); };
      if (std::ranges::none_of(runs_, has)) {
        must(Status::invalidParameter("no run has the metric '" + metric + "'"));
      }
      return metrics.emplace_back(metric);
    });
    const auto runs = cells_.find({row.level, column.label});
    if (runs == cells_.end()) return "";
    refuseOtherKinds(runs->second);
    refuseMixtures(runs->second, metrics);
    return filled(cell, [&](const std::string& metric, const std::string& format) {
      return meanText(metric, format, runs->second);
    });
  }

  /// The runs of a cell may differ only in factors over which it is a mean.
  void refuseOtherKinds(const RunPointers& runs) const {
    const RunRow& first = *runs.front();
    for (const RunRow* run : runs) {
      for (const RunRow* with : {run, &first}) {  // either may have factors that the other lacks
        for (const auto& [name, label] : with->factors) {
          if (isAveraged(name) || run->label(name) == first.label(name)) continue;
          must(Status::invalidInput("'" + first.name + "' and '" + run->name +
                                    "' would be one cell; name '" + name +
                                    "' with --by, --only or --over"));
        }
      }
    }
  }

  const std::vector<RunRow>& runs_;
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
  return resultOf([&] {
    std::vector<RunRow> wanted = selectRuns(rows, options.only);
    const std::string repeated = mergeRepeats(wanted);
    Table table = Pivot(wanted, options).table();
    std::ranges::move(trackingNotes(wanted), std::back_inserter(table.notes));
    if (!repeated.empty()) table.notes.push_back(repeated);
    return table;
  });
}

}  // namespace tolman::experiment
