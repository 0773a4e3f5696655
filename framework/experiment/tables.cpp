// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/tables.hpp"

#include <algorithm>
#include <map>

#include "config/json_text.hpp"
#include "config/values.hpp"

namespace tolman::experiment {
namespace {

using Escapes = std::map<char, std::string>;

const Escapes kLine = {{'\n', " "}, {'\r', " "}};
const Escapes kMarkdownCell = {{'\n', " "}, {'\r', " "}, {'|', "\\|"}};
const Escapes kMarkdownLabel = {{'\n', " "}, {'\r', " "}, {'|', "\\|"}, {'\\', "\\\\"}};
const Escapes kLatexCell = {{'\n', " "},  {'\r', " "},  {'_', "\\_"}, {'%', "\\%"},
                            {'&', "\\&"}, {'#', "\\#"}, {'$', "\\$"}};
const Escapes kLatexLabel = [] {
  Escapes label = {{'\\', "\\textbackslash{}"},
                   {'{', "\\{"},
                   {'}', "\\}"},
                   {'~', "\\textasciitilde{}"},
                   {'^', "\\textasciicircum{}"},
                   {'|', "\\textbar{}"},
                   {'<', "\\textless{}"},
                   {'>', "\\textgreater{}"}};
  label.insert(kLatexCell.begin(), kLatexCell.end());
  return label;
}();

std::string escaped(const std::string& text, const Escapes& escapes) {
  std::string out;
  for (const char c : text) {
    const auto found = escapes.find(c);
    found == escapes.end() ? out += c : out += found->second;
  }
  return out;
}

std::string joined(const std::vector<std::string>& row, const char* separator, const Escapes& label,
                   const Escapes& cell) {
  std::string line;
  for (std::size_t i = 0; i < row.size(); ++i) {
    line += i == 0 ? escaped(row[i], label) : separator + escaped(row[i], cell);
  }
  return line;
}

std::string csvLine(const std::vector<std::string>& fields) {
  std::string line;
  for (const std::string& field : fields) {
    if (&field != &fields.front()) line += ',';
    const bool is_quoted = field.find_first_of(",\"\n\r") != std::string::npos;
    line += is_quoted ? "\"" + escaped(field, {{'"', "\"\""}}) + "\"" : field;
  }
  return line + "\n";
}

std::string fieldOf(const Table::Json& value) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_float()) return config::writeReal(value.get<double>());
  return value.is_null() ? "" : value.dump();
}

/// The table for programs.
Table exact(const Table& table) {
  Table programs = table;
  if (!table.keys.empty()) return programs;
  programs.keys = table.heading;
  for (const auto& row : table.rows) programs.values.emplace_back(row.begin(), row.end());
  return programs;
}

}  // namespace

std::string textOf(const Table& table) {
  const auto width = [](const std::string& cell) {  // characters of UTF-8
    const auto begins = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; };
    return static_cast<std::size_t>(std::ranges::count_if(cell, begins));
  };
  std::vector<std::size_t> widths(table.heading.size(), 0);
  std::vector<std::vector<std::string>> lines = table.rows;
  lines.insert(lines.begin(), table.heading);
  for (const auto& line : lines) {
    for (std::size_t k = 0; k < line.size(); ++k) widths[k] = std::max(widths[k], width(line[k]));
  }
  std::string text = table.title.empty() ? "" : table.title + "\n";
  for (const auto& line : lines) {
    std::string out;
    for (std::size_t k = 0; k < line.size(); ++k) {
      const std::string gap(widths[k] - width(line[k]), ' ');
      out += k == 0 ? line[k] + gap : "  " + gap + line[k];
    }
    text += out.substr(0, out.find_last_not_of(' ') + 1) + "\n";
  }
  for (const std::string& note : table.notes) text += note + "\n";
  return text;
}

std::string markdownOf(const Table& table) {
  const auto line = [](const std::vector<std::string>& row, const Escapes& cell) {
    return "| " + joined(row, " | ", kMarkdownLabel, cell) + " |\n";
  };
  std::string text = line(table.heading, kMarkdownLabel);
  for (std::size_t i = 0; i < table.heading.size(); ++i) text += i == 0 ? "|---" : "|---:";
  text += "|\n";
  for (const auto& row : table.rows) text += line(row, kMarkdownCell);
  for (const std::string& note : table.notes) text += "\n" + escaped(note, kLine) + "\n";
  return text;
}

std::string latexOf(const Table& table) {
  std::string text;
  for (const std::string& note : table.notes) text += "% " + escaped(note, kLine) + "\n";
  text += "\\begin{tabular}{l" + std::string(table.heading.size() - 1, 'r') + "}\n\\toprule\n" +
          joined(table.heading, " & ", kLatexLabel, kLatexLabel) + " \\\\\n\\midrule\n";
  for (const auto& row : table.rows) {
    text += joined(row, " & ", kLatexLabel, kLatexCell) + " \\\\\n";
  }
  return text + "\\bottomrule\n\\end{tabular}\n";
}

std::string csvOf(const Table& table) {
  const Table programs = exact(table);
  std::string text = csvLine(programs.keys);
  for (const auto& row : programs.values) {
    std::vector<std::string> fields;
    for (const Table::Json& value : row) fields.push_back(fieldOf(value));
    text += csvLine(fields);
  }
  return text;
}

std::string jsonOf(const Table& table) {
  const Table programs = exact(table);
  Table::Json json = programs.about;
  json["rows"] = Table::Json::array();
  for (const auto& row : programs.values) {
    Table::Json members = Table::Json::object();
    for (std::size_t k = 0; k < row.size(); ++k) members[programs.keys[k]] = row[k];
    json["rows"].push_back(std::move(members));
  }
  json["notes"] = programs.notes;
  return config::jsonText(json, 1) + "\n";
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
