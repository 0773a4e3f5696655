// SPDX-License-Identifier: BSD-3-Clause
// A route from a KITTI pose file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <optional>
#include <variant>

#include "base/number_text.hpp"
#include "base/open_files.hpp"
#include "base/text_encoding.hpp"
#include "route.hpp"

namespace tolman::town {
namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kMaxBytes = 256U << 20U;
constexpr double kRotationTolerance = 1e-3;  // KITTI prints seven digits
constexpr double kFastestDrive = 60;              ///< m/s
constexpr double kLongestStep = 5;           ///< m, at any rate
constexpr double kLargestTurn = 60;          ///< degrees between frames

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

using Numbers = std::array<double, 12>;

/// Twelve numbers, or the error of the line.
std::variant<Numbers, std::string> parseNumbers(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r";
  Numbers numbers{};
  std::size_t count = 0;
  for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos; ++count) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    const std::string_view field = line.substr(at, end - at);
    const std::optional<double> number = text_encoding::parseNumber(field);
    if (!number) {
      return std::string("'").append(field) + "' " +
             std::string(text_encoding::numberProblem(field)) + "; correct the pose";
    }
    if (count < numbers.size()) numbers[count] = *number;
    at = line.find_first_not_of(kBlank, end);
  }
  if (count == numbers.size()) return numbers;
  return "has " + std::to_string(count) + " numbers; a pose has 12, row by row";
}

/// A pose, or the error of the line.
std::variant<Eigen::Isometry3d, std::string> parsePose(std::string_view line) {
  const auto numbers = parseNumbers(line);
  if (const auto* problem = std::get_if<std::string>(&numbers)) return *problem;
  using Rows = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
  const Eigen::Map<const Rows> M(std::get<Numbers>(numbers).data());
  const Eigen::Matrix3d R = M.leftCols<3>();
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kRotationTolerance) || R.determinant() < 0) {
    return "its first three columns are no rotation; write camera-to-world poses";
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = M.col(3);
  return T;
}

/// The reason why a step between two frames cannot be driven; empty if it can.
std::optional<std::string> stepProblem(const Eigen::Isometry3d& before,
                                       const Eigen::Isometry3d& after, double rate) {
  const double longest = std::max(kLongestStep, kFastestDrive / rate);
  const double step = (after.translation() - before.translation()).norm();
  if (!(step <= longest)) {
    return "is " + fixed(step, 1) + " m from the pose before, farther than a car drives in " +
           fixed(1 / rate, 3) + " s (" + fixed(longest, 1) +
           " m); remove the jump, or correct the frame rate";
  }
  const Eigen::Matrix3d turned = before.linear().transpose() * after.linear();
  const double degrees = Eigen::AngleAxisd(turned).angle() * 180 / std::numbers::pi;
  if (degrees > kLargestTurn) {
    return "is turned by " + fixed(degrees, 0) + " degrees from the pose before, more than " +
           fixed(kLargestTurn, 0) + "; remove the jump, or correct the frame rate";
  }
  return std::nullopt;
}

/// Failures name the file and the line.
Result<std::vector<Eigen::Isometry3d>> readPoses(std::istream& stream, const std::string& name,
                                                 double rate) {
  std::vector<Eigen::Isometry3d> poses;
  std::size_t number = 0;
  for (std::string line; std::getline(stream, line);) {
    const std::string place = name + ":" + std::to_string(++number) + ": ";
    if (number == 1) line = text_encoding::withoutMark(line);
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const auto pose = parsePose(line);
    if (const auto* problem = std::get_if<std::string>(&pose)) {
      return Status::invalidInput(place + *problem);
    }
    const auto& T = std::get<Eigen::Isometry3d>(pose);
    if (!poses.empty()) {
      if (const auto problem = stepProblem(poses.back(), T, rate)) {
        return Status::invalidInput(place + *problem);
      }
    }
    poses.push_back(T);
  }
  return poses;
}

}  // namespace

Result<CameraRoute> readRoute(const fs::path& file, const RouteOptions& options) {
  const std::string name = file.string();
  if (!std::isfinite(options.rate) || options.rate <= 0) {
    return Status::invalidParameter("rate must be positive; give frames/s");
  }
  std::error_code failure;
  if (fs::exists(file, failure) && !fs::is_regular_file(file, failure)) {
    return Status::invalidInput(name + ": is a folder or device; give a KITTI pose file");
  }
  if (!fs::is_regular_file(file, failure)) {
    return Status::invalidInput(name +
                                ": there is no such file; correct the path, or use block, eights, "
                                "district, highway or car_park");
  }
  if (fs::file_size(file, failure) > kMaxBytes || failure) {
    return Status::invalidInput(name + ": is larger than 256 MiB; give a KITTI pose file");
  }
  if (const std::string problem = text_encoding::encodingProblemOf(file); !problem.empty()) {
    return Status::invalidInput(name + ": " + problem);
  }
  std::ifstream stream(file);
  const Result<std::vector<Eigen::Isometry3d>> poses = readPoses(stream, name, options.rate);
  if (!poses.isOk()) return poses.status();
  if (!stream.eof()) {
    return Status::invalidInput(name + ": " +
                                file_opening::notOpened("cannot be read; check its permissions"));
  }
  if (poses.value().size() < 2) {
    return Status::invalidInput(name + ": has " + (poses.value().empty() ? "no pose" : "one pose") +
                                "; a drive needs two or more");
  }
  Eigen::Matrix3d R_town_camera;  // of the first camera
  R_town_camera << 1, 0, 0, 0, 0, 1, 0, -1, 0;
  const Eigen::Isometry3d T_town_world =
      Eigen::Isometry3d(R_town_camera) * poses.value().front().inverse();
  CameraRoute route;
  route.name = file.stem().string();
  for (const Eigen::Isometry3d& T_world_camera : poses.value()) {
    const auto frame = static_cast<double>(route.stamps_ns.size());
    route.stamps_ns.push_back(std::llround(frame * 1e9 / options.rate));
    route.T_town_camera.push_back(T_town_world * T_world_camera);
  }
  return route;
}

}  // namespace tolman::town
