// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/text_table.hpp"

#include <string_view>

namespace tolman::experiment {
namespace {

std::string latexText(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (std::string_view("_%&#$").find(c) != std::string_view::npos) out += '\\';
    out += c;
  }
  return out;
}

template <class Text>
std::string joined(const std::vector<std::string>& row, const char* separator, Text&& text) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) line += (i == 0 ? "" : separator) + text(row[i]);
  return line;
}

}  // namespace

std::string markdownOf(const TextTable& table) {
  std::string text;
  const auto add = [&](const std::vector<std::string>& row) {
    for (const std::string& cell : row) text += "| " + cell + " ";
    text += "|\n";
  };
  add(table.heading);
  for (std::size_t i = 0; i < table.heading.size(); ++i) text += i == 0 ? "|---" : "|---:";
  text += "|\n";
  for (const auto& row : table.rows) add(row);
  return text;
}

std::string latexOf(const TextTable& table) {
  std::string text = "\\begin{tabular}{l" + std::string(table.heading.size() - 1, 'r') +
                     "}\n\\toprule\n" + joined(table.heading, " & ", latexText) +
                     " \\\\\n\\midrule\n";
  for (const auto& row : table.rows) text += joined(row, " & ", latexText) + " \\\\\n";
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string csvOf(const TextTable& table) {
  std::string text = joined(table.heading, ",", csvField) + "\n";
  for (const auto& row : table.rows) text += joined(row, ",", csvField) + "\n";
  return text;
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
