// SPDX-License-Identifier: BSD-3-Clause
#include "bag_problems.hpp"

#include <array>
#include <cstdio>

namespace tolman::ros_bag {
namespace {

constexpr const char* kCutOff =
    ": the recording was cut off; use what is there by on_corrupt: skip";

}  // namespace

std::string shortNumber(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value);
  return text.data();
}

std::string atByte(std::uint64_t at) { return " at byte " + std::to_string(at); }

std::string endsWithin(std::uint64_t at) { return "ends within the record" + atByte(at) + kCutOff; }

std::string hasNoEnd(std::uint64_t at) { return "has no end" + atByte(at) + kCutOff; }

std::string endsEarly(std::uint64_t at) {
  return "has a damaged record" + atByte(at) +
         ", which ends the messages before the index begins; copy the file again, or use what is "
         "before it by on_corrupt: skip";
}

std::string badIndex(std::string_view why) {
  return "the index at its end " + std::string(why) +
         ", so it is not known whether messages are missing; copy the file again, or use what is "
         "there by on_corrupt: skip";
}

std::string badDataSum() {
  return "the messages do not match the check sum of the file; copy the file again, or use them as "
         "they are by on_corrupt: skip";
}

std::string leftOut(const std::string& what) {
  return what + "; copy the bag again, or leave such messages out by on_corrupt: skip";
}

std::string beforeEpoch(const std::string& what, std::int64_t log_ns) {
  return what + " was recorded at " + std::to_string(log_ns) + " ns, before 1970";
}

std::string wrongClock(const std::string& first) {
  return first +
         ": the clock was wrong; correct the times of recording, or leave such messages out by "
         "on_corrupt: skip";
}

std::string cannotBeRead(std::uint64_t at) {
  return "cannot be read" + atByte(at) + "; check the disk";
}

std::string hasPart(std::string_view what, std::uint64_t at) {
  return "has " + std::string(what) + atByte(at) +
         "; copy it again, or leave it out by on_corrupt: skip";
}

std::string badChunk(std::uint64_t at, std::string_view why) {
  return "the chunk" + atByte(at) + " " + std::string(why) +
         "; copy the file again, or leave it out by on_corrupt: skip";
}

std::string chunkEndsWithin(std::uint64_t at) {
  return "the chunk" + atByte(at) +
         " ends within a record; record it again, or leave it out by on_corrupt: skip";
}

}  // namespace tolman::ros_bag
