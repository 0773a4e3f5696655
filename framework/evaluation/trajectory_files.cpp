// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory_files.hpp"

#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

#include "base/number_text.hpp"
#include "base/text_encoding.hpp"

namespace tolman::evaluation {
namespace {

// Rotations in files are rounded; a matrix with a larger error is not accepted as a rotation.
constexpr double kRotationTolerance = 1e-2;
// Largest position, m: beyond any vehicle, and the squares of all errors are finite.
constexpr double kLargestPosition = 1e9;
// Largest stamp, s (the year 2096): differences of two stamps in ns fit into 64 bits.
constexpr double kLatest = 4e9;

/// What is wrong with a line; the reader adds file and line.
struct LineError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The word as it can be shown: short, printable.
std::string shown(std::string_view word) {
  std::string text = "'";
  for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (word.size() > 24 ? "...'" : "'");
}

std::vector<std::string_view> words(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r,";
  line = line.substr(0, line.find('#'));
  std::vector<std::string_view> result;
  for (std::size_t begin = line.find_first_not_of(kBlank); begin != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlank, begin), line.size());
    result.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(kBlank, end);
  }
  return result;
}

double number(std::string_view word) {
  const std::optional<double> value = text_encoding::parseNumber(word);
  if (value) return *value;
  throw LineError(shown(word) + " " + std::string(text_encoding::numberProblem(word)));
}

double coordinate(std::string_view word) {
  const double metres = number(word);
  if (std::abs(metres) <= kLargestPosition) return metres;
  throw LineError("position " + shown(word) + " is too large; positions are metres");
}

/// Seconds to nanoseconds; a plain decimal is converted without double, which would round it.
std::int64_t stampNs(std::string_view word) {
  const double seconds = number(word);
  if (std::abs(seconds) > kLatest) {
    throw LineError("stamp " + shown(word) +
                    " is too large; stamps are seconds: divide ns by 1e9, us by 1e6 and ms by 1e3");
  }
  const std::size_t point = std::min(word.find('.'), word.size());
  const bool plain = word.find_first_not_of("0123456789.") == std::string_view::npos;
  if (!plain) return std::llround(seconds * 1e9);
  std::string digits(word.substr(0, point));
  std::string decimals(word.substr(std::min(point + 1, word.size())));
  decimals.resize(9, '0');
  digits += decimals;
  std::int64_t stamp = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), stamp);
  return stamp;
}

Eigen::Matrix3d checkedRotation(const Eigen::Matrix3d& R) {
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < kRotationTolerance) || R.determinant() < 0) {
    throw LineError("the rotation part is not a rotation matrix");
  }
  return Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

TrajectoryPose tumPose(const std::vector<std::string_view>& entries) {
  if (entries.size() != 8) {
    throw LineError("expected 8 numbers (stamp tx ty tz qx qy qz qw), found " +
                    std::to_string(entries.size()));
  }
  TrajectoryPose pose;
  pose.stamp_ns = stampNs(entries[0]);
  Eigen::Matrix<double, 7, 1> v;
  for (int i = 0; i < 7; ++i) {
    const std::string_view word = entries[static_cast<std::size_t>(i) + 1];
    v[i] = i < 3 ? coordinate(word) : number(word);
  }
  const Eigen::Quaterniond q(v[6], v[3], v[4], v[5]);
  if (std::abs(q.norm() - 1) > kRotationTolerance) {
    throw LineError("the quaternion has length " + std::to_string(q.norm()) + " instead of 1");
  }
  pose.T_world_camera.translation() = v.head<3>();
  pose.T_world_camera.linear() = q.normalized().toRotationMatrix();
  return pose;
}

TrajectoryPose kittiPose(const std::vector<std::string_view>& entries) {
  if (entries.size() != 12) {
    throw LineError("expected 12 numbers (rows of a 3x4 pose), found " +
                    std::to_string(entries.size()));
  }
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> rows;
  for (std::size_t i = 0; i < 12; ++i) {
    rows.data()[i] = i % 4 == 3 ? coordinate(entries[i]) : number(entries[i]);
  }
  TrajectoryPose pose;
  pose.T_world_camera.linear() = checkedRotation(rows.leftCols<3>());
  pose.T_world_camera.translation() = rows.col(3);
  return pose;
}

