// SPDX-License-Identifier: BSD-3-Clause
// Numbers from the record of a run, by SQL, and records that are changed after the run.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::test {

/// All rows that `query` gives on run.sqlite, every column as a number; fails the test where it
/// cannot be asked.
std::vector<std::vector<double>> recordRows(const std::filesystem::path& run,
                                            const std::string& query);

/// The same, as text: cells ended by '|', blobs by hex().
std::string recordText(const std::filesystem::path& run, const std::string& query);

/// Runs a statement that changes run.sqlite; fails the test where it cannot be run.
void editRecord(const std::filesystem::path& run, const std::string& statement);

}  // namespace tolman::test
