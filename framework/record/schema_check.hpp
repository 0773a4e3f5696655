// SPDX-License-Identifier: BSD-3-Clause
// Checks that a run.sqlite, which may come from anyone, is what a recorder writes.
#pragma once

#include "record/sqlite.hpp"

namespace tolman::record {

/// Throws BadRow for triggers, which would change what is written, and for views in place of
/// tables, whose rows may be computed without end.
void requireOwnTables(const Database& database);

/// Throws BadRow where a frame lacks the row of a stage that has others, or a stage has a row of a
/// frame that is missing: rows were removed. Also where a frame and its motion have two stamps.
void requireRowsOfFrames(const Database& database);

/// In table `run` of a record that was closed: the rowCounts() that it then had.
inline constexpr const char* kRowCountsKey = "rows";
/// How many rows each table of records has, as one text; without the arrays, which are large.
std::string rowCounts(const Database& database);

}  // namespace tolman::record
