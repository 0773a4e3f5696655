// SPDX-License-Identifier: BSD-3-Clause
#include "record/reference.hpp"

#include "record/schema.hpp"
#include "record/views.hpp"

namespace tolman::record {
namespace {

const char* const kIntroduction =
    "# Tables of run.sqlite\n\n"
    "Generated from the field lists of the records; do not edit. Schema version ";

const char* const kConventions =
    ".\n\n"
    "Poses are seven columns, position `_x _y _z` and unit quaternion `_qx _qy _qz _qw` with\n"
    "`_qw >= 0`; `T_a_b` takes points of b to a. Matrices and arrays are little-endian, row-major\n"
    "blobs. Booleans are 0 or 1. Records of one frame are joined by `frame`.\n\n"
    "Names of columns that are words of SQL must be quoted: `SELECT \"from\", \"to\" FROM link`.\n"
    "Views for queries by hand need no quotes; records of earlier versions do not have them, and\n"
    "headings need an SQLite with mathematical functions:\n\n";

std::string tableMarkdown(const Table& table) {
  std::string text = "\n## " + table.name + "\n\n" + table.doc + "\n\n";
  text += "| column | type | unit | meaning |\n|---|---|---|---|\n";
  for (const Column& column : table.columns) {
    text += "| `" + column.name + "` | " + column.type + " | " + column.unit + " | " + column.doc +
            " |\n";
  }
  return text;
}

}  // namespace

std::string recordsMarkdown() {
  std::string text = kIntroduction + std::to_string(kSchemaVersion) + kConventions;
  for (const SqlView& view : views()) text += "- `" + view.name + "`: " + view.doc + "\n";
  for (const Table& table : schema()) text += tableMarkdown(table);
  return text;
}

}  // namespace tolman::record
