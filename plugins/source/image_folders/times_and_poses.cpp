// SPDX-License-Identifier: BSD-3-Clause
#include "times_and_poses.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

#include "exact_decimal.hpp"
#include "text_file.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

/// Index of `column` in the header, which is the first of `lines`; removes this line from them.
std::optional<std::size_t> takeHeader(const fs::path& file, const std::string& column,
                                      std::vector<TextLine>& lines, Inspection& inspection) {
  if (lines.empty()) return std::nullopt;
  const std::string header = lines.front().text;
  const auto names = splitFields(header);
  const auto found = std::find(names.begin(), names.end(), column);
  if (found == names.end()) {
    inspection.error(file, lines.front().number,
                     "names no column " + inQuotes(column) + "; correct stamps_column");
    return std::nullopt;
  }
  if (std::find(found + 1, names.end(), column) != names.end()) {
    inspection.error(file, lines.front().number,
                     "names two columns " + inQuotes(column) + "; rename one of them");
    return std::nullopt;
  }
  lines.erase(lines.begin());
  return static_cast<std::size_t>(found - names.begin());
}

std::string nameOf(TimeUnit unit) {
  return unit == TimeUnit::Seconds ? "seconds" : std::string(enumName(unit));
}

/// Whether the field is a whole number of more than 12 digits, as ns and us since 1970 are.
bool isWhole(std::string_view field) {
  return field.size() > 12 && field.find_first_not_of("0123456789") == std::string_view::npos;
}

/// The time in a line, in ns.
std::optional<std::int64_t> parseTime(const fs::path& file, const TextLine& line,
                                      std::optional<std::size_t> column, TimeUnit unit,
                                      Inspection& inspection) {
  const auto fields = splitFields(line.text);
  if (fields.size() <= column.value_or(0) || (!column && fields.size() > 1)) {
    inspection.error(file, line.number,
                     "has " + std::to_string(fields.size()) +
                         (column ? " columns, fewer than the first line"
                                 : " columns; write one time a line, or set "
                                   "stamps_column"));
    return std::nullopt;
  }
  const std::string_view field = fields[column.value_or(0)];
  const std::optional<std::int64_t> ns = parseSeconds(field, digitsOf(unit));
  if (!ns) {
    inspection.error(file, line.number,
                     inQuotes(field) + " is no time in " + nameOf(unit) + "; correct it" +
                         (isWhole(field) ? ", or set stamps_unit (of `images`) to ns or us" : ""));
  } else if (*ns < 0) {
    inspection.error(
        file, line.number,
        inQuotes(field) +
            " is a time before 0, and times are counted from 0; add one number to all");
  }
  return ns;
}

/// 12 numbers to a rigid motion; the identity after an error.
Eigen::Isometry3d parsePose(const fs::path& file, const TextLine& line, Inspection& inspection) {
  constexpr double kTolerance = 1e-3;  // KITTI prints seven digits
  constexpr double kFarthest = 1e9;    // m; the bound of trajectories that are evaluated
  const auto fields = splitFields(line.text);
  if (fields.size() != 12) {
    inspection.error(
        file, line.number,
        "has " + std::to_string(fields.size()) + " numbers; a pose has 12, row by row");
    return Eigen::Isometry3d::Identity();
  }
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> M;
  for (int i = 0; i < 12; ++i) {
    const std::string_view field = fields[static_cast<std::size_t>(i)];
    const std::optional<double> number = parseNumber(field);
    if (!number) {
      inspection.error(file, line.number,
                       inQuotes(field) + " " + std::string(numberProblem(field)) +
                           "; correct the pose, or remove the file "
                           "to run without truth");
      return Eigen::Isometry3d::Identity();
    }
    M(i / 4, i % 4) = *number;
  }
  const Eigen::Matrix3d R = M.leftCols<3>();
  if (!(R.transpose() * R).isIdentity(kTolerance) || R.determinant() < 0) {
    inspection.error(file, line.number,
                     "its first three columns are no rotation; write camera-to-world poses");
    return Eigen::Isometry3d::Identity();
  }
  if ((M.col(3).array().abs() > kFarthest).any()) {
    inspection.error(file, line.number,
                     "its position is beyond 1e9 m; write metres, as the fourth, eighth and "
                     "twelfth number");
    return Eigen::Isometry3d::Identity();
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = M.col(3);
  return T;
}

/// What to do about times of another unit than the one in which they are read.
std::string otherUnit(TimeUnit unit) {
  return "is their unit another than " + nameOf(unit) +
         "? Set stamps_unit (of `images`; `euroc` reads nanoseconds, so use `images` with "
         "stamps_in_names for other units)";
}

/// Warns of median steps that cameras hardly have, such as seconds read as nanoseconds give them.
void checkShortStep(const fs::path& file, std::int64_t usual_ns, TimeUnit unit,
                    Inspection& inspection) {
  constexpr std::int64_t kShortest_ns = 100'000;  // 10 kHz
  if (usual_ns <= 0 || usual_ns >= kShortest_ns) return;
  inspection.warning(file, "has images " + std::to_string(usual_ns) +
                               " ns apart (median), more than 10000 a second, by times in " +
                               nameOf(unit) + "; " + otherUnit(unit));
}

/// Warns of gaps of more than a day that are also longer than a thousand median steps. Detects
/// times with a wrong unit by their median step: milliseconds read as seconds give cameras of 10 to
/// 100 Hz steps of 100 to 10 s, and no odometry can follow images that are so far apart.
void checkStep(const fs::path& file, const std::vector<std::int64_t>& times, TimeUnit unit,
               Inspection& inspection) {
  constexpr std::int64_t kDay_ns = 86'400'000'000'000;
  constexpr std::int64_t kUnusual_ns = 5'000'000'000;
  constexpr std::int64_t kImpossible_ns = 10'000'000'000;
  if (times.size() < 2) return;
  const std::int64_t usual = medianStep(times);
  checkShortStep(file, usual, unit, inspection);
  for (std::size_t i = 0; i + 1 < times.size(); ++i) {
    const std::int64_t step = times[i + 1] - times[i];
    if (step < kDay_ns || step / 1000 < usual) continue;
    inspection.warning(file, "image " + std::to_string(i + 1) + " is " +
                                 fixed(static_cast<double>(step) * 1e-9, 0) +
                                 " s after the one before; a realtime run waits as long");
  }
  if (usual <= kUnusual_ns) return;
  const std::string found =
      "has images " + fixed(static_cast<double>(usual) * 1e-9, 1) + " s apart (median); ";
  if (usual > kImpossible_ns) {
    inspection.error(file, found +
                               "times are in seconds: divide nanoseconds by 1e9, microseconds by "
                               "1e6, milliseconds by 1000, or set stamps_unit (of `images`)");
  } else {
    inspection.warning(file, found + "if the times are in milliseconds, divide them by 1000");
  }
}

/// Different numbers that are the same time were rounded to nanoseconds.
void reportEqual(const fs::path& before, const fs::path& file, TimeUnit unit,
                 Inspection& inspection) {
  const bool is_rounded =
      parseExactDecimal(before.stem().string()) != parseExactDecimal(file.stem().string());
  inspection.error(file,
                   "its name is the same time as that of " + before.filename().string() +
                       (is_rounded ? ", because times in " + nameOf(unit) +
                                         " are rounded to whole nanoseconds; " + otherUnit(unit)
                                   : "; correct one of the names, or remove one of the images"));
}

}  // namespace

