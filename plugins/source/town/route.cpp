// SPDX-License-Identifier: BSD-3-Clause
// Routes from files, and those made of others: flights, and the level ground below them.
#include "route.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <numbers>
#include <optional>

#include "base/text_file.hpp"

namespace tolman::town {

Eigen::Isometry3d levelPose(double azimuth) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  // Columns: right, down and forward of the camera in town axes (Z up).
  pose.linear() << std::cos(azimuth), 0, std::sin(azimuth), -std::sin(azimuth), 0,
      std::cos(azimuth), 0, -1, 0;
  return pose;
}

CameraRoute groundTrack(const CameraRoute& route) {
  CameraRoute track = route;
  for (Eigen::Isometry3d& pose : track.T_town_camera) {
    const Eigen::Vector3d ahead = pose.linear().col(2);
    const double azimuth = ahead.head<2>().norm() > 1e-6 ? std::atan2(ahead.x(), ahead.y()) : 0;
    pose.linear() = levelPose(azimuth).linear();
    pose.translation().z() = route.T_town_camera.front().translation().z();
  }
  return track;
}

CameraRoute flown(const CameraRoute& driven) {
  constexpr double kTurn = 2 * std::numbers::pi;
  constexpr double kAmplitude = 8 * std::numbers::pi / 180;
  CameraRoute route = groundTrack(driven);
  for (std::size_t i = 0; i < route.T_town_camera.size(); ++i) {
    Eigen::Isometry3d& pose = route.T_town_camera[i];
    const double seconds = 1e-9 * static_cast<double>(driven.stamps_ns[i] - driven.stamps_ns[0]);
    const Eigen::Vector3d place = pose.translation() - route.T_town_camera[0].translation();
    pose.translation().z() +=
        2 - std::cos(kTurn * place.x() / 110) - std::cos(kTurn * place.y() / 90);
    pose.rotate(
        Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds / 7.3), Eigen::Vector3d::UnitX()));
    pose.rotate(
        Eigen::AngleAxisd(kAmplitude * std::sin(kTurn * seconds / 5.1), Eigen::Vector3d::UnitZ()));
  }
  return route;
}

// A route from a KITTI pose file.

namespace fs = std::filesystem;

namespace {

constexpr double kRotationTolerance = 1e-3;  // KITTI prints seven digits
constexpr double kFastestDrive = 60;         ///< m/s
constexpr double kLongestStep = 5;           ///< m, at any rate
constexpr double kLargestTurn = 60;          ///< degrees between frames

/// A pose of twelve numbers; a failure has the error of the line.
Result<Eigen::Isometry3d> parsePose(std::string_view line) {
  constexpr std::string_view kBlank = " \t\r";
  Eigen::Matrix<double, 3, 4, Eigen::RowMajor> M;
  Eigen::Index count = 0;
  for (std::size_t at = line.find_first_not_of(kBlank); at != std::string_view::npos; ++count) {
    const std::size_t end = std::min(line.find_first_of(kBlank, at), line.size());
    const std::string_view field = line.substr(at, end - at);
    const std::optional<double> number = text_encoding::parseNumber(field);
    if (!number) {
      return Status::invalidInput(std::string("'").append(field) + "' " +
                                  std::string(text_encoding::numberProblem(field)) +
                                  "; correct the pose");
    }
    if (count < M.size()) M.data()[count] = *number;
    at = line.find_first_not_of(kBlank, end);
  }
  if (count != M.size()) {
    return Status::invalidInput("has " + std::to_string(count) +
                                " numbers; a pose has 12, row by row");
  }
  const Eigen::Matrix3d R = M.leftCols<3>();
  const double error = (R.transpose() * R - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error <= kRotationTolerance) || R.determinant() < 0) {
    return Status::invalidInput(
        "its first three columns are no rotation; write camera-to-world poses");
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  T.translation() = M.col(3);
  return T;
}

/// The reason why a step between two frames cannot be driven; empty if it can.
std::string stepProblem(const Eigen::Isometry3d& before, const Eigen::Isometry3d& after,
                        double rate) {
  const double longest = std::max(kLongestStep, kFastestDrive / rate);
  const double step = (after.translation() - before.translation()).norm();
  const Eigen::Matrix3d turned = before.linear().transpose() * after.linear();
  const double degrees = Eigen::AngleAxisd(turned).angle() * 180 / std::numbers::pi;
  std::array<char, 256> text{};
  if (!(step <= longest)) {
    std::snprintf(text.data(), text.size(),
                  "is %.1f m from the pose before, farther than a car drives in %.3f s (%.1f m); "
                  "remove the jump, or correct the frame rate",
                  step, 1 / rate, longest);
  } else if (degrees > kLargestTurn) {
    std::snprintf(
        text.data(), text.size(),
        "is turned by %.0f degrees from the pose before, more than %.0f; remove the jump, "
        "or correct the frame rate",
        degrees, kLargestTurn);
  }
  return text.data();
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
    const Result<Eigen::Isometry3d> pose = parsePose(line);
    if (!pose.isOk()) return Status::invalidInput(place + std::string(pose.status().message()));
    const std::string problem = poses.empty() ? "" : stepProblem(poses.back(), pose.value(), rate);
    if (!problem.empty()) return Status::invalidInput(place + problem);
    poses.push_back(pose.value());
  }
  return poses;
}

}  // namespace

Result<CameraRoute> readRoute(const fs::path& file, const RouteOptions& options) {
  const std::string name = file.string();
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) {
    return Status::invalidInput(
        name + (fs::exists(file, failure)
                    ? ": is a folder or device; give a KITTI pose file"
                    : ": there is no such file; correct the path, or use block, eights, district, "
                      "highway or car_park"));
  }
  std::ifstream stream(file);
  const Result<std::vector<Eigen::Isometry3d>> poses = readPoses(stream, name, options.rate);
  if (!poses.isOk()) return poses.status();
  if (!stream.eof()) {
    return Status::invalidInput(name + ": cannot be read; check its permissions");
  }
  if (poses.value().size() < 2) {
    return Status::invalidInput(name + ": has " + (poses.value().empty() ? "no pose" : "one pose") +
                                "; a drive needs two or more");
  }
  const Eigen::Isometry3d T_town_world = levelPose(0) * poses.value().front().inverse();
  CameraRoute route;
  route.name = file.stem().string();
  for (const Eigen::Isometry3d& T_world_camera : poses.value()) {
    route.add(T_town_world * T_world_camera, options.rate);
  }
  return route;
}

}  // namespace tolman::town
