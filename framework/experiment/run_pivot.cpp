// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/run_pivot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <map>
#include <optional>

#include "config/text.hpp"
#include "experiment/averaging.hpp"

namespace tolman::experiment {
namespace {

using Runs = RunPointers;

constexpr int kWidest = 100;  // characters of a number

/// Text, then a metric; the last part has no metric.
struct CellPart {
  std::string text;
  std::string metric;
  std::string format;  ///< "{:.2f}"
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

/// Whether a format has a width or a number of digits above kWidest, which would need too much
/// memory.
bool isTooWide(const std::string& format) {
  constexpr std::string_view kDigits = "0123456789";
  for (std::size_t i = 0; (i = format.find_first_of(kDigits, i)) != std::string::npos;) {
    const std::size_t end = std::min(format.find_first_not_of(kDigits, i), format.size());
    int number = 0;
    const auto read = std::from_chars(&format[i], &format[i] + (end - i), number);
    if (read.ec != std::errc{} || number > kWidest) return true;
    i = end;
  }
  return false;
}

std::optional<double> meanOf(const Runs& runs, const std::string& metric) {
  double sum = 0;
  for (const RunRow* run : runs) {
    const auto found = run->metrics.find(metric);
    if (found == run->metrics.end()) return std::nullopt;
    sum += found->second;
  }
  return sum / static_cast<double>(runs.size());
}

/// The text of a cell; a dash for a metric that a run does not have.
std::string filled(const std::vector<CellPart>& parts, const Runs& runs) {
  std::string text;
  for (const CellPart& part : parts) {
    text += part.text;
    if (part.metric.empty()) continue;
    const auto mean = meanOf(runs, part.metric);
    text += mean ? fmt::format(fmt::runtime(part.format), *mean) : "-";
  }
  return text;
}

bool isAveraged(const std::string& factor, const PivotOptions& options) {
  return factor == "seed" || std::ranges::find(options.over, factor) != options.over.end();
}

/// Ok if the runs of a cell differ only in factors over which it is a mean, and may be averaged.
Status oneKind(const Runs& runs, const PivotOptions& options) {
  if (Status status = refuseMixtures(runs, options.mixed_coverage); !status.isOk()) return status;
  const RunRow& first = *runs.front();
  for (const RunRow* run : runs) {
    for (const RunRow* with : {run, &first}) {  // either may have factors that the other lacks
      for (const Factor& factor : with->factors) {
        if (isAveraged(factor.name, options)) continue;
        if (run->label(factor.name) == first.label(factor.name)) continue;
        return Status::invalidInput("'" + first.name + "' and '" + run->name +
                                    "' would be one cell; name '" + factor.name +
                                    "' with --by, --only or --over");
      }
    }
  }
  return isAveraged("sequence", options) ? refuseCopies(runs) : Status::ok();
}

/// Levels in the order of their first occurrence.
struct Levels {
  std::vector<std::string> labels;
  void add(const std::string& label) {
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  }
};

class Pivot {
 public:
  Pivot(const std::vector<RunRow>& rows, const PivotOptions& options)
      : options_(options), runs_(pointersTo(rows)) {}

  Result<TextTable> table() {
    Status status = chooseFactors();
    LevelNames names;
    for (const RunRow* run : runs_) {
      if (status.isOk()) status = names.add(*run, by_);
      columns_.add(run->label(options_.columns));
      levels_.add(levelOf(*run));
      cells_[{levelOf(*run), run->label(options_.columns)}].push_back(run);
    }
    noteUnevenCells();
    if (!options_.values.empty()) return valueTable(status);
    table_.heading = {heading()};
    table_.heading.insert(table_.heading.end(), columns_.labels.begin(), columns_.labels.end());
    for (const auto& [label, cell] : options_.heads) {
      if (status.isOk()) status = addRow(label, levels_.labels.front(), cell);
    }
    for (const std::string& level : levels_.labels) {
      if (status.isOk()) status = addRow(level, level, options_.cell);
    }
    if (!status.isOk()) return status;
    return std::move(table_);
  }

 private:
  /// A table with one row per level; each column shows another text about all runs of the level.
  Result<TextTable> valueTable(Status status) {
    table_.heading = {heading()};
    for (const auto& [head, cell] : options_.values) table_.heading.push_back(head);
    for (const std::string& level : levels_.labels) {
      std::vector<std::string> row = {level};
      for (const auto& [head, cell] : options_.values) {
        if (!status.isOk()) return status;
        status = addCell(row, cell, cells_.find({level, ""}));
      }
      table_.rows.push_back(std::move(row));
    }
    if (!status.isOk()) return status;
    return std::move(table_);
  }

