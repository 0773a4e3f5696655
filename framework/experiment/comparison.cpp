// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "base/must.hpp"
#include "config/text.hpp"

namespace tolman::experiment {
namespace {

using Names = std::vector<std::string>;

[[noreturn]] void refuse(const std::string& why) { throw Refused{Status::invalidParameter(why)}; }

/// `wanted`, or the one name that ends with it. `kind` is what messages call a name.
std::string fullName(const std::string& kind, const std::string& wanted, const Names& names,
                     const std::string& advice) {
  if (std::ranges::find(names, wanted) != names.end()) return wanted;
  Names ends;
  for (const std::string& name : names) {
    if (name.ends_with("." + wanted)) ends.push_back(name);
  }
  if (ends.size() == 1) return ends.front();
  if (!ends.empty()) {
    refuse("more than one " + kind + " ends with '" + wanted + "': " + config::listed(ends));
  }
  refuse("no " + kind + " '" + wanted + "'" + config::didYouMean(wanted, names) + advice);
}

/// Without --by all factors that vary; if none does, the first. None where each run is a level.
Names factorsThatVary(const std::vector<RunRow>& rows) {
  Names names = factorNames(rows);
  std::erase_if(names, [](const auto& name) { return name == "sequence" || name == "seed"; });
  if (std::ranges::all_of(rows, &RunRow::is_alone) && names.size() > 1) return {};
  Names varying;
  std::ranges::copy_if(names, std::back_inserter(varying), [&](const std::string& name) {
    return std::ranges::any_of(
        rows, [&](const RunRow& row) { return row.label(name) != rows.front().label(name); });
  });
  return varying.empty() && !names.empty() ? Names{names.front()} : varying;
}

/// Fills the full name of the metric, and removes runs without it.
void chooseMetric(std::vector<RunRow>& rows, const std::string& wanted, Comparison& comparison) {
  std::set<std::string> known;
  for (const RunRow& row : rows) {
    for (const auto& [name, value] : row.metrics) known.insert(name);
  }
  const Names names(known.begin(), known.end());
  Names plain = names;  // the others are parts of figures
  std::erase_if(plain, [](const std::string& name) { return name.find('.') != name.npos; });
  const bool has_truth =
      std::ranges::any_of(rows, [](const RunRow& row) { return !row.truth.empty(); });
  const std::string& full = comparison.metric =
      fullName("metric", wanted, names,
               std::string(" in metrics.json") +
                   (has_truth ? "" : "; the runs have no true poses, and so no errors") +
                   "; set --metric, for example to one of: " + config::listed(plain));
  const std::size_t all = rows.size();
  const std::size_t without =
      std::erase_if(rows, [&](const RunRow& row) { return !row.metrics.contains(full); });
  if (without > 0) {
    comparison.notes.push_back(
        fmt::format("{} of {} runs have no {} and are left out.", without, all, full));
  }
}

/// Sorts by number if all first labels are numbers.
void sortLevels(Names& labels) {
  if (!std::ranges::all_of(labels, [](const auto& l) { return leadingNumber(l).has_value(); })) {
    return;
  }
  std::ranges::stable_sort(labels, {}, [](const auto& l) { return leadingNumber(l)->first; });
}

class Comparer {
 public:
  Comparer(std::vector<RunRow> rows, const ComparisonOptions& options, Comparison& comparison)
      : rows_(std::move(rows)), options_(options), comparison_(comparison) {}

  void run() {
    RunPointers pointers;
    for (const RunRow& row : rows_) pointers.push_back(&row);
    refuseMixtures(pointers, {comparison_.metric});
    if (!comparison_.by.empty()) note(mergeRepeats(rows_));
    std::set<std::string> truths, sequences;
    for (RunRow& row : rows_) {
      truths.insert(row.truth);
      sequences.insert(row.label("sequence"));
      // Results without a digest are not known to be equal: each counts as results of its own.
      if (row.results.empty()) row.results = fmt::format("unknown {}", &row - rows_.data());
    }
    comparison_.truths = truths.size();
    sequences_ = sequences.size();
    comparison_.alignment = rows_.front().alignment;
    noteEqualResults();
    for (const std::string& text : trackingNotes(rows_)) note(text);
    fillLevels();
  }

