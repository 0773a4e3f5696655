// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/trajectory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "base/text_file.hpp"

namespace tolman::evaluation {

bool hasStamps(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [](const TrajectoryPose& p) { return p.stamp_ns != 0; });
}

bool hasOrientations(const Trajectory& trajectory) {
  return std::ranges::any_of(trajectory, [&](const TrajectoryPose& p) {
    return p.T_world_camera.linear() != trajectory.front().T_world_camera.linear();
  });
}

std::int64_t medianStep(const Trajectory& trajectory) {
  if (trajectory.size() < 2) return 0;
  std::vector<std::int64_t> steps;
  for (std::size_t i = 1; i < trajectory.size(); ++i) {
    steps.push_back(trajectory[i].stamp_ns - trajectory[i - 1].stamp_ns);
  }
  const auto median = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

std::optional<PoseAt> poseAt(const Trajectory& trajectory, std::int64_t stamp_ns,
                             std::int64_t longest_gap_ns) {
  const auto after = std::ranges::lower_bound(trajectory, stamp_ns, {}, &TrajectoryPose::stamp_ns);
  if (after == trajectory.end()) return std::nullopt;
  const auto index = static_cast<std::size_t>(after - trajectory.begin());
  if (after->stamp_ns == stamp_ns) return PoseAt{after->T_world_camera, index, 0};
  if (index == 0 || after->stamp_ns - (after - 1)->stamp_ns > longest_gap_ns) return std::nullopt;
  const Eigen::Isometry3d& a = (after - 1)->T_world_camera;
  const Eigen::Isometry3d& b = after->T_world_camera;
  const double share = static_cast<double>(stamp_ns - (after - 1)->stamp_ns) /
                       static_cast<double>(after->stamp_ns - (after - 1)->stamp_ns);
  PoseAt at{Eigen::Isometry3d::Identity(), index - 1, share};
  at.T_world_camera.linear() = Eigen::Quaterniond(a.linear())
                                   .slerp(share, Eigen::Quaterniond(b.linear()))
                                   .toRotationMatrix();
  at.T_world_camera.translation() = (1 - share) * a.translation() + share * b.translation();
  return at;
}

Trajectory movedBy(const Eigen::Isometry3d& T, Trajectory trajectory) {
  for (TrajectoryPose& pose : trajectory) pose.T_world_camera = T * pose.T_world_camera;
  return trajectory;
}

Trajectory ofBody(Trajectory trajectory, const Eigen::Isometry3d& T_camera_body) {
  for (TrajectoryPose& pose : trajectory) pose.T_world_camera = pose.T_world_camera * T_camera_body;
  return trajectory;
}

Eigen::Matrix3Xd positions(const Trajectory& trajectory) {
  Eigen::Matrix3Xd points(3, static_cast<Eigen::Index>(trajectory.size()));
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    points.col(static_cast<Eigen::Index>(i)) = trajectory[i].T_world_camera.translation();
  }
  return points;
}

Eigen::Matrix3Xd centredPositions(const Trajectory& trajectory) {
  const Eigen::Matrix3Xd points = positions(trajectory);
  const Eigen::Vector3d mean = points.rowwise().mean();
  return points.colwise() - mean;
}

Eigen::Vector3d extentFromFirst(const Trajectory& trajectory) {
  if (trajectory.empty()) return Eigen::Vector3d::Zero();
  const Eigen::Matrix3Xd points =
      trajectory.front().T_world_camera.inverse() * positions(trajectory);
  return points.rowwise().maxCoeff() - points.rowwise().minCoeff();
}

std::vector<double> distances(const Trajectory& trajectory) {
  std::vector<double> result;
  result.reserve(trajectory.size());
  double distance = 0;
  for (std::size_t i = 0; i < trajectory.size(); ++i) {
    if (i > 0 && trajectory[i].session == trajectory[i - 1].session) {
      distance += (trajectory[i].T_world_camera.translation() -
                   trajectory[i - 1].T_world_camera.translation())
                      .norm();
    }
    result.push_back(distance);
  }
  return result;
}

double pathLength(const Trajectory& trajectory) {
  return trajectory.empty() ? 0 : distances(trajectory).back();
}

namespace {

using text_encoding::inQuotes;
using Words = std::vector<std::string_view>;

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

Words wordsOf(std::string_view line) {
  return text_encoding::splitFields(line.substr(0, line.find('#')));
}

double number(std::string_view word) {
  const std::optional<double> value = text_encoding::parseNumber(word);
  if (value) return *value;
  throw LineError(inQuotes(word) + " " + std::string(text_encoding::numberProblem(word)));
}

double coordinate(std::string_view word) {
  const double metres = number(word);
  if (std::abs(metres) <= kLargestPosition) return metres;
  throw LineError("position " + inQuotes(word) + " is too large; positions are metres");
}

/// Exact to the nanosecond for plain decimals. `digits`: 9 for seconds, 0 for nanoseconds.
std::int64_t stampNs(std::string_view word, int digits) {
  const double seconds = number(word) * std::pow(10, digits - 9);
  if (std::abs(seconds) > kLatest) {
    throw LineError("stamp " + inQuotes(word) +
                    " is too large; stamps are seconds: divide ns by 1e9, us by 1e6 and ms by 1e3");
  }
  return text_encoding::parseSeconds(word, digits).value_or(std::llround(seconds * 1e9));
}

Eigen::Matrix3d checkedRotation(const Eigen::Matrix3d& R, bool as_written) {
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < kRotationTolerance) || R.determinant() < 0) {
    throw LineError("the rotation part is not a rotation matrix");
  }
  return as_written ? R : Eigen::Quaterniond(R).normalized().toRotationMatrix();
}