  /// Where runs failed, cells are means of fewer runs than others, possibly of other sequences.
  void noteUnevenCells() {
    std::size_t least = SIZE_MAX;
    std::size_t most = 0;
    for (const auto& [place, runs] : cells_) {
      least = std::min(least, runs.size());
      most = std::max(most, runs.size());
    }
    if (least >= most) return;
    table_.notes.push_back(
        fmt::format("Cells are means of different numbers of runs, {} to {}.", least, most));
  }

  std::string heading() const {
    std::string text;
    for (const std::string& factor : by_) text += (text.empty() ? "" : ", ") + factor;
    return text;
  }

  Status chooseFactors() {
    if (runs_.empty()) return Status::invalidParameter("no run is left to compare");
    std::vector<std::string> names;
    for (const Factor& factor : runs_.front()->factors) names.push_back(factor.name);
    std::vector<std::string> wanted = options_.by;
    wanted.insert(wanted.end(), options_.over.begin(), options_.over.end());
    if (options_.values.empty()) wanted.push_back(options_.columns);
    for (const std::string& name : wanted) {
      if (std::ranges::find(names, name) != names.end()) continue;
      return Status::invalidParameter("no factor '" + name + "'" + config::didYouMean(name, names) +
                                      "; factors: " + config::listed(names));
    }
    by_ = options_.by;
    for (const std::string& name : names) {
      if (options_.by.empty() && !isAveraged(name, options_) && name != options_.columns)
        by_.push_back(name);
    }
    return Status::ok();
  }

  Status requireKnown(const std::vector<CellPart>& parts) const {
    for (const CellPart& part : parts) {
      if (part.metric.empty()) continue;
      const bool known = std::ranges::any_of(
          runs_, [&](const RunRow* run) { return run->metrics.contains(part.metric); });
      if (!known) return Status::invalidParameter("no run has the metric '" + part.metric + "'");
      if (isTooWide(part.format)) {
        return Status::invalidParameter(
            fmt::format("'{}': a width or a number of digits above {}", part.format, kWidest));
      }
      try {
        (void)fmt::format(fmt::runtime(part.format), 0.0);
      } catch (const fmt::format_error& error) {
        return Status::invalidParameter("'" + part.format + "': " + error.what());
      }
    }
    return Status::ok();
  }

  std::string levelOf(const RunRow& run) const { return LevelNames::nameOf(run, by_); }

  using Cells = std::map<std::pair<std::string, std::string>, Runs>;  ///< by row and column

  Status addRow(const std::string& label, const std::string& level, const std::string& cell) {
    std::vector<std::string>& row = table_.rows.emplace_back(1, label);
    for (const std::string& column : columns_.labels) {
      if (Status status = addCell(row, cell, cells_.find({level, column})); !status.isOk()) {
        return status;
      }
    }
    return Status::ok();
  }

  /// Adds a cell; it is empty if there are no such runs.
  Status addCell(std::vector<std::string>& row, const std::string& cell,
                 Cells::const_iterator runs) const {
    const auto parts = partsOf(cell);
    if (!parts.isOk()) return parts.status();
    if (Status status = requireKnown(parts.value()); !status.isOk()) return status;
    row.emplace_back();
    if (runs == cells_.end()) return Status::ok();
    if (Status status = oneKind(runs->second, options_); !status.isOk()) return status;
    for (const CellPart& part : parts.value()) {
      Status status = refuseMixedLengths(runs->second, part.metric);
      if (!status.isOk()) return status;
    }
    row.back() = filled(parts.value(), runs->second);
    return Status::ok();
  }

  const PivotOptions& options_;
  std::vector<std::string> by_;
  Runs runs_;
  Levels columns_;
  Levels levels_;
  Cells cells_;
  TextTable table_;
};

}  // namespace

Result<TextTable> pivotOf(const std::vector<RunRow>& rows, const PivotOptions& options) {
  std::vector<RunRow> wanted;
  for (const RunRow& row : rows) {
    if (hasLabels(row, options.only)) wanted.push_back(row);
  }
  const Result<std::string> repeated = mergeRepeats(wanted);
  if (!repeated.isOk()) return repeated.status();
  Result<TextTable> table = Pivot(wanted, options).table();
  if (!table.isOk()) return table;
  std::vector<std::string>& notes = table.value().notes;
  std::ranges::move(trackingNotes(wanted), std::back_inserter(notes));
  if (!repeated.value().empty()) notes.push_back(repeated.value());
  return table;
}

}  // namespace tolman::experiment
