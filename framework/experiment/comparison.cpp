// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "config/text.hpp"
#include "experiment/averaging.hpp"

namespace tolman::experiment {
namespace {

bool isRepeated(const std::string& factor) { return factor == "sequence" || factor == "seed"; }

/// `wanted`, or the one name that ends with it. `kind` is what messages call a name.
Result<std::string> fullName(const std::string& kind, const std::string& wanted,
                             const std::vector<std::string>& names, const std::string& advice) {
  if (std::ranges::find(names, wanted) != names.end()) return wanted;
  std::vector<std::string> ends;
  for (const std::string& name : names) {
    if (name.ends_with("." + wanted)) ends.push_back(name);
  }
  if (ends.size() == 1) return ends.front();
  if (ends.empty()) {
    return Status::invalidParameter("no " + kind + " '" + wanted + "'" +
                                    config::didYouMean(wanted, names) + advice);
  }
  return Status::invalidParameter("more than one " + kind + " ends with '" + wanted +
                                  "': " + config::listed(ends));
}

/// The metric for a short name such as "ate", as in the summary of a run.
std::string metricOf(const std::string& wanted) {
  static const std::map<std::string, std::string> kShort = {
      {"ate", "map.ate.rmse_m"},
      {"odometry_ate", "odometry.ate.rmse_m"},
      {"t_rel", "map.kitti.t_rel_percent"},
      {"r_rel", "map.kitti.r_rel_deg_per_100m"}};
  const auto found = kShort.find(wanted);
  return found == kShort.end() ? wanted : found->second;
}

/// Sorts by number if all first labels are numbers.
void sortLevels(std::vector<std::string>& labels) {
  const auto number = [](const std::string& label) -> std::optional<double> {
    char* end = nullptr;
    const double value = std::strtod(label.c_str(), &end);
    const bool is_number = end != label.c_str() && (*end == '\0' || *end == ',');
    return is_number ? std::optional(value) : std::nullopt;
  };
  if (!std::ranges::all_of(labels, [&](const auto& l) { return number(l).has_value(); })) return;
  std::ranges::stable_sort(labels, {}, [&](const auto& l) { return *number(l); });
}

/// The rows to compare, and by what.
class Selection {
 public:
  Selection(const std::vector<RunRow>& rows, const ComparisonOptions& options)
      : rows_(rows), options_(options) {}

  /// Removes the other rows; fills `by`, `metric` and notes.
  Status apply(std::vector<RunRow>& rows, Comparison& comparison) {
    Status status = chooseRows();
    if (status.isOk()) status = chooseFactors(comparison.by);
    if (status.isOk()) status = chooseMetric(comparison);
    rows = std::move(rows_);
    return status;
  }

 private:
  std::vector<std::string> factors() const {
    std::vector<std::string> names;
    for (const RunRow& row : rows_) {
      for (const Factor& factor : row.factors) {
        if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
      }
    }
    return names;
  }

  Result<std::string> factorNamed(const std::string& wanted) const {
    const std::vector<std::string> names = factors();
    return fullName("factor", wanted, names, "; factors: " + config::listed(names));
  }

  Status chooseRows() {
    auto only = options_.only;
    for (auto& [factor, label] : only) {
      const Result<std::string> full = factorNamed(factor);
      if (!full.isOk()) return full.status();
      factor = full.value();
      std::set<std::string> labels;
      for (const RunRow& row : rows_) labels.insert(row.label(factor));
      if (labels.contains(label)) continue;
      const std::vector<std::string> names(labels.begin(), labels.end());
      return Status::invalidParameter("no run has " + factor + "=" + label +
                                      config::didYouMean(label, names) +
                                      "; values: " + config::listed(names));
    }
    std::erase_if(rows_, [&](const RunRow& row) { return !hasLabels(row, only); });
    return rows_.empty() ? Status::invalidParameter("no run is left to compare") : Status::ok();
  }

