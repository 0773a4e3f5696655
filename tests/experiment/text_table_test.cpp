// SPDX-License-Identifier: BSD-3-Clause
// Labels of any characters in tables of Markdown, LaTeX and CSV.
#include <catch2/catch.hpp>

#include "experiment/tables.hpp"

using namespace tolman::experiment;

namespace {

/// A table whose labels are `label`, with one cell.
Table tableOf(const std::string& label, const std::string& cell = "1") {
  return {{label, label}, {{label, cell}}, {}};
}

}  // namespace

TEST_CASE("quoted fields of CSV") {
  const std::string field = "a \"b\", c\nd";
  CHECK(csvOf(tableOf(field)) ==
        "\"a \"\"b\"\", c\nd\",\"a \"\"b\"\", c\nd\"\n\"a \"\"b\"\", c\nd\",1\n");
  CHECK(csvRows(csvOf(tableOf(field)) + "\n") ==
        std::vector<std::vector<std::string>>{{field, field}, {field, "1"}, {""}});
}

TEST_CASE("labels with bars, line breaks and backslashes keep the rows of a Markdown table") {
  CHECK(markdownOf(tableOf("a|b\nc\\d")) ==
        "| a\\|b c\\\\d | a\\|b c\\\\d |\n|---|---:|\n| a\\|b c\\\\d | 1 |\n");
  CHECK(markdownOf(tableOf("plain_name, `b=1`")) ==
        "| plain_name, `b=1` | plain_name, `b=1` |\n|---|---:|\n| plain_name, `b=1` | 1 |\n");
}

TEST_CASE("cells are as they were formatted, but for bars and line breaks") {
  CHECK(markdownOf(tableOf("a", "**1**|\n2")).ends_with("| a | **1**\\| 2 |\n"));
  CHECK(latexOf(tableOf("a", "\\textbf{1}\n2")).find("a & \\textbf{1} 2 \\\\\n") !=
        std::string::npos);
}

TEST_CASE("every character of a label is text in LaTeX") {
  const std::string text = latexOf(tableOf("a\\b{c}~^|<>_%&#$\nd"));
  const std::string label =
      "a\\textbackslash{}b\\{c\\}\\textasciitilde{}\\textasciicircum{}\\textbar{}\\textless{}"
      "\\textgreater{}\\_\\%\\&\\#\\$ d";
  CHECK(text == "\\begin{tabular}{lr}\n\\toprule\n" + label + " & " + label + " \\\\\n\\midrule\n" +
                    label + " & 1 \\\\\n\\bottomrule\n\\end{tabular}\n");
}

TEST_CASE("CSV has labels as they are, and no notes; elsewhere a note is one line") {
  Table table = tableOf("a|b\nc\\d");
  table.notes = {"two\nlines"};
  CHECK(csvRows(csvOf(table)) ==
        std::vector<std::vector<std::string>>{{"a|b\nc\\d", "a|b\nc\\d"}, {"a|b\nc\\d", "1"}});
  CHECK(markdownOf(table).ends_with("\n\ntwo lines\n"));
  CHECK(latexOf(table).starts_with("% two lines\n\\begin"));
}
