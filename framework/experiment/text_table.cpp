// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/text_table.hpp"

#include <string_view>

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

}  // namespace tolman::experiment