using LineReader = TrajectoryPose (*)(const std::vector<std::string_view>&);

LineReader formatOf(const std::vector<std::string_view>& entries) {
  if (entries.size() == 8) return tumPose;
  if (entries.size() == 12) return kittiPose;
  throw LineError("neither a TUM pose (8 numbers) nor a KITTI pose (12 numbers): found " +
                  std::to_string(entries.size()) + " entries");
}

/// Whether this is a pose of a EuRoC or TUM-VI CSV file: commas, and a stamp in whole ns.
bool isEuroc(std::string_view line, std::string_view first_word) {
  constexpr std::size_t kDigits = 16;  // in ns, of any time since February 1970; more than seconds
  return line.find(',') != std::string_view::npos && first_word.size() >= kDigits &&
         first_word.find_first_not_of("0123456789") == std::string_view::npos;
}

void append(Trajectory& trajectory, TrajectoryPose pose, bool has_stamps) {
  if (has_stamps && !trajectory.empty() && pose.stamp_ns <= trajectory.back().stamp_ns) {
    throw LineError("the stamp does not increase; sort the file and remove duplicates");
  }
  pose.frame = static_cast<std::int64_t>(trajectory.size());
  trajectory.push_back(pose);
}

/// Detects a file that was cut within the last number of a line: the last line has no line break,
/// and its last number has fewer decimals than that of every line before.
class CutLine {
 public:
  void check(std::string_view last_word, bool has_end) {
    const std::size_t decimals = last_word.size() - std::min(last_word.find('.'), last_word.size());
    if (!has_end && lines_ >= 2 && decimals < fewest_) {
      throw LineError("the file ends within this line, its last number " + shown(last_word) +
                      " is cut; put back the whole file");
    }
    fewest_ = std::min(fewest_, decimals);
    ++lines_;
  }

 private:
  std::size_t fewest_ = std::string_view::npos;
  int lines_ = 0;
};

/// Of a file, or of what comes through a pipe until its end.
Result<std::string> textOf(const std::filesystem::path& path) {
  constexpr std::size_t kMost = std::size_t{1} << 30;
  if (std::filesystem::is_directory(path)) return Status::invalidInput("is a folder; give a file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    const std::string why = std::generic_category().message(errno);
    return Status::invalidInput("cannot be read (" + why + "); check path and permissions");
  }
  std::string text;
  std::array<char, 1 << 16> bytes;
  while (stream.read(bytes.data(), bytes.size()) || stream.gcount() > 0) {
    text.append(bytes.data(), static_cast<std::size_t>(stream.gcount()));
    if (text.size() > kMost) return Status::invalidInput("has more than 1 GiB");
  }
  return stream.bad() ? Status::invalidInput("cannot be read to its end; check the disk")
                      : Result<std::string>(std::move(text));
}

}  // namespace

Result<Trajectory> readTrajectory(const std::filesystem::path& file) {
  const Result<std::string> text = textOf(file);
  if (!text.isOk()) return Status::invalidInput(file.string() + ": " + text.status().message());
  if (const std::string problem = text_encoding::encodingProblem(text.value()); !problem.empty()) {
    return Status::invalidInput(file.string() + ": " + problem);
  }
  std::istringstream stream(std::string(text_encoding::withoutMark(text.value())));
  Trajectory trajectory;
  LineReader reader = nullptr;
  CutLine cut_line;
  std::string line;
  for (std::size_t number_of_line = 1; std::getline(stream, line); ++number_of_line) {
    try {
      const std::vector<std::string_view> entries = words(line);
      if (entries.empty()) continue;
      if (reader == nullptr && isEuroc(line, entries.front())) {
        throw LineError(
            "is of a CSV file of EuRoC or TUM-VI (stamps in ns, qw before qx); give a TUM file, as "
            "'evo_traj euroc FILE --save_as_tum' writes it");
      }
      if (reader == nullptr) reader = formatOf(entries);
      append(trajectory, reader(entries), entries.size() == 8);
      cut_line.check(entries.back(), !stream.eof());
    } catch (const LineError& error) {
      return Status::invalidInput(file.string() + ":" + std::to_string(number_of_line) + ": " +
                                  error.what());
    }
  }
  if (trajectory.empty()) return Status::invalidInput(file.string() + ": holds no pose");
  return trajectory;
}

}  // namespace tolman::evaluation
