// SPDX-License-Identifier: BSD-3-Clause
// A table for readers, as text, Markdown or LaTeX (booktabs), and for programs, as CSV or JSON.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace tolman::experiment {

/// All rows are as long as their heading.
struct Table {
  using Json = nlohmann::ordered_json;

  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;
  std::vector<std::string> notes{};  ///< sentences below the table; not in CSV
  std::string title{};               ///< line above the table; in text only

  // The columns and exact values for programs; empty where they are those for readers.
  std::vector<std::string> keys{};
  std::vector<std::vector<Json>> values{};  ///< texts, numbers, and null for what is not known
  Json about = Json::object();              ///< further members of the JSON
};

/// Columns aligned for a terminal.
std::string textOf(const Table& table);
/// The first column is left-aligned, the others right. The heading and the first column are labels,
/// which may contain marks of Markdown, but are plain text in LaTeX; the other cells may contain
/// marks of both. No character in a cell breaks the row.
std::string markdownOf(const Table& table);
/// Needs \usepackage{booktabs}.
std::string latexOf(const Table& table);
std::string csvOf(const Table& table);
/// An object with the members of `about`, `rows` (objects by the keys) and `notes`.
std::string jsonOf(const Table& table);

/// Rows and fields of a CSV file; quoted fields may hold commas, quotes and line breaks.
std::vector<std::vector<std::string>> csvRows(const std::string& text);

}  // namespace tolman::experiment
