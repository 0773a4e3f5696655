// SPDX-License-Identifier: BSD-3-Clause
// A recorded run whose run.sqlite was changed by a stranger: without the types, keys and conditions
// of our tables.
//
// Each line of an input changes values or removes rows:
//   TABLE.COLUMN ROW KIND VALUE     KIND: i integer, r real, t text, b blob as hex digits, n NULL
//   - TABLE ROW                     removes the row
//   + TABLE ROW                     adds a copy of the row
// ROW counts from 1; * is all. What names no table, column or row changes nothing.
#pragma once

#include <filesystem>
#include <string_view>

namespace tolman::fuzz {

/// Writes run.sqlite of a short run with these changes into `folder`.
void writeEditedRecord(const std::filesystem::path& folder, std::string_view edits);

/// All that is in a record, as every reader of the library takes it.
void readEverything(const std::filesystem::path& folder);

}  // namespace tolman::fuzz