  /// Without options all factors that vary; if none does, the first.
  Status chooseFactors(std::vector<std::string>& by) const {
    for (const std::string& wanted : options_.by) {
      const Result<std::string> full = factorNamed(wanted);
      if (!full.isOk()) return full.status();
      by.push_back(full.value());
    }
    std::vector<std::string> names = factors();
    std::erase_if(names, isRepeated);
    const bool are_alone = std::ranges::all_of(rows_, &RunRow::is_alone);
    if (!by.empty() || names.empty() || (are_alone && names.size() > 1)) return Status::ok();
    std::ranges::copy_if(names, std::back_inserter(by), [&](const std::string& name) {
      return std::ranges::any_of(
          rows_, [&](const RunRow& row) { return row.label(name) != rows_.front().label(name); });
    });
    if (by.empty()) by = {names.front()};
    return Status::ok();
  }

  Status chooseMetric(Comparison& comparison) {
    std::set<std::string> known;
    for (const RunRow& row : rows_) {
      for (const auto& [name, value] : row.metrics) known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    std::vector<std::string> plain = names;  // the others are parts of figures
    std::erase_if(plain, [](const std::string& name) { return name.find('.') != name.npos; });
    const bool has_truth =
        std::ranges::any_of(rows_, [](const RunRow& row) { return !row.truth.empty(); });
    const Result<std::string> full =
        fullName("metric", metricOf(options_.metric), names,
                 std::string(" in metrics.json") +
                     (has_truth ? "" : "; the runs have no true poses, and so no errors") +
                     "; set --metric, for example to one of: " + config::listed(plain));
    if (!full.isOk()) return full.status();
    const std::size_t before = rows_.size();
    comparison.metric = full.value();
    std::erase_if(rows_, [&](const RunRow& row) { return !row.metrics.contains(full.value()); });
    if (rows_.size() < before) {
      comparison.notes.push_back(fmt::format("{} of {} runs have no {} and are left out.",
                                             before - rows_.size(), before, full.value()));
    }
    return Status::ok();
  }

  std::vector<RunRow> rows_;
  const ComparisonOptions& options_;
};

class Comparer {
 public:
  Comparer(std::vector<RunRow> rows, const ComparisonOptions& options, Comparison& comparison)
      : rows_(std::move(rows)), options_(options), comparison_(comparison) {}

  Status run() {
    Status status =
        refuseMixtures(pointersTo(rows_), {comparison_.metric}, options_.mixed_coverage);
    if (status.isOk() && !comparison_.by.empty()) {
      const Result<std::string> repeated = mergeRepeats(rows_);
      note(repeated.isOk() ? repeated.value() : "");
      status = repeated.status();
    }
    if (!status.isOk()) return status;
    std::set<std::string> truths;
    std::set<std::string> sequences;
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
    return fillLevels();
  }

 private:
  struct Measured {
    double value = 0;
    std::string seed;
    const RunRow* row = nullptr;
  };
  using Values =
      std::map<std::string, std::map<std::string, Measured>>;  ///< by sequence, by the rest

  void note(const std::string& text) {
    if (!text.empty()) comparison_.notes.push_back(text);
  }

