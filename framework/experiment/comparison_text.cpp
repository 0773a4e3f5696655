// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/comparison_text.hpp"

#include <fmt/format.h>

#include <cmath>

#include "experiment/text_table.hpp"

namespace tolman::experiment {
namespace {

using Row = std::vector<std::string>;

std::string number(double value) { return fmt::format("{:.4g}", value); }

std::string byText(const Comparison& comparison) {
  std::string text;
  for (const std::string& factor : comparison.by) text += (text.empty() ? "" : ", ") + factor;
  return text.empty() ? "run" : text;
}

/// Below 0.001 in scientific notation, else with decimals.
std::string probability(double p) {
  return p < 0.001 ? fmt::format("{:.1e}", p) : fmt::format("{:.3f}", p);
}

Row heading(const Comparison& comparison) {
  return {byText(comparison), "runs",          "mean", "95 % interval", "median", "sd",
          "difference",       "95 % interval", "p",    "effect"};
}

Row rowOf(const Level& level) {
  const auto range = [](const std::optional<Interval>& interval) {
    return interval ? number(interval->low) + " to " + number(interval->high)
                    : std::string("not enough runs");
  };
  const Summary& s = level.summary;
  Row row = {level.label,           std::to_string(s.n), number(s.mean),
             range(level.interval), number(s.median),    s.n > 1 ? number(s.deviation) : "-"};
  if (!level.difference) {
    row.insert(row.end(), {"baseline", "", "", ""});
  } else if (level.difference->pairs == 0) {
    row.insert(row.end(), {"no pairs", "", "", ""});
  } else {
    const PairedDifference& d = *level.difference;
    row.insert(row.end(), {fmt::format("{:+.4g}", d.mean), range(d.interval),
                           d.test ? probability(d.test->p) : "",
                           d.test ? fmt::format("{:+.2f}", d.test->effect) : ""});
  }
  return row;
}

std::string explanation(const Comparison& comparison) {
  std::string text =
      "`" + comparison.metric + "`; differences to `" + comparison.baseline +
      "` in runs of the same sequence, seed and other factors. Intervals: bootstrap of "
      "sequences, then of seeds. p: exact Wilcoxon signed rank test of the means of the "
      "sequences (of one sequence: of the seeds). Effect: rank-biserial correlation.";
  return oneLine(text);
}

TextTable tableOf(const Comparison& comparison) {
  TextTable table{heading(comparison), {}, {}};
  for (const Level& level : comparison.levels) table.rows.push_back(rowOf(level));
  return table;
}

}  // namespace

std::string markdownOf(const Comparison& comparison) {
  std::string text = markdownOf(tableOf(comparison)) + "\n" + explanation(comparison) + "\n";
  for (const std::string& note : comparison.notes) text += "\n" + oneLine(note) + "\n";
  return text;
}

std::string latexOf(const Comparison& comparison) {
  std::string text;
  for (const std::string& note : comparison.notes) text += "% " + oneLine(note) + "\n";
  return text + latexOf(tableOf(comparison)) + "% " + explanation(comparison) + "\n";
}

std::string csvOf(const Comparison& comparison) {
  std::string text = csvField(byText(comparison)) +
                     ",runs,mean,mean_low,mean_high,median,sd,min,max,pairs,difference,"
                     "difference_low,difference_high,p,effect\n";
  const auto exact = [](double value) { return fmt::format(",{:.17g}", value); };
  const auto range = [&](const std::optional<Interval>& interval) {
    return interval ? exact(interval->low) + exact(interval->high) : std::string(",,");
  };
  for (const Level& level : comparison.levels) {
    const Summary& s = level.summary;
    text += csvField(level.label) + fmt::format(",{}", s.n) + exact(s.mean) +
            range(level.interval) + exact(s.median) + (s.n > 1 ? exact(s.deviation) : ",") +
            exact(s.low) + exact(s.high);
    const auto& d = level.difference;
    text += d ? fmt::format(",{}", d->pairs) : ",";
    text += d && d->pairs > 0 ? exact(d->mean) + range(d->interval) : ",,,";
    text += d && d->test ? exact(d->test->p) + exact(d->test->effect) : ",,";
    text += "\n";
  }
  return text;
}

}  // namespace tolman::experiment
