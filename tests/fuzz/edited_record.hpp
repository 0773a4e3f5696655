// SPDX-License-Identifier: BSD-3-Clause
// A recorded run with a changed run.sqlite, without the types, keys and conditions of its tables.
//
// Each line of an input changes values or removes rows:
//   TABLE.COLUMN ROW KIND VALUE     KIND: i integer, r real, t text, b blob as hex digits, n NULL
//   - TABLE ROW                     removes the row
//   + TABLE ROW                     adds a copy of the row
// ROW counts from 1; * is all. Lines without an existing table, column or row have no effect.
#pragma once

#include <filesystem>
#include <string_view>

namespace tolman::fuzz {

/// Writes run.sqlite of a short run with these changes into `folder`.
void writeEditedRecord(const std::filesystem::path& folder, std::string_view edits);

/// All that is in a record, as every reader of the library takes it.
void readEverything(const std::filesystem::path& folder);

}  // namespace tolman::fuzz