  /// Sets fewest_, and notes seeds and factors that change nothing.
  void noteEqualResults() {
    std::map<std::string, std::pair<std::set<std::string>, std::size_t>> settings;
    std::set<std::string> own;
    for (const RunRow& row : rows_) {
      auto& [results, runs] = settings[row.labelsWithout({"seed"})];
      results.insert(row.results);
      ++runs;
      own.insert(row.label("sequence") + row.results);
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
    if (own.size() < rows_.size()) {
      const std::string names = config::listed(factorsWithoutEffect(rows_));
      if (equal == 0) {
        note(fmt::format(
            "Only {} of {} runs have results of their own, byte for byte: {}.", own.size(),
            rows_.size(),
            names.empty() ? "some levels of a factor change nothing" : names + " changes nothing"));
      } else if (!names.empty()) {
        note(names + " changes nothing, byte for byte.");
      }
    }
    if (fewest_ < kMinSeeds) {
      note(
          fmt::format("Not enough runs for intervals and tests: {} different results a setting, at "
                      "least {} are needed.",
                      fewest_, kMinSeeds));
    }
  }

  /// Labels that paired runs of two levels must have in common, besides the sequence.
  std::string restOf(const RunRow& row) const {
    if (comparison_.by.empty()) return "";
    std::vector<std::string> left_out = comparison_.by;
    left_out.emplace_back("sequence");
    return row.labelsWithout(left_out);
  }

  /// Values by seed. Runs of one seed that differ in other factors are not independent: they count
  /// as one.
  using SeedMeans = std::map<std::string, std::vector<double>>;
  static std::vector<double> meansOf(const SeedMeans& runs) {
    std::vector<double> means;
    for (const auto& [seed, values] : runs) means.push_back(summaryOf(values).mean);
    return means;
  }

  Status fillLevels() {
    std::vector<std::string> order;
    std::map<std::string, Values> values;  // by level
    for (const RunRow& row : rows_) {
      const std::string label = comparison_.by.empty() ? row.name : levelName(row, comparison_.by);
      if (!values.contains(label)) order.push_back(label);
      const Measured run = {row.metrics.at(comparison_.metric), row.label("seed"), &row};
      const auto [other, is_new] =
          values[label][row.label("sequence")].try_emplace(restOf(row), run);
      if (!is_new) return oneSetting(*other->second.row, row);
    }
    sortLevels(order);
    comparison_.baseline = options_.baseline.empty() ? order.front() : options_.baseline;
    if (!values.contains(comparison_.baseline)) {
      return Status::invalidParameter("no level '" + options_.baseline + "'" +
                                      config::didYouMean(options_.baseline, order) +
                                      "; levels: " + config::listed(order));
    }
    const Values& baseline = values.at(comparison_.baseline);
    for (const std::string& label : order) {
      Level& level = comparison_.levels.emplace_back(levelOf(label, values.at(label)));
      if (label != comparison_.baseline) {
        level.difference = difference(values.at(label), baseline);
      }
    }
    if (fewest_ >= kMinSeeds && order.size() > 1) note(fewSamplesNote(sequences_, fewest_));
    if (order.size() > 1) note(sameTruthNote(rows_));
    noteUnevenRuns(values);
    return Status::ok();
  }

  Level levelOf(const std::string& label, const Values& values) const {
    Level level{label};
    std::vector<std::vector<double>> groups;
    for (const auto& [sequence, runs] : values) {
      SeedMeans means;
      for (const auto& [rest, run] : runs) {
        means[run.seed].push_back(run.value);
        level.values.push_back(run.value);
        level.directories.push_back(run.row->directory);
      }
      groups.push_back(meansOf(means));
    }
    level.summary = summaryOf(level.values);
    if (fewest_ >= kMinSeeds) level.interval = bootstrapMean(groups, options_.seed);
    return level;
  }

  PairedDifference difference(const Values& level, const Values& baseline) const {
    PairedDifference paired;
    std::vector<std::vector<double>> groups;
    std::vector<double> means;
    std::size_t fewest = fewest_;
    for (const auto& [sequence, runs] : level) {
      const auto same = baseline.find(sequence);
      if (same == baseline.end()) continue;
      SeedMeans differences;
      for (const auto& [rest, run] : runs) {
        const auto other = same->second.find(rest);
        if (other == same->second.end()) continue;
        differences[run.seed].push_back(run.value - other->second.value);
        ++paired.pairs;
      }
      if (differences.empty()) continue;
      groups.push_back(meansOf(differences));
      fewest = std::min(fewest, groups.back().size());
      means.push_back(summaryOf(groups.back()).mean);
    }
    if (groups.empty()) return paired;
    paired.mean = summaryOf(means).mean;
    // Of one sequence of several, seeds would be tested where the other levels test sequences.
    const bool is_of_seeds = groups.size() == 1 && sequences_ > 1;
    if (fewest < kMinSeeds || is_of_seeds) return paired;
    paired.interval = bootstrapMean(groups, options_.seed);
    paired.test = signedRank(groups.size() > 1 ? means : groups.front());
    return paired;
  }

  /// The mean of a level is over runs, its interval over sequences and seeds. They are of one
  /// estimate only if all sequences, and all seeds of one, have as many runs.
  void noteUnevenRuns(const std::map<std::string, Values>& values) {
    std::vector<std::string> uneven;
    std::set<std::size_t> sizes;
    for (const Level& level : comparison_.levels) {
      sizes.insert(level.summary.n);
      std::set<std::size_t> runs;
      std::set<std::size_t> seeds;
      for (const auto& [sequence, own] : values.at(level.label)) {
        std::map<std::string, std::size_t> by_seed;
        for (const auto& [rest, run] : own) ++by_seed[run.seed];
        runs.insert(own.size());
        for (const auto& [seed, count] : by_seed) seeds.insert(count);
      }
      if (level.interval && (runs.size() > 1 || seeds.size() > 1)) uneven.push_back(level.label);
    }
    if (!uneven.empty()) {
      note("In " + config::listed(uneven) +
           " sequences or seeds have different numbers of runs. Mean, median and sd weigh all runs "
           "equally, intervals and differences all sequences: the mean need not lie in its "
           "interval.");
    }
    if (sizes.size() > 1) {
      note(
          "The levels have different numbers of runs: their means are of different sequences or "
          "seeds. The paired differences use the runs that both have.");
    }
  }

  std::vector<RunRow> rows_;
  const ComparisonOptions& options_;
  Comparison& comparison_;
  std::size_t sequences_ = 0;
  std::size_t fewest_ = SIZE_MAX;  ///< smallest number of different results of one setting
};

}  // namespace

Result<Comparison> compareRuns(const std::vector<RunRow>& rows, const ComparisonOptions& options) {
  Comparison comparison;
  std::vector<RunRow> chosen;
  Status status = Selection(rows, options).apply(chosen, comparison);
  if (status.isOk()) status = Comparer(std::move(chosen), options, comparison).run();
  if (!status.isOk()) return status;
  return comparison;
}

namespace {

std::string number(double value) { return fmt::format("{:.4g}", value); }

std::string rangeText(const std::optional<Interval>& interval) {
  return interval ? number(interval->low) + " to " + number(interval->high) : "not enough runs";
}

std::vector<std::string> textsOf(const Level& level) {
  const Summary& s = level.summary;
  std::vector<std::string> row = {level.label,      std::to_string(s.n),
                                  number(s.mean),   rangeText(level.interval),
                                  number(s.median), s.n > 1 ? number(s.deviation) : "-"};
  std::vector<std::string> difference = {"baseline", "", "", ""};
  if (const auto& d = level.difference) {
    difference[0] = d->pairs == 0 ? "no pairs" : fmt::format("{:+.4g}", d->mean);
    if (d->pairs > 0) difference[1] = rangeText(d->interval);
    if (d->test) {
      const double p = d->test->p;
      difference[2] = p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
      difference[3] = fmt::format("{:+.2f}", d->test->effect);
    }
  }
  row.insert(row.end(), difference.begin(), difference.end());
  return row;
}

std::vector<Table::Json> valuesOf(const Level& level) {
  using Json = Table::Json;
  const Summary& s = level.summary;
  const auto& d = level.difference;
  const auto low = [](const auto& range) { return range ? Json(range->low) : Json(); };
  const auto high = [](const auto& range) { return range ? Json(range->high) : Json(); };
  const std::optional<Interval> none;
  return {level.label,
          s.n,
          s.mean,
          low(level.interval),
          high(level.interval),
          s.median,
          s.n > 1 ? Json(s.deviation) : Json(),
          s.low,
          s.high,
          d ? Json(d->pairs) : Json(),
          d && d->pairs > 0 ? Json(d->mean) : Json(),
          low(d ? d->interval : none),
          high(d ? d->interval : none),
          d && d->test ? Json(d->test->p) : Json(),
          d && d->test ? Json(d->test->effect) : Json()};
}

}  // namespace

Table tableOf(const Comparison& comparison) {
  const std::string by =
      comparison.by.empty() ? "run" : fmt::format("{}", fmt::join(comparison.by, ", "));
  Table table{{by, "runs", "mean", "95 % interval", "median", "sd", "difference", "95 % interval",
               "p", "effect"},
              {}};
  table.keys = {by,      "runs", "mean",  "mean_low",   "mean_high",      "median",          "sd",
                "min",   "max",  "pairs", "difference", "difference_low", "difference_high", "p",
                "effect"};
  for (const Level& level : comparison.levels) {
    table.rows.push_back(textsOf(level));
    table.values.push_back(valuesOf(level));
  }
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
