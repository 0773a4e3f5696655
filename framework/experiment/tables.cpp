// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/tables.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "config/json_text.hpp"

namespace tolman::experiment {

namespace {

constexpr std::string_view kLineBreaks = "\n\r";

/// Replaces each character c by written(c).
template <class Written>
std::string escaped(const std::string& text, const Written& written) {
  std::string out;
  for (const char c : text) out += written(c);
  return out;
}

std::string markdownCell(const std::string& text) {
  return escaped(text, [](char c) {
    if (c == '|') return std::string("\\|");
    return std::string(1, kLineBreaks.find(c) == std::string_view::npos ? c : ' ');
  });
}

/// A label may contain marks of Markdown, such as those of code; backslashes are escaped.
std::string markdownLabel(const std::string& text) {
  return escaped(text, [](char c) {
    return c == '\\' ? std::string("\\\\") : markdownCell(std::string(1, c));
  });
}

std::string latexCell(const std::string& text) {
  return escaped(text, [](char c) {
    if (std::string_view("_%&#$").find(c) != std::string_view::npos) return std::string("\\") + c;
    return std::string(1, kLineBreaks.find(c) == std::string_view::npos ? c : ' ');
  });
}

std::string latexLabel(const std::string& text) {
  return escaped(text, [](char c) -> std::string {
    switch (c) {
      case '\\':
        return "\\textbackslash{}";
      case '{':
      case '}':
        return std::string("\\") + c;
      case '~':
        return "\\textasciitilde{}";
      case '^':
        return "\\textasciicircum{}";
      case '|':
        return "\\textbar{}";
      case '<':
        return "\\textless{}";
      case '>':
        return "\\textgreater{}";
      default:
        return latexCell(std::string(1, c));
    }
  });
}

template <class Label, class Text>
std::string joined(const std::vector<std::string>& row, const char* separator, const Label& label,
                   const Text& text) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    line += i == 0 ? label(row[i]) : separator + text(row[i]);
  }
  return line;
}

}  // namespace

std::string markdownOf(const TextTable& table) {
  const auto line = [](const std::vector<std::string>& row, const auto& text) {
    return "| " + joined(row, " | ", markdownLabel, text) + " |\n";
  };
  std::string text = line(table.heading, markdownLabel);
  for (std::size_t i = 0; i < table.heading.size(); ++i) text += i == 0 ? "|---" : "|---:";
  text += "|\n";
  for (const auto& row : table.rows) text += line(row, markdownCell);
  for (const std::string& note : table.notes) text += "\n" + oneLine(note) + "\n";
  return text;
}

std::string latexOf(const TextTable& table) {
  std::string text;
  for (const std::string& note : table.notes) text += "% " + oneLine(note) + "\n";
  text += "\\begin{tabular}{l" + std::string(table.heading.size() - 1, 'r') + "}\n\\toprule\n" +
          joined(table.heading, " & ", latexLabel, latexLabel) + " \\\\\n\\midrule\n";
  for (const auto& row : table.rows) text += joined(row, " & ", latexLabel, latexCell) + " \\\\\n";
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string csvOf(const TextTable& table) {
  std::string text = joined(table.heading, ",", csvField, csvField) + "\n";
  for (const auto& row : table.rows) text += joined(row, ",", csvField, csvField) + "\n";
  return text;
}

std::string oneLine(const std::string& text) {
  return escaped(text,
                 [](char c) { return kLineBreaks.find(c) == std::string_view::npos ? c : ' '; });
}

std::string csvField(const std::string& text) {
  if (text.find_first_of(",\"\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string("\"\"") : std::string(1, c);
  return field + '"';
}

std::vector<std::vector<std::string>> csvRows(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  bool quoted = false;
  bool at_begin = true;  // of a row
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (at_begin) rows.emplace_back(1);
    at_begin = false;
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      rows.back().back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      rows.back().emplace_back();
    } else if (!quoted && c == '\n') {
      at_begin = true;
    } else if (quoted || c != '\r') {
      rows.back().back() += c;
    }
  }
  return rows;
}

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

namespace {

using Json = nlohmann::ordered_json;

Json rangeOf(const std::optional<Interval>& interval) {
  if (!interval) return nullptr;
  return {{"low", interval->low}, {"high", interval->high}};
}

Json differenceOf(const std::optional<PairedDifference>& difference) {
  if (!difference) return nullptr;
  Json json = {{"pairs", difference->pairs},
               {"mean", nullptr},
               {"interval", rangeOf(difference->interval)},
               {"p", nullptr},
               {"effect", nullptr}};
  if (difference->pairs > 0) json["mean"] = difference->mean;
  if (difference->test) {
    json["p"] = difference->test->p;
    json["effect"] = difference->test->effect;
  }
  return json;
}

Json levelOf(const Level& level) {
  const Summary& s = level.summary;
  return {{"label", level.label},   {"runs", s.n},
          {"mean", s.mean},         {"interval", rangeOf(level.interval)},
          {"median", s.median},     {"sd", s.n > 1 ? Json(s.deviation) : Json()},
          {"min", s.low},           {"max", s.high},
          {"values", level.values}, {"difference", differenceOf(level.difference)}};
}

}  // namespace

std::string jsonOf(const Comparison& comparison) {
  Json json = {{"metric", comparison.metric},     {"by", comparison.by},
               {"baseline", comparison.baseline}, {"alignment", comparison.alignment},
               {"levels", Json::array()},         {"notes", comparison.notes}};
  for (const Level& level : comparison.levels) json["levels"].push_back(levelOf(level));
  return config::jsonText(json, 1) + "\n";
}

std::string jsonOf(const TextTable& table) {
  Json json = {{"rows", Json::array()}, {"notes", table.notes}};
  for (const auto& row : table.rows) {
    Json cells = Json::object();
    for (std::size_t k = 0; k < table.heading.size(); ++k) cells[table.heading[k]] = row[k];
    json["rows"].push_back(std::move(cells));
  }
  return config::jsonText(json, 1) + "\n";
}

}  // namespace tolman::experiment