 private:
  struct Measured {
    double value = 0;
    std::string seed;
    const RunRow* row = nullptr;
  };
  /// By sequence, by the labels that paired runs of two levels must have in common.
  using Values = std::map<std::string, std::map<std::string, Measured>>;

  void note(const std::string& text) {
    if (!text.empty()) comparison_.notes.push_back(text);
  }

  /// Sets fewest_, and notes seeds that change nothing.
  void noteEqualResults() {
    std::map<std::string, std::pair<std::set<std::string>, std::size_t>> settings;
    for (const RunRow& row : rows_) {
      auto& [results, runs] = settings[row.labelsWithout({"seed"})];
      results.insert(row.results);
      ++runs;
    }
    std::size_t equal = 0;  // settings in which several seeds gave the same results
    for (const auto& [setting, of] : settings) {
      if (of.first.size() < of.second) ++equal;
      fewest_ = std::min(fewest_, of.first.size());
    }
    if (equal > 0) {
      note(fmt::format(
          "In {} of {} settings several seeds gave the same results, byte for byte. They say "
          "nothing of the spread: they count as one run where intervals need at least three, "
          "while means, medians and sd are over all runs.",
          equal, settings.size()));
    }
    if (fewest_ < kMinSeeds) {
      note(
          fmt::format("Not enough runs for intervals and tests: {} different results a setting, at "
                      "least {} are needed.",
                      fewest_, kMinSeeds));
    }
  }

  void fillLevels() {
    Names order;
    std::map<std::string, Values> values;  // by level
    Names left_out = comparison_.by;
    left_out.emplace_back("sequence");
    for (const RunRow& row : rows_) {
      const bool is_level = comparison_.by.empty();  // each run is one
      const std::string label = is_level ? row.name : levelName(row, comparison_.by);
      if (!values.contains(label)) order.push_back(label);
      const auto [other, is_new] = values[label][row.label("sequence")].try_emplace(
          is_level ? "" : row.labelsWithout(left_out),
          Measured{row.metrics.at(comparison_.metric), row.label("seed"), &row});
      if (!is_new) refuseSetting(*other->second.row, row);
    }
    sortLevels(order);
    comparison_.baseline = options_.baseline.empty() ? order.front() : options_.baseline;
    if (!values.contains(comparison_.baseline)) {
      refuse("no level '" + options_.baseline + "'" + config::didYouMean(options_.baseline, order) +
             "; levels: " + config::listed(order));
    }
    const Values& baseline = values.at(comparison_.baseline);
    for (const std::string& label : order) {
      Level& level = comparison_.levels.emplace_back(levelOf(label, values.at(label)));
      if (label != comparison_.baseline) level.difference = difference(values.at(label), baseline);
    }
    noteUnevenRuns(values);
  }

  /// For each sequence the means of its seeds: runs of one seed that differ in other factors are
  /// not independent, and count as one. `value` of a run may be none.
  template <class Value>
  static std::vector<std::vector<double>> seedMeans(const Values& values, const Value& value) {
    std::vector<std::vector<double>> groups;
    for (const auto& [sequence, runs] : values) {
      std::map<std::string, std::vector<double>> seeds;
      for (const auto& [rest, run] : runs) {
        const std::optional<double> known = value(sequence, rest, run);
        if (known) seeds[run.seed].push_back(*known);
      }
      if (seeds.empty()) continue;
      groups.emplace_back();
      for (const auto& [seed, of] : seeds) groups.back().push_back(evaluation::statistics(of).mean);
    }
    return groups;
  }

