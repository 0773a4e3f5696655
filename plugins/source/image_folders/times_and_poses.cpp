// SPDX-License-Identifier: BSD-3-Clause
#include "times_and_poses.hpp"

#include <algorithm>
#include <chrono>

#include "base/text_file.hpp"
#include "data_error.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;
using text_encoding::inQuotes;
using text_encoding::parseSeconds;
using text_encoding::TextLine;

namespace {

using Fields = std::vector<std::string_view>;

/// Decimal exponent of the unit in nanoseconds: 9, 6, 3, 0.
int digitsOf(TimeUnit unit) { return 9 - 3 * static_cast<int>(unit); }

std::vector<TextLine> linesOf(const fs::path& file) {
  std::vector<TextLine> lines =
      text_encoding::contentLines(source_parameters::valueOf(text_encoding::readText(file)));
  if (lines.empty()) throw DataError(file, "is empty; restore it");
  return lines;
}

std::int64_t timeOf(const fs::path& file, int line, std::string_view field, TimeUnit unit) {
  const std::optional<std::int64_t> ns = parseSeconds(field, digitsOf(unit));
  if (ns && *ns >= 0) return *ns;
  throw DataError(file, line,
                  inQuotes(field) + " is no time in " + std::string(enumName(unit)) +
                      " from 0; correct it, or set stamps_unit (of `images`)");
}

bool isCount(std::string_view field) {
  return field.find_first_not_of("0123456789") == std::string_view::npos;
}

/// `count` numbers of the fields from `first` on.
std::vector<double> numbersOf(const fs::path& file, const TextLine& line, const Fields& fields,
                              std::size_t first, std::size_t count) {
  if (fields.size() != first + count) {
    throw DataError(file, line.number,
                    "has " + std::to_string(fields.size()) + " numbers instead of " +
                        std::to_string(first + count) + "; correct the pose");
  }
  std::vector<double> numbers;
  for (std::size_t i = first; i < fields.size(); ++i) {
    const auto number = text_encoding::parseNumber(fields[i]);
    if (!number) {
      throw DataError(file, line.number,
                      inQuotes(fields[i]) + " " +
                          std::string(text_encoding::numberProblem(fields[i])) +
                          "; correct the pose");
    }
    numbers.push_back(*number);
  }
  return numbers;
}

/// `count` digits at `at`, which follow the character `before` (0: none); -1 for others.
int digitsAt(std::string_view text, std::size_t at, std::size_t count, char before) {
  if (text.size() < at + count || (before != 0 && text[at - 1] != before)) return -1;
  int value = 0;
  for (const char c : text.substr(at, count)) {
    if (c < '0' || c > '9') return -1;
    value = 10 * value + (c - '0');
  }
  return value;
}

/// "2011-09-26", "13:02:25.964389445" to ns since 1970, as if it were UTC.
std::optional<std::int64_t> dateOf(std::string_view day, std::string_view clock) {
  const int year = digitsAt(day, 0, 4, 0);
  const int month = digitsAt(day, 5, 2, '-');
  const int of_month = digitsAt(day, 8, 2, '-');
  const int hour = digitsAt(clock, 0, 2, 0);
  const int minute = digitsAt(clock, 3, 2, ':');
  const bool has_seconds = digitsAt(clock, 6, 2, ':') >= 0;
  const std::int64_t ns = has_seconds ? parseSeconds(clock.substr(6)).value_or(-1) : -1;
  const bool in_range = year >= 1970 && year <= 2100 && month > 0 && of_month > 0 && hour >= 0 &&
                        hour <= 23 && minute >= 0 && minute <= 59 && ns >= 0 &&
                        ns < 61'000'000'000 && day.size() == 10;
  if (!in_range) return std::nullopt;
  const std::chrono::year_month_day date{std::chrono::year(year),
                                         std::chrono::month(static_cast<unsigned>(month)),
                                         std::chrono::day(static_cast<unsigned>(of_month))};
  if (!date.ok()) return std::nullopt;
  const std::int64_t days = std::chrono::sys_days(date).time_since_epoch().count();
  return ((days * 24 + hour) * 60 + minute) * 60'000'000'000 + ns;
}

Eigen::Isometry3d kittiPose(const fs::path& file, const TextLine& line) {
  constexpr double kTolerance = 1e-3;  // KITTI prints seven digits
  constexpr double kFarthest = 1e9;    // m; the bound of trajectories that are evaluated
  const std::vector<double> numbers =
      numbersOf(file, line, text_encoding::splitFields(line.text), 0, 12);
  const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> M(numbers.data());
  const Eigen::Matrix3d R = M.leftCols<3>();
  if (!(R.transpose() * R).isIdentity(kTolerance) || R.determinant() < 0) {
    throw DataError(file, line.number,
                    "has no rotation in its first three columns; write camera-to-world poses");
  }
  if ((M.col(3).array().abs() > kFarthest).any()) {
    throw DataError(file, line.number, "has a position beyond 1e9 m; write metres");
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = M.col(3);
  return T;
}

}  // namespace

ImageTimes readTimes(const fs::path& file, const std::string& column, TimeUnit unit) {
  std::vector<TextLine> lines = linesOf(file);
  std::size_t index = 0;
  std::size_t columns = 0;  // 0: any number of them
  if (!column.empty()) {
    const Fields names = text_encoding::splitFields(lines.front().text);
    index = static_cast<std::size_t>(std::ranges::find(names, column) - names.begin());
    if (index == names.size()) {
      throw DataError(file, lines.front().number,
                      "names no column " + inQuotes(column) + "; correct stamps_column");
    }
    lines.erase(lines.begin());
  } else {
    const Fields first = text_encoding::splitFields(lines.front().text);
    const bool exposed = first.size() == 3 && isCount(first[0]);
    columns = exposed ? 3 : 1;
    index = exposed ? 1 : 0;
  }
  ImageTimes times;
  for (const TextLine& line : lines) {
    const Fields fields = text_encoding::splitFields(line.text);
    if (fields.size() <= index || (columns > 0 && fields.size() != columns)) {
      throw DataError(file, line.number,
                      "has " + std::to_string(fields.size()) + " columns; " +
                          (column.empty() ? "write one time a line, or set stamps_column"
                                          : "complete the line"));
    }
    times.stamps_ns.push_back(timeOf(file, line.number, fields[index], unit));
    if (columns != 3) continue;
    const auto exposure_ms = text_encoding::parseNumber(fields[2]);
    if (!exposure_ms) {
      throw DataError(file, line.number,
                      inQuotes(fields[2]) + " is no exposure time in ms; correct it");
    }
    times.exposure_ms.push_back(static_cast<float>(*exposure_ms));
  }
  return times;
}

std::vector<std::int64_t> readDates(const fs::path& file) {
  std::vector<std::int64_t> times;
  for (const TextLine& line : linesOf(file)) {
    const Fields fields = text_encoding::splitFields(line.text);
    const auto ns = fields.size() == 2 ? dateOf(fields[0], fields[1]) : std::nullopt;
    if (!ns) {
      throw DataError(file, line.number,
                      "is no date and time such as 2011-09-26 13:02:25.964389445; correct it");
    }
    times.push_back(*ns);
  }
  return times;
}

StampedFiles readStampedFiles(const fs::path& file, TimeUnit unit, const fs::path& folder,
                              FindingCollector& findings) {
  StampedFiles list;
  for (const TextLine& line : linesOf(file)) {
    const Fields fields = text_encoding::splitFields(line.text);
    if (fields.size() != 2) throw DataError(file, line.number, "is not 'TIME FILE'; correct it");
    const std::int64_t ns = timeOf(file, line.number, fields[0], unit);
    if (!list.stamps_ns.empty() && ns <= list.stamps_ns.back()) {
      findings.add({Finding::Severity::Error, file.string() + ":" + std::to_string(line.number),
                    "is no later than the line before", "sort the file",
                    Finding::Kind::Contradiction});
      continue;
    }
    list.stamps_ns.push_back(ns);
    list.files.push_back(folder / fields[1]);
  }
  return list;
}

StampedFiles sortedByTimes(std::vector<fs::path> images, TimeUnit unit) {
  std::vector<std::pair<std::int64_t, fs::path>> timed;
  for (fs::path& image : images) {
    timed.emplace_back(timeOf(image, 0, image.stem().string(), unit), std::move(image));
  }
  std::ranges::sort(timed);
  StampedFiles sorted;
  for (auto& [stamp, image] : timed) {
    sorted.stamps_ns.push_back(stamp);
    sorted.files.push_back(std::move(image));
  }
  return sorted;
}

std::vector<Eigen::Isometry3d> readKittiPoses(const fs::path& file) {
  std::vector<Eigen::Isometry3d> poses;
  for (const TextLine& line : linesOf(file)) poses.push_back(kittiPose(file, line));
  return poses;
}

}  // namespace tolman::image_folders