/// Which columns of a table hold what; -1: none.
struct Columns {
  std::string format;  ///< for messages
  int count = 0;       ///< of columns
  int stamp = -1;
  int stamp_digits = 9;  ///< decimal exponent of its unit in ns
  int frame = -1;
  int matrix = -1;  ///< first of 12 numbers, row by row
  std::array<int, 3> position = {-1, -1, -1};
  std::array<int, 4> quaternion = {-1, -1, -1, -1};  ///< x y z w

  bool hasPosition() const { return matrix >= 0 || std::ranges::min(position) >= 0; }
  bool hasQuaternion() const { return std::ranges::min(quaternion) >= 0; }
};

bool isNanoseconds(std::string_view word) {
  constexpr std::size_t kDigits = 16;  // in ns, of any time since February 1970; more than seconds
  return word.size() >= kDigits && word.find_first_not_of("0123456789") == std::string_view::npos;
}

int digitsOf(std::string_view given, const std::string& name) {
  const auto is = [&](const char* unit) {
    return given.find(fmt::format("[{}]", unit)) != std::string_view::npos ||
           name.ends_with(fmt::format("_{}", unit));
  };
  return is("ns") ? 0 : is("us") ? 3 : is("ms") ? 6 : 9;
}

/// Takes the column of this name, of each kind the first.
void take(Columns& columns, std::string_view given, int index) {
  const auto set = [&](int& column) {
    if (column < 0) column = index;
  };
  std::string name;
  for (const char c : given.substr(0, given.find('['))) {
    if (std::isspace(static_cast<unsigned char>(c)) == 0 && c != '"') {
      name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
  }
  const auto has = [&](std::string_view part) { return name.find(part) != std::string::npos; };
  if (name.empty() || has("vel") || has("twist") || has("cov") || has("acc") || has("bias")) return;
  constexpr std::array<std::string_view, 5> kFrames = {"frame", "frame_index", "frame_number",
                                                       "index", "image"};
  if (std::ranges::find(kFrames, name) != kFrames.end()) return set(columns.frame);
  if (name == "t" || has("time") || has("stamp") || name.starts_with("sec")) {
    if (columns.stamp < 0) columns.stamp_digits = digitsOf(given, name);
    return set(columns.stamp);
  }
  const std::size_t axis = std::string_view("xyzw").find(name.back());
  if (axis == std::string_view::npos) return;
  const std::string stem = name.substr(0, name.size() - 1);
  if (stem.starts_with("q") || stem.find("orient") != std::string::npos ||
      stem.find("rot") != std::string::npos) {
    return set(columns.quaternion[axis]);
  }
  const bool is_position = stem.empty() || stem == "t" || stem == "p" || stem == "t_" ||
                           stem.starts_with("p_") || stem.starts_with("trans") ||
                           stem.find("pos") != std::string::npos;
  if (is_position && axis < 3) set(columns.position[axis]);
}

/// Columns by their names, as "#timestamp [ns]", "p_RS_R_x [m]", "qw", "pose.position.x".
std::optional<Columns> namedColumns(std::string_view line) {
  line.remove_prefix(std::min(line.find_first_not_of("# \t"), line.size()));
  const auto has = [&](char c) { return line.find(c) != std::string_view::npos; };
  const char* separators = has(',') ? ",\r" : has(';') ? ";\r" : " \t\r";  // "x [m], y [m]"
  Columns columns;
  int index = 0;
  while (!line.empty()) {
    const std::size_t end = std::min(line.find_first_of(separators), line.size());
    if (end > 0) take(columns, line.substr(0, end), index++);
    line.remove_prefix(std::min(end + 1, line.size()));
  }
  if (!columns.hasPosition()) return std::nullopt;
  columns.format = fmt::format("{} columns, as its first line names", index);
  columns.count = index;
  if (!columns.hasQuaternion()) columns.quaternion = {-1, -1, -1, -1};
  return columns;
}

/// The format of a table without names of columns. EuRoC and TUM-VI have ns, and w first.
Columns columnsOf(const Words& entries) {
  const std::size_t count = entries.size();
  const auto named = [&](const char* format, const char* names) {
    Columns columns = *namedColumns(names);
    columns.format = format;
    columns.count = static_cast<int>(count);
    return columns;
  };
  const auto matrix = [&](const char* format, int frame) {
    Columns columns{format, static_cast<int>(count)};
    columns.frame = frame;
    columns.matrix = frame + 1;
    return columns;
  };
  if (isNanoseconds(entries.front()) && count >= 8) {
    return named("a line of EuRoC (ns, x y z, qw qx qy qz)", "stamp_ns x y z qw qx qy qz");
  }
  if (count == 4) return named("4 numbers (stamp tx ty tz)", "stamp x y z");
  if (count == 8) {
    return named("8 numbers (stamp tx ty tz qx qy qz qw)", "stamp x y z qx qy qz qw");
  }
  if (count == 12) return matrix("12 numbers (rows of a 3x4 pose)", -1);
  if (count == 13) return matrix("13 numbers (frame, rows of a 3x4 pose)", 0);
  if (count == 17) return matrix("17 numbers (frame, rows of a 4x4 pose)", 0);
  throw LineError(fmt::format(
      "neither a TUM pose (8 numbers) nor a KITTI pose (12 numbers), nor stamp x y z (4), nor a "
      "frame with its pose (13 or 17): found {} entries; other tables need a first line with the "
      "names of their columns",
      count));
}

bool beginsWithNumber(std::string_view line) {
  const Words words = wordsOf(line);
  return !words.empty() && text_encoding::parseNumber(words.front()).has_value();
}

TrajectoryPose poseOf(const Words& entries, const Columns& columns, bool as_written) {
  if (static_cast<int>(entries.size()) != columns.count) {
    throw LineError(fmt::format("expected {}, found {}", columns.format, entries.size()));
  }
  const auto word = [&](int column) { return entries[static_cast<std::size_t>(column)]; };
  TrajectoryPose pose;
  if (columns.stamp >= 0) {
    const bool is_ns = columns.stamp_digits == 9 && isNanoseconds(word(columns.stamp));
    pose.stamp_ns = stampNs(word(columns.stamp), is_ns ? 0 : columns.stamp_digits);
  }
  if (columns.frame >= 0) pose.frame = std::llround(number(word(columns.frame)));
  if (columns.matrix >= 0) {
    Eigen::Matrix<double, 3, 4, Eigen::RowMajor> rows;
    for (int i = 0; i < 12; ++i) {
      const std::string_view entry = word(columns.matrix + i);
      rows.data()[i] = i % 4 == 3 ? coordinate(entry) : number(entry);
    }
    pose.T_world_camera.linear() = checkedRotation(rows.leftCols<3>(), as_written);
    pose.T_world_camera.translation() = rows.col(3);
    return pose;
  }
  for (int i = 0; i < 3; ++i) {
    pose.T_world_camera.translation()[i] =
        coordinate(word(columns.position[static_cast<std::size_t>(i)]));
  }
  if (!columns.hasQuaternion()) return pose;
  Eigen::Quaterniond q;
  for (std::size_t i = 0; i < 4; ++i)
    q.coeffs()[static_cast<int>(i)] = number(word(columns.quaternion[i]));
  if (std::abs(q.norm() - 1) > kRotationTolerance) {
    throw LineError("the quaternion has length " + std::to_string(q.norm()) + " instead of 1");
  }
  pose.T_world_camera.linear() = q.normalized().toRotationMatrix();
  return pose;
}

void append(Trajectory& trajectory, TrajectoryPose pose, const Columns& columns) {
  if (columns.stamp >= 0 && !trajectory.empty() && pose.stamp_ns <= trajectory.back().stamp_ns) {
    throw LineError("the stamp does not increase; sort the file and remove duplicates");
  }
  if (columns.frame < 0 || columns.stamp >= 0) {
    pose.frame = static_cast<std::int64_t>(trajectory.size());
  } else if (!trajectory.empty() && pose.frame <= trajectory.back().frame) {
    throw LineError("the frame does not increase; sort the file and remove duplicates");
  }
  trajectory.push_back(pose);
}

}  // namespace

