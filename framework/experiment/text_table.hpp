// SPDX-License-Identifier: BSD-3-Clause
// A table of text as Markdown, LaTeX (booktabs) or CSV.
#pragma once

#include <string>
#include <vector>

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

}  // namespace tolman::experiment