std::int64_t medianStep(std::span<const std::int64_t> times) {
  std::vector<std::int64_t> steps(times.size() - 1);
  std::transform(times.begin() + 1, times.end(), times.begin(), steps.begin(), std::minus<>());
  const auto median = steps.begin() + std::ssize(steps) / 2;
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

std::vector<std::int64_t> readTimes(const fs::path& file, const std::string& column,
                                    Inspection& inspection, TimeUnit unit) {
  std::vector<TextLine> lines = readLines(file, inspection);
  std::optional<std::size_t> index;
  if (!column.empty()) {
    index = takeHeader(file, column, lines, inspection);
    if (!index) return {};
  }
  std::vector<std::int64_t> times;
  std::optional<std::int64_t> previous;
  bool sound = true;
  for (const TextLine& line : lines) {
    const std::optional<std::int64_t> ns = parseTime(file, line, index, unit, inspection);
    times.push_back(ns.value_or(0));
    if (ns && previous && *ns <= *previous) {
      const double back = static_cast<double>(*previous - *ns) * 1e-9;
      inspection.error(file, line.number,
                       back > 0 ? "time goes back by " + fixed(back, 6) + " s; sort the data"
                                : "has the time of the frame before; remove one of the two");
    }
    if (ns) previous = ns;
    sound = sound && ns;
  }
  if (sound) checkStep(file, times, unit, inspection);
  return times;
}

std::vector<std::int64_t> sortByTimes(std::vector<fs::path>& files, TimeUnit unit,
                                      Inspection& inspection) {
  constexpr std::int64_t kNone = std::numeric_limits<std::int64_t>::max();  // beyond all times
  std::vector<std::pair<std::int64_t, fs::path>> timed;
  for (const fs::path& file : files) {
    const std::optional<std::int64_t> ns = parseSeconds(file.stem().string(), digitsOf(unit));
    if (!ns) {
      inspection.error(
          file, "its name is no time in " + nameOf(unit) + "; name the file of times by stamps");
    }
    if (ns && *ns < 0) {
      inspection.error(
          file, "its name is a time before 0, and times are counted from 0; add one number to all");
    }
    timed.emplace_back(ns.value_or(kNone), file);
  }
  std::ranges::stable_sort(timed, {}, [](const auto& image) { return image.first; });
  std::vector<std::int64_t> times;
  for (std::size_t i = 0; i < timed.size(); ++i) {
    files[i] = timed[i].second;
    const bool is_time = timed[i].first != kNone;
    if (i > 0 && is_time && timed[i].first == timed[i - 1].first) {
      reportEqual(files[i - 1], files[i], unit, inspection);
    }
    times.push_back(is_time ? timed[i].first : 0);
  }
  if (!inspection.hasErrors() && !files.empty()) {
    checkStep(files.front().parent_path(), times, unit, inspection);
  }
  return times;
}

std::vector<Eigen::Isometry3d> readKittiPoses(const fs::path& file, Inspection& inspection,
                                              std::vector<int>* lines) {
  std::vector<Eigen::Isometry3d> poses;
  for (const TextLine& line : readLines(file, inspection)) {
    poses.push_back(parsePose(file, line, inspection));
    if (lines != nullptr) lines->push_back(line.number);
  }
  return poses;
}

void checkCount(const fs::path& file, std::size_t entries, std::size_t images,
                Inspection& inspection) {
  if (entries == 0 || images == 0 || entries == images) return;
  inspection.error(file, "has " + std::to_string(entries) + " entries, but there are " +
                             std::to_string(images) + " images; one line per image is needed");
}

}  // namespace tolman::image_folders
