// SPDX-License-Identifier: BSD-3-Clause
#include "dates.hpp"

#include <array>
#include <chrono>
#include <optional>
#include <string_view>

#include "text_file.hpp"

namespace tolman::image_folders {
namespace {

/// `count` digits of the whole text.
std::optional<int> digits(std::string_view text, std::size_t count) {
  if (text.size() != count) return std::nullopt;
  int value = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    value = 10 * value + (c - '0');
  }
  return value;
}

/// "2011-09-26" to days since 1970.
std::optional<std::int64_t> parseDay(std::string_view text) {
  if (text.size() != 10 || text[4] != '-' || text[7] != '-') return std::nullopt;
  const auto year = digits(text.substr(0, 4), 4);
  const auto month = digits(text.substr(5, 2), 2);
  const auto day = digits(text.substr(8, 2), 2);
  if (!year || !month || !day) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(*year),
                                         std::chrono::month(static_cast<unsigned>(*month)),
                                         std::chrono::day(static_cast<unsigned>(*day))};
  if (!date.ok() || *year < 1900 || *year > 2200) return std::nullopt;
  return std::chrono::sys_days(date).time_since_epoch().count();
}

/// "13:02:25.964389445" to ns.
std::optional<std::int64_t> parseClock(std::string_view text) {
  if (text.size() < 8 || text[2] != ':' || text[5] != ':') return std::nullopt;
  const auto hour = digits(text.substr(0, 2), 2);
  const auto minute = digits(text.substr(3, 2), 2);
  const auto ns = parseSeconds(text.substr(6));
  if (!hour || !minute || !ns || *hour > 23 || *minute > 59) return std::nullopt;
  if (*ns < 0 || *ns >= 61'000'000'000) return std::nullopt;
  return (*hour * 60 + *minute) * 60'000'000'000LL + *ns;
}

}  // namespace

std::vector<std::int64_t> readDates(const std::filesystem::path& file, Inspection& inspection) {
  constexpr std::int64_t kDay_ns = 86'400'000'000'000;
  std::vector<std::int64_t> times;
  for (const TextLine& line : readLines(file, inspection)) {
    const auto fields = splitFields(line.text);
    const auto day = fields.size() == 2 ? parseDay(fields[0]) : std::nullopt;
    const auto clock = fields.size() == 2 ? parseClock(fields[1]) : std::nullopt;
    const std::int64_t time = day && clock ? *day * kDay_ns + *clock : 0;
    if (!day || !clock) {
      inspection.error(file, line.number,
                       "is no date and time such as 2011-09-26 13:02:25.964389445; correct it");
    } else if (!times.empty() && time <= times.back()) {
      inspection.error(file, line.number, "is no later than the line before; sort the data");
    }
    times.push_back(time);
  }
  return times;
}

}  // namespace tolman::image_folders