  Level levelOf(const std::string& label, const Values& values) const {
    Level level{label};
    const auto groups = seedMeans(values, [&](const auto&, const auto&, const Measured& run) {
      level.values.push_back(run.value);
      level.directories.push_back(run.row->directory);
      return std::optional(run.value);
    });
    level.summary = evaluation::statistics(level.values);
    if (fewest_ >= kMinSeeds) level.interval = bootstrapMean(groups, options_.seed);
    return level;
  }

  PairedDifference difference(const Values& level, const Values& baseline) const {
    PairedDifference paired;
    const auto groups = seedMeans(
        level, [&](const std::string& sequence, const std::string& rest, const Measured& run) {
          const auto same = baseline.find(sequence);
          if (same == baseline.end() || !same->second.contains(rest))
            return std::optional<double>();
          ++paired.pairs;
          return std::optional(run.value - same->second.at(rest).value);
        });
    if (groups.empty()) return paired;
    std::vector<double> means;
    std::size_t fewest = fewest_;
    for (const std::vector<double>& group : groups) {
      means.push_back(evaluation::statistics(group).mean);
      fewest = std::min(fewest, group.size());
    }
    paired.mean = evaluation::statistics(means).mean;
    // Of one sequence of several, seeds would be tested where the other levels test sequences.
    const bool is_of_seeds = groups.size() == 1 && sequences_ > 1;
    if (fewest < kMinSeeds || is_of_seeds) return paired;
    paired.interval = bootstrapMean(groups, options_.seed);
    paired.test = signedRank(groups.size() > 1 ? means : groups.front());
    return paired;
  }

  /// The mean of a level is over runs, its interval over sequences and seeds. They are of one
  /// estimate only if all sequences of all levels have as many runs.
  void noteUnevenRuns(const std::map<std::string, Values>& values) {
    std::set<std::size_t> runs;
    for (const auto& [label, sequences] : values) {
      if (sequences.size() != sequences_) runs.insert(0);
      for (const auto& [sequence, own] : sequences) runs.insert(own.size());
    }
    if (runs.size() < 2) return;
    note(
        "Sequences or levels have different numbers of runs. Mean, median and sd weigh all runs "
        "equally, intervals and differences all sequences: the mean need not lie in its interval. "
        "Differences are of the runs that both levels have.");
  }

