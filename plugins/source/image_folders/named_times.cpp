// SPDX-License-Identifier: BSD-3-Clause
#include "named_times.hpp"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>

#include "exact_decimal.hpp"
#include "image_listing.hpp"
#include "image_name.hpp"
#include "text_file.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

constexpr std::array kUnits = {TimeUnit::Seconds, TimeUnit::Milliseconds, TimeUnit::Microseconds,
                               TimeUnit::Nanoseconds};

/// The number at the end of a name, and what is before it: "cam0_", "12.5" of "cam0_12.5.png".
struct NumberedName {
  std::string before;
  std::string number;
};

std::optional<NumberedName> numberedName(const fs::path& image) {
  const std::string stem = image.stem().string();
  if (parseExactDecimal(stem)) return NumberedName{image.parent_path().string(), stem};
  std::size_t begin = stem.size();
  bool has_point = false;
  while (begin > 0 && (isDigit(stem[begin - 1]) || (stem[begin - 1] == '.' && !has_point))) {
    --begin;
    has_point = has_point || stem[begin] == '.';
  }
  if (begin < stem.size() && stem[begin] == '.') ++begin;  // that of "frame.12" separates
  if (!parseExactDecimal(stem.substr(begin))) return std::nullopt;
  return NumberedName{(image.parent_path() / stem.substr(0, begin)).string(), stem.substr(begin)};
}

/// The numbers of names that are alike otherwise; empty if one is not.
std::vector<std::string> numbersOf(const std::vector<fs::path>& images) {
  std::vector<std::string> numbers;
  std::string before;
  for (const fs::path& image : images) {
    std::optional<NumberedName> name = numberedName(image);
    if (!name || (!numbers.empty() && name->before != before)) return {};
    before = std::move(name->before);
    numbers.push_back(std::move(name->number));
  }
  return numbers;
}

std::size_t decimalsOf(const std::string& number) {
  const std::size_t point = number.find('.');
  return point == std::string::npos ? 0 : number.size() - point - 1;
}

std::size_t mostDecimals(const std::vector<std::string>& numbers) {
  std::size_t most = 0;
  for (const std::string& number : numbers) most = std::max(most, decimalsOf(number));
  return most;
}

/// Whole numbers of fewer digits than times in ms of a day number images.
bool mayBeCounters(const std::vector<std::string>& numbers) {
  constexpr std::size_t kMostDigits = 7;
  return mostDecimals(numbers) == 0 && std::ranges::all_of(numbers, [](const std::string& number) {
           const std::size_t first = number.find_first_not_of('0');
           return first == std::string::npos || number.size() - first <= kMostDigits;
         });
}

/// Times of the years 1980 to 2099. A number is one in one unit at most.
bool isSince1970(std::int64_t ns) {
  constexpr std::int64_t kFirst_ns = 315'532'800'000'000'000;
  constexpr std::int64_t kEnd_ns = 4'102'444'800'000'000'000;
  return ns >= kFirst_ns && ns < kEnd_ns;
}

/// Whether both lists are of one clock. Those with another start, as seconds since the first image
/// are, cannot be compared.
bool isSameClock(const std::vector<std::int64_t>& names, const std::vector<std::int64_t>& stamps) {
  constexpr std::int64_t kShareOfSpan = 10;  // chosen: rows that are shifted change it by frames
  const auto [first, last] = std::ranges::minmax(names);
  if (first < 0 || stamps.front() < 0) return false;
  if (isSince1970(stamps.front()) && isSince1970(first)) return isSince1970(last);
  const std::int64_t span = stamps.back() - stamps.front();
  const bool overlap = first <= stamps.back() && last >= stamps.front();
  return overlap && std::abs(last - first - span) <= span / kShareOfSpan;
}

/// The names as times.
struct NamedTimes {
  std::vector<std::int64_t> times_ns;
  std::int64_t resolution_ns = 0;  ///< of their last digit
};

std::optional<NamedTimes> timesIn(TimeUnit unit, const std::vector<std::string>& numbers,
                                  const std::vector<std::int64_t>& stamps) {
  NamedTimes names;
  for (const std::string& number : numbers) {
    const auto ns = parseSeconds(number, digitsOf(unit));
    if (!ns) return std::nullopt;
    names.times_ns.push_back(*ns);
  }
  if (!isSameClock(names.times_ns, stamps)) return std::nullopt;
  const int digits = digitsOf(unit) - static_cast<int>(mostDecimals(numbers));
  names.resolution_ns = parseSeconds("1", std::max(digits, 0)).value_or(0);
  return names;
}

std::optional<NamedTimes> namedTimes(const std::vector<std::string>& numbers,
                                     const std::vector<std::int64_t>& stamps, TimeUnit unit) {
  if (mayBeCounters(numbers)) return std::nullopt;
  if (auto names = timesIn(unit, numbers, stamps)) return names;
  for (const TimeUnit other : kUnits) {
    if (auto names = timesIn(other, numbers, stamps)) return names;
  }
  return std::nullopt;
}

