// SPDX-License-Identifier: BSD-3-Clause
// Texts for problems in a file of a bag, each with a remedy and without the name of the file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tolman::ros_bag {

/// Four digits: "37.2".
std::string shortNumber(double value);
std::string atByte(std::uint64_t at);
/// The file ends before the record that begins at `at` does.
std::string endsWithin(std::uint64_t at);
/// The file ends at `at`, between two records, without its last record.
std::string hasNoEnd(std::uint64_t at);
/// What follows the last message, from `at` on, is not what the format demands there.
std::string endsEarly(std::uint64_t at);
/// The index at the end of the file is missing or damaged. `why`: "does not match its check sum".
std::string badIndex(std::string_view why);
/// Messages that no other check sum covers.
std::string badDataSum();
/// `what`: "has a damaged message at byte 7, and 3 more like it"
std::string leftOut(const std::string& what);
/// "WHAT was recorded at -5 ns, before 1970"
std::string beforeEpoch(const std::string& what, std::int64_t log_ns);
/// `first`: "message 3 was recorded at -5 ns, before 1970".
std::string wrongClock(const std::string& first);
std::string cannotBeRead(std::uint64_t at);
/// `what`: "a damaged message".
std::string hasPart(std::string_view what, std::uint64_t at);
/// `why`: "does not unpack".
std::string badChunk(std::uint64_t at, std::string_view why);
std::string chunkEndsWithin(std::uint64_t at);

}  // namespace tolman::ros_bag