  std::vector<RunRow> rows_;
  const ComparisonOptions& options_;
  Comparison& comparison_;
  std::size_t sequences_ = 0;
  std::size_t fewest_ = SIZE_MAX;  ///< smallest number of different results of one setting
};

using Json = Table::Json;

/// The row of a level, for readers and by the keys of tableOf().
void addLevel(const Level& level, Table& table) {
  const evaluation::Statistics& s = level.summary;
  const PairedDifference d = level.difference.value_or(PairedDifference{});
  const auto lowOf = [](const auto& range) { return range ? Json(range->low) : Json(); };
  const auto highOf = [](const auto& range) { return range ? Json(range->high) : Json(); };
  table.values.push_back(
      {level.label, s.count, s.mean, lowOf(level.interval), highOf(level.interval), s.median,
       s.count > 1 ? Json(s.deviation) : Json(), s.min, s.max,
       level.difference ? Json(d.pairs) : Json(), d.pairs > 0 ? Json(d.mean) : Json(),
       lowOf(d.interval), highOf(d.interval), d.test ? Json(d.test->p) : Json(),
       d.test ? Json(d.test->effect) : Json()});
  const auto text = [](const char* format, double value) {
    return fmt::format(fmt::runtime(format), value);
  };
  const auto range = [](const std::optional<Interval>& of) {
    return of ? fmt::format("{:.4g} to {:.4g}", of->low, of->high) : "not enough runs";
  };
  table.rows.push_back({level.label, fmt::format("{}", s.count), text("{:.4g}", s.mean),
                        range(level.interval), text("{:.4g}", s.median),
                        s.count > 1 ? text("{:.4g}", s.deviation) : "-",
                        !level.difference ? "baseline"
                        : d.pairs == 0    ? "no pairs"
                                          : text("{:+.4g}", d.mean),
                        d.pairs > 0 ? range(d.interval) : "",
                        d.test ? text(d.test->p < 0.001 ? "{:.1e}" : "{:.3f}", d.test->p) : "",
                        d.test ? text("{:+.2f}", d.test->effect) : ""});
}

}  // namespace

std::optional<std::pair<double, std::string>> leadingNumber(const std::string& label) {
  char* end = nullptr;
  const double value = std::strtod(label.c_str(), &end);
  if (end == label.c_str() || (*end != '\0' && *end != ',')) return std::nullopt;
  return std::pair(value, std::string(*end == ',' ? end + 2 : ""));
}

bool hasLabels(const RunRow& row, const Labels& only) {
  return std::ranges::all_of(only, [&](const auto& asked) {
    return std::ranges::any_of(only, [&](const auto& other) {
      return other.first == asked.first && row.label(other.first) == other.second;
    });
  });
}

Names fullFactors(const std::vector<RunRow>& rows, const Names& wanted) {
  const Names names = factorNames(rows);
  Names full;
  for (const std::string& name : wanted) {
    full.push_back(fullName("factor", name, names, "; factors: " + config::listed(names)));
  }
  return full;
}

std::vector<RunRow> selectRuns(std::vector<RunRow> rows, const Labels& only) {
  Labels full;
  for (const auto& [given, label] : only) {
    const std::string factor = fullFactors(rows, {given}).front();
    full.emplace_back(factor, label);
    std::set<std::string> known;
    for (const RunRow& row : rows) known.insert(row.label(factor));
    if (known.contains(label)) continue;
    const Names labels(known.begin(), known.end());
    refuse("no run has " + factor + "=" + label + config::didYouMean(label, labels) +
           "; values: " + config::listed(labels));
  }
  std::erase_if(rows, [&](const RunRow& row) { return !hasLabels(row, full); });
  if (rows.empty()) refuse("no run is left to compare");
  return rows;
}

Result<Comparison> compareRuns(const std::vector<RunRow>& rows, const ComparisonOptions& options) {
  return resultOf([&] {
    Comparison comparison;
    std::vector<RunRow> chosen = selectRuns(rows, options.only);
    comparison.by = fullFactors(chosen, options.by);
    if (options.by.empty()) comparison.by = factorsThatVary(chosen);
    chooseMetric(chosen, options.metric, comparison);
    Comparer(std::move(chosen), options, comparison).run();
    return comparison;
  });
}

Table tableOf(const Comparison& comparison) {
  const std::string by =
      comparison.by.empty() ? "run" : fmt::format("{}", fmt::join(comparison.by, ", "));
  Table table{{by, "runs", "mean", "95 % interval", "median", "sd", "difference", "95 % interval",
               "p", "effect"},
              {}};
  table.keys = {by,      "runs", "mean",  "mean_low",   "mean_high",      "median",          "sd",
                "min",   "max",  "pairs", "difference", "difference_low", "difference_high", "p",
                "effect"};
  for (const Level& level : comparison.levels) addLevel(level, table);
  table.about = {{"metric", comparison.metric},
                 {"by", comparison.by},
                 {"baseline", comparison.baseline},
                 {"alignment", comparison.alignment}};
  table.notes.push_back(
      "`" + comparison.metric + "`; differences to `" + comparison.baseline +
      "` in runs of the same sequence, seed and other factors. Intervals: bootstrap of "
      "sequences, then of seeds. p: exact Wilcoxon signed rank test of the means of the "
      "sequences (of one sequence: of the seeds). Effect: rank-biserial correlation.");
  table.notes.insert(table.notes.end(), comparison.notes.begin(), comparison.notes.end());
  return table;
}

}  // namespace tolman::experiment
