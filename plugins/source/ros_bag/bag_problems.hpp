// SPDX-License-Identifier: BSD-3-Clause
// Texts for problems in a file of a bag, each with a remedy and without the name of the file.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tolman::ros_bag {

std::string atByte(std::uint64_t at);
/// The file ends before the record that begins at `at` does.
std::string endsWithin(std::uint64_t at);
/// The file ends at `at`, between two records, without its last record.
std::string hasNoEnd(std::uint64_t at);
std::string cannotBeRead(std::uint64_t at);
/// `what`: "a damaged message".
std::string hasPart(std::string_view what, std::uint64_t at);
/// `why`: "does not unpack".
std::string badChunk(std::uint64_t at, std::string_view why);
std::string chunkEndsWithin(std::uint64_t at);

}  // namespace tolman::ros_bag
