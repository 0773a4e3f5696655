// SPDX-License-Identifier: BSD-3-Clause
// A table of text as Markdown, LaTeX (booktabs) or CSV.
#pragma once

#include <string>
#include <vector>

#include "experiment/comparison.hpp"

namespace tolman::experiment {

struct TextTable {
  std::vector<std::string> heading;
  std::vector<std::vector<std::string>> rows;  ///< as long as the heading
  std::vector<std::string> notes;              ///< sentences below the table; not in CSV
};

/// The first column is left-aligned, the others right. The heading and the first column are labels,
/// which may contain marks of Markdown, but are plain text in LaTeX; the other cells may contain
/// marks of both. No character in a cell breaks the row.
std::string markdownOf(const TextTable& table);
std::string latexOf(const TextTable& table);
std::string csvOf(const TextTable& table);

/// Replaces line breaks by blanks, for a sentence below a table or a comment in LaTeX.
std::string oneLine(const std::string& text);

/// A text as one field of CSV.
std::string csvField(const std::string& text);
/// Rows and fields of a CSV file; quoted fields may hold commas, quotes and line breaks.
std::vector<std::vector<std::string>> csvRows(const std::string& text);

// A comparison as tables: Markdown, LaTeX with booktabs, CSV.

std::string markdownOf(const Comparison& comparison);
/// Needs \usepackage{booktabs}.
std::string latexOf(const Comparison& comparison);
std::string csvOf(const Comparison& comparison);

// Comparisons and tables as JSON, for programs.

/// An object with metric, factors, baseline, notes and a list of levels. Numbers are exact; what
/// is unknown, such as an interval of too few runs, is null.
std::string jsonOf(const Comparison& comparison);
/// An object with notes and a list of rows: objects of cells by their headings, as text.
std::string jsonOf(const TextTable& table);

}  // namespace tolman::experiment
