// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "config/text.hpp"
#include "experiment/averaging.hpp"
#include "record/output_places.hpp"

namespace tolman::experiment {
namespace {

bool isRepeated(const std::string& factor) { return factor == "sequence" || factor == "seed"; }

std::vector<std::string> factorNames(const std::vector<RunRow>& rows) {
  std::vector<std::string> names;
  for (const RunRow& row : rows) {
    for (const Factor& factor : row.factors) {
      if (std::ranges::find(names, factor.name) == names.end()) names.push_back(factor.name);
    }
  }
  return names;
}

/// `wanted`, or the one name that ends with it. `kind` is what messages call a name.
Result<std::string> fullName(const std::string& kind, const std::string& wanted,
                             const std::vector<std::string>& names) {
  if (std::ranges::find(names, wanted) != names.end()) return wanted;
  std::vector<std::string> ends;
  for (const std::string& name : names) {
    if (name.ends_with("." + wanted)) ends.push_back(name);
  }
  if (ends.size() == 1) return ends.front();
  if (ends.empty()) return Status::invalidParameter("no " + kind + " '" + wanted + "'");
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

class Comparer {
 public:
  Comparer(const std::vector<RunRow>& rows, const ComparisonOptions& options)
      : rows_(rows), options_(options) {}

  Result<Comparison> run() {
    Status status = choose();
    if (status.isOk()) status = chooseMetric();
    if (status.isOk()) status = refuseMixtures(pointersTo(rows_), options_.mixed_coverage);
    if (status.isOk()) status = refuseMixedLengths(pointersTo(rows_), comparison_.metric);
    if (status.isOk()) status = refuseCopies(pointersTo(rows_));
    if (status.isOk()) status = comparison_.by.empty() ? namedOnce() : countOnce();
    if (!status.isOk()) return status;
    countTruths();
    tellUnknownResultsApart();
    comparison_.alignment = rows_.front().alignment;
    warnOfEqualResults();
    for (std::string& text : trackingNotes(rows_)) note(std::move(text));
    status = fillLevels();
    if (!status.isOk()) return status;
    return std::move(comparison_);
  }

 private:
  struct Measured {
    double value = 0;
    std::string seed;
    const RunRow* row = nullptr;
  };
  using Values =
      std::map<std::string, std::map<std::string, Measured>>;  ///< by sequence, by the rest

  /// Chooses factors and rows.
  Status choose() {
    const std::vector<std::string> names = factorNames(rows_);
    const auto known = [&](const std::string& wanted, std::string& name) {
      const Result<std::string> full = fullName("factor", wanted, names);
      if (full.isOk()) {
        name = full.value();
        return Status::ok();
      }
      return Status::invalidParameter(full.status().message() + config::didYouMean(wanted, names) +
                                      "; factors: " + config::listed(names));
    };
    auto only = options_.only;
    for (auto& [factor, label] : only) {
      if (Status status = known(std::string(factor), factor); !status.isOk()) return status;
    }
    for (const auto& [factor, label] : only) {
      if (Status status = requireLabel(factor, label); !status.isOk()) return status;
    }
    std::erase_if(rows_, [&](const RunRow& row) { return !hasLabels(row, only); });
    if (rows_.empty()) return Status::invalidParameter("no run is left to compare");
    for (const std::string& wanted : options_.by) {
      if (Status status = known(wanted, comparison_.by.emplace_back()); !status.isOk())
        return status;
    }
    const auto varied = std::ranges::count_if(names, std::not_fn(isRepeated));
    const bool is_alone = std::ranges::all_of(rows_, &RunRow::is_alone);
    if (is_alone && varied > 1) return Status::ok();  // each run is a level of its own
    if (comparison_.by.empty()) comparison_.by = variedFactors(names);
    return Status::ok();
  }

  Status requireLabel(const std::string& factor, const std::string& label) const {
    std::set<std::string> labels;
    for (const RunRow& row : rows_) labels.insert(row.label(factor));
    if (labels.contains(label)) return Status::ok();
    const std::vector<std::string> names(labels.begin(), labels.end());
    return Status::invalidParameter("no run has " + factor + "=" + label +
                                    config::didYouMean(label, names) +
                                    "; values: " + config::listed(names));
  }

  /// All factors that vary in the runs; if none does, the first factor.
  std::vector<std::string> variedFactors(std::vector<std::string> names) const {
    std::erase_if(names, isRepeated);
    std::vector<std::string> varied = names;
    std::erase_if(varied, [&](const std::string& name) {
      return std::ranges::all_of(
          rows_, [&](const RunRow& row) { return row.label(name) == rows_.front().label(name); });
    });
    if (varied.empty() && !names.empty()) varied = {names.front()};
    return varied;
  }

  /// What to choose instead of a metric that no run has.
  std::string otherMetrics(const std::string& wanted, const std::vector<std::string>& names) const {
    const std::string similar = config::didYouMean(wanted, names);
    const bool is_ending = std::ranges::any_of(
        names, [&](const std::string& name) { return name.ends_with("." + wanted); });
    if (is_ending || !similar.empty()) return similar;
    std::vector<std::string> plain = names;  // the others are parts of figures
    std::erase_if(plain, [](const std::string& name) { return name.find('.') != name.npos; });
    const bool has_truth =
        std::ranges::any_of(rows_, [](const RunRow& row) { return !row.truth.empty(); });
    return std::string(has_truth ? "" : "; the runs have no true poses, and so no errors") +
           "; set --metric, for example to one of: " + config::listed(plain);
  }

  Status chooseMetric() {
    std::set<std::string> known;
    for (const RunRow& row : rows_) {
      for (const auto& [name, value] : row.metrics) known.insert(name);
    }
    const std::vector<std::string> names(known.begin(), known.end());
    const std::string wanted = metricOf(options_.metric);
    const Result<std::string> full = fullName("metric", wanted, names);
    if (!full.isOk()) {
      return Status::invalidParameter(full.status().message() + " in " +
                                      rows_.front().directory.string() + "/metrics.json" +
                                      otherMetrics(wanted, names));
    }
    comparison_.metric = full.value();
    const std::size_t before = rows_.size();
    std::erase_if(rows_,
                  [&](const RunRow& row) { return !row.metrics.contains(comparison_.metric); });
    if (rows_.size() < before) {
      note(fmt::format("{} of {} runs have no {} and are left out.", before - rows_.size(), before,
                       comparison_.metric));
    }
    return Status::ok();
  }

  /// Merges runs with the same factors, seed and results.
  Status countOnce() {
    const Result<std::string> repeated = mergeRepeats(rows_);
    if (repeated.isOk() && !repeated.value().empty()) note(repeated.value());
    return repeated.status();
  }

  /// Removes directories outside a sweep that were given twice. Such runs are levels of their own,
  /// and may have the same factors.
  Status namedOnce() {
    std::set<std::filesystem::path> known;
    const std::size_t repeated = std::erase_if(rows_, [&](const RunRow& row) {
      return row.is_alone && !row.directory.empty() &&
             !known.insert(record::truePath(row.directory)).second;
    });
    if (repeated > 0) note(fmt::format("{} runs were given twice. They count once.", repeated));
    return Status::ok();
  }

  void countTruths() {
    std::set<std::string> truths;
    for (const RunRow& row : rows_) truths.insert(row.truth);
    comparison_.truths = truths.size();
  }

  /// Results without a digest are not known to be equal: each counts as results of its own.
  void tellUnknownResultsApart() {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (rows_[i].results.empty()) rows_[i].results = fmt::format("unknown {}", i);
    }
  }

  struct SettingCounts {
    std::size_t all = 0;
    std::size_t equal = 0;  ///< settings in which several seeds gave the same results
  };
  /// Counts the settings (equal labels except the seed), and sets fewest_.
  SettingCounts countSettings() {
    std::map<std::string, std::set<std::string>> results;
    std::map<std::string, std::size_t> runs;
    for (const RunRow& row : rows_) {
      const std::string setting = row.labelsWithout({"seed"});
      results[setting].insert(row.results);
      ++runs[setting];
    }
    SettingCounts counts{runs.size(), 0};
    for (const auto& [setting, count] : runs) {
      const std::size_t different = results[setting].size();
      if (different < count) ++counts.equal;
      fewest_ = std::min(fewest_, different);
    }
    return counts;
  }

  void warnOfEqualResults() {
    const auto [settings, equal] = countSettings();
    if (equal > 0) {
      note(fmt::format(
          "In {} of {} settings several seeds gave the same results, byte for byte. They say "
          "nothing of the spread: they count as one run where intervals need at least three, "
          "while means, medians and sd are over all runs.",
          equal, settings));
    }
    std::set<std::string> own;
    for (const RunRow& row : rows_) own.insert(row.label("sequence") + row.results);
    const std::vector<std::string> without_effect =
        own.size() < rows_.size() ? factorsWithoutEffect(rows_) : std::vector<std::string>();
    if (equal > 0 && !without_effect.empty()) {
      note(config::listed(without_effect) + " changes nothing, byte for byte.");
    }
    if (equal == 0 && own.size() < rows_.size()) {
      note(fmt::format("Only {} of {} runs have results of their own, byte for byte: {}.",
                       own.size(), rows_.size(),
                       without_effect.empty()
                           ? "some levels of a factor change nothing"
                           : config::listed(without_effect) + " changes nothing"));
    }
    if (fewest_ < kMinSeeds) {
      note(
          fmt::format("Not enough runs for intervals and tests: {} different results a setting, at "
                      "least {} are needed.",
                      fewest_, kMinSeeds));
    }
  }

  std::string levelOf(const RunRow& row) const {
    const std::string level = LevelNames::nameOf(row, comparison_.by);
    return level.empty() ? row.name : level;
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

  /// The values of all runs by level. `order`: the levels in the order of the rows.
  Status collectValues(std::vector<std::string>& order,
                       std::map<std::string, Values>& values) const {
    LevelNames names;
    for (const RunRow& row : rows_) {
      const std::string level = levelOf(row);
      if (!values.contains(level)) order.push_back(level);
      if (Status status = names.add(row, comparison_.by); !status.isOk()) return status;
      const Measured run = {row.metrics.at(comparison_.metric), row.label("seed"), &row};
      const auto [other, is_new] =
          values[level][row.label("sequence")].try_emplace(restOf(row), run);
      if (!is_new) return oneSetting(*other->second.row, row);
    }
    return Status::ok();
  }

  Level makeLevel(const std::string& label, const std::map<std::string, Values>& values) const {
    Level level{label, {}, {}, {}, {}, {}};
    std::vector<std::vector<double>> groups;
    for (const auto& [sequence, runs] : values.at(label)) {
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
    if (label != comparison_.baseline) {
      level.difference = difference(values.at(label), values.at(comparison_.baseline));
    }
    return level;
  }

  Status fillLevels() {
    std::vector<std::string> order;
    std::map<std::string, Values> values;
    if (Status status = collectValues(order, values); !status.isOk()) return status;
    sort(order);
    comparison_.baseline = options_.baseline.empty() ? order.front() : options_.baseline;
    if (!values.contains(comparison_.baseline)) {
      return Status::invalidParameter("no level '" + options_.baseline + "'" +
                                      config::didYouMean(options_.baseline, order) +
                                      "; levels: " + config::listed(order));
    }
    for (const std::string& label : order) comparison_.levels.push_back(makeLevel(label, values));
    if (fewest_ >= kMinSeeds && order.size() > 1) noteFewSamples();
    noteUnevenRuns(values);
    const std::size_t runs = comparison_.levels.front().summary.n;
    if (!std::ranges::all_of(comparison_.levels,
                             [&](const Level& l) { return l.summary.n == runs; })) {
      note(
          "The levels have different numbers of runs: their means are of different sequences or "
          "seeds. The paired differences use the runs that both have.");
    }
    return Status::ok();
  }

  /// The mean of a level is over runs, its interval over sequences and seeds. They are of one
  /// estimate only if all sequences, and all seeds of one, have as many runs.
  void noteUnevenRuns(const std::map<std::string, Values>& values) {
    std::vector<std::string> uneven;
    for (const Level& level : comparison_.levels) {
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
    if (!uneven.empty()) note(unevenRunsNote(uneven));
  }

  std::size_t sequenceCount() const {
    std::set<std::string> sequences;
    for (const RunRow& row : rows_) sequences.insert(row.label("sequence"));
    return sequences.size();
  }

  void noteFewSamples() {
    for (const std::string& text :
         {fewSamplesNote(sequenceCount(), fewest_), sameTruthNote(rows_)}) {
      if (!text.empty()) note(text);
    }
  }

  /// Sorts by number if all first labels are numbers.
  static void sort(std::vector<std::string>& labels) {
    const auto number = [](const std::string& label) -> std::optional<double> {
      char* end = nullptr;
      const double value = std::strtod(label.c_str(), &end);
      const bool is_number = end != label.c_str() && (*end == '\0' || *end == ',');
      return is_number ? std::optional(value) : std::nullopt;
    };
    if (!std::ranges::all_of(labels, [&](const auto& l) { return number(l).has_value(); })) return;
    std::ranges::stable_sort(labels, {}, [&](const auto& l) { return *number(l); });
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
    const bool is_of_seeds = groups.size() == 1 && sequenceCount() > 1;
    if (fewest < kMinSeeds || is_of_seeds) return paired;
    paired.interval = bootstrapMean(groups, options_.seed);
    paired.test = signedRank(groups.size() > 1 ? means : groups.front());
    return paired;
  }

  void note(std::string text) { comparison_.notes.push_back(std::move(text)); }

  std::vector<RunRow> rows_;
  const ComparisonOptions& options_;
  Comparison comparison_;
  std::size_t fewest_ = SIZE_MAX;  ///< smallest number of different results of one setting
};

}  // namespace

Result<Comparison> compareRuns(const std::vector<RunRow>& rows, const ComparisonOptions& options) {
  return Comparer(rows, options).run();
}

}  // namespace tolman::experiment