Result<Trajectory> readTrajectory(const std::filesystem::path& file, bool as_written) {
  const Result<std::string> text = text_encoding::readText(file, std::uintmax_t{1} << 30U);
  if (!text.isOk()) return text.status();
  std::istringstream stream(text.value());
  Trajectory trajectory;
  std::optional<Columns> comment, columns;
  std::string line;
  for (std::size_t number_of_line = 1; std::getline(stream, line); ++number_of_line) {
    try {
      if (!columns && !beginsWithNumber(line)) {
        const auto named = namedColumns(line);
        const bool is_comment = line.find_first_not_of(" \t") == line.find('#');
        if (named) (is_comment ? comment : columns) = named;
        if (named || is_comment) continue;
      }
      const Words entries = wordsOf(line);
      if (entries.empty()) continue;
      if (!columns) {
        const bool fits = comment && comment->count == static_cast<int>(entries.size());
        columns = fits ? *comment : columnsOf(entries);
      }
      append(trajectory, poseOf(entries, *columns, as_written), *columns);
    } catch (const LineError& error) {
      return Status::invalidInput(
          fmt::format("{}:{}: {}", file.string(), number_of_line, error.what()));
    }
  }
  if (trajectory.empty()) return Status::invalidInput(file.string() + ": holds no pose");
  return trajectory;
}

}  // namespace tolman::evaluation