/// Why the names, which are times, contradict those of the rows. Half a frame is the limit because
/// the time of another row is then nearer; the name may also be rounded.
std::optional<std::string> otherTimes(const std::vector<fs::path>& images, const NamedTimes& names,
                                      const std::vector<std::int64_t>& stamps) {
  const std::int64_t limit = std::max(medianStep(stamps) / 2, names.resolution_ns);
  std::optional<std::size_t> first;
  std::size_t count = 0;
  for (std::size_t i = 0; i < stamps.size(); ++i) {
    if (std::abs(names.times_ns[i] - stamps[i]) <= limit) continue;
    if (!first) first = i;
    ++count;
  }
  if (!first) return std::nullopt;
  const double apart = static_cast<double>(stamps[*first] - names.times_ns[*first]) * 1e-9;
  return "gives " + images[*first].filename().string() + " a time " + fixed(std::abs(apart), 6) +
         " s " + (apart < 0 ? "before" : "behind") +
         " that of its name (more than half a frame: " + std::to_string(count) + " of " +
         std::to_string(stamps.size()) +
         " rows); if the names are right, correct the times, or read the names as times (`images` "
         "with stamps_in_names)";
}

/// Why the numbers of the names contradict the order of the rows, by value and as text: "1.9" and
/// "1.10" rise as versions do.
std::optional<std::string> otherOrder(const std::vector<fs::path>& images,
                                      const std::vector<std::string>& numbers) {
  for (std::size_t i = 1; i < numbers.size(); ++i) {
    const bool falls = naturalLess(numbers[i], numbers[i - 1]) &&
                       parseExactDecimal(numbers[i]) < parseExactDecimal(numbers[i - 1]);
    if (!falls) continue;
    return "gives " + images[i].filename().string() + " a later time than " +
           images[i - 1].filename().string() +
           ", whose number is higher; if the numbers are the order of the images, sort the names "
           "in the table by them";
  }
  return std::nullopt;
}

/// Whether a field with a folder names a file that is there, but not in the folder of `image`.
bool isOfOtherFolder(std::string_view field, const fs::path& root, const fs::path& image) {
  const fs::path named = root / field;
  std::error_code ignored;
  return fs::path(field).has_parent_path() && fs::exists(named, ignored) &&
         !fs::equivalent(named.parent_path(), image.parent_path(), ignored);
}

/// A column that names images.
struct NamingColumn {
  std::size_t images = 0;              ///< values that are names of files in the folder
  std::optional<std::size_t> differs;  ///< the first row with the name of another image
};

NamingColumn namingColumn(const std::vector<std::vector<std::string_view>>& rows,
                          std::size_t column, const std::vector<fs::path>& images) {
  std::set<fs::path> names;
  for (const fs::path& image : images) names.insert(image.filename());
  NamingColumn found;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (column >= rows[i].size()) return {};
    const fs::path name = fs::path(rows[i][column]).filename();
    found.images += names.contains(name) ? 1 : 0;
    if (!found.differs && name != images[i].filename()) found.differs = i;
  }
  return found;
}

}  // namespace

void checkNamedTimes(const fs::path& table, const std::vector<fs::path>& images,
                     const std::vector<std::int64_t>& stamps_ns, TimeUnit unit,
                     Inspection& inspection) {
  if (stamps_ns.size() < 2 || stamps_ns.size() != images.size()) return;
  const std::vector<std::string> numbers = numbersOf(images);
  if (numbers.empty()) return;
  const auto names = namedTimes(numbers, stamps_ns, unit);
  auto contradiction = names ? otherTimes(images, *names, stamps_ns) : std::nullopt;
  if (!contradiction) contradiction = otherOrder(images, numbers);
  if (contradiction) inspection.warning(table, std::move(*contradiction));
}

void checkNamedRows(const fs::path& table, const fs::path& root,
                    const std::vector<fs::path>& images, Inspection& inspection) {
  std::vector<TextLine> lines = readLines(table, inspection);
  if (images.empty() || lines.size() != images.size() + 1) return;
  lines.erase(lines.begin());  // the header
  std::vector<std::vector<std::string_view>> rows;
  for (const TextLine& line : lines) rows.push_back(splitFields(line.text));
  NamingColumn best;
  std::size_t column = 0;
  for (std::size_t i = 0; i < rows.front().size(); ++i) {
    const std::string_view first = rows.front()[i];
    if (!isImage(first) || isOfOtherFolder(first, root, images.front())) continue;
    const NamingColumn found = namingColumn(rows, i, images);
    if (found.images == rows.size() && !found.differs) return;
    if (found.images <= best.images) continue;
    best = found;
    column = i;
  }
  if (!best.differs || 2 * best.images <= rows.size()) return;
  const std::size_t row = *best.differs;
  inspection.error(
      table, lines[row].number,
      "names " + inQuotes(rows[row][column]) + " where " + images[row].filename().string() +
          " is the next image of " + images[row].parent_path().string() +
          "; give each image the row with its name, in the order of the names of the images");
}

}  // namespace tolman::image_folders
