// SPDX-License-Identifier: BSD-3-Clause
#include "pair_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <optional>

namespace tolman::camera_files {
namespace {

// Chosen, not tuned: entries of one calibration agree to the digits that files print (TUM-VI's
// camchain.yaml to 1e-15, the example in Kalibr's documentation to 4e-8, an extrinsics.yml of
// stereo_calib to 1e-6 degrees), and smaller contradictions change lengths less than other errors
// of calibration do.
constexpr double kLargestPart = 0.02;  // of the distance between the cameras
constexpr double kLargestDegrees = 1;

std::string numberText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g", value + 0.0);  // 0, not -0
  return text.data();
}

std::string vectorText(const Eigen::Vector3d& v) {
  return "[" + numberText(v.x()) + ", " + numberText(v.y()) + ", " + numberText(v.z()) + "]";
}

double degreesOf(const Eigen::Matrix3d& R) {
  return std::abs(Eigen::AngleAxisd(R).angle()) * 180 / std::numbers::pi;
}

void compareRotations(const Node& entry, const Eigen::Matrix3d& R, const std::string& others,
                      const Eigen::Matrix3d& R_others) {
  const double difference = degreesOf(R.transpose() * R_others);
  if (difference <= kLargestDegrees) return;
  throw FileError(entry.line, inQuotes(entry.key) + " turns by " + numberText(degreesOf(R)) +
                                  " degrees, but " + others + " by " +
                                  numberText(degreesOf(R_others)) + " degrees, which is " +
                                  numberText(difference) + " degrees away; correct the wrong ones");
}

void checkKalibr(const Node& tree, const FileCameras& found) {
  if (found.cameras.size() < 2 || !found.cameras[0].has_pose || !found.cameras[1].has_pose) return;
  const Node* step = tree.find({"cam1"})->find({"T_cn_cnm1"});
  if (step == nullptr) return;
  const std::string others = "'T_cam_imu' of the two cameras";
  const Eigen::Isometry3d& T = *found.T_second_first;
  const Eigen::Isometry3d T_others = found.cameras[1].camera.T_reference_camera.inverse() *
                                     found.cameras[0].camera.T_reference_camera;
  const Eigen::Vector3d t = T.translation();
  const Eigen::Vector3d t_others = T_others.translation();
  if ((t - t_others).norm() > kLargestPart * std::max(t.norm(), t_others.norm())) {
    throw FileError(step->line, "'T_cn_cnm1' has the translation " + vectorText(t) + " m, but " +
                                    others + " give " + vectorText(t_others) +
                                    " m; correct the wrong ones");
  }
  compareRotations(*step, T.linear(), others, T_others.linear());
}

/// The numbers of an entry that is only compared; none where it is missing or cannot be read.
std::vector<double> comparedNumbers(const Node& tree, std::string_view key, std::size_t count) {
  try {
    const Node* node = tree.find({key});
    return node == nullptr ? std::vector<double>() : numbersOf(*node, count);
  } catch (const FileError&) {
    return {};
  }
}

std::optional<Eigen::Matrix3d> comparedRotation(const Node& tree, std::string_view key) {
  const std::vector<double> numbers = comparedNumbers(tree, key, 9);
  if (numbers.empty()) return std::nullopt;
  try {
    return rotationOf(Eigen::Matrix3d(numbers.data()).transpose(), 0);
  } catch (const FileError&) {
    return std::nullopt;
  }
}

void compareLengths(const Node& tree, double length, const std::string& key, double other) {
  if (std::abs(length - other) <= kLargestPart * std::max(length, other)) return;
  throw FileError(tree.find({"T"})->line, "by 'T' the cameras are " + numberText(length) +
                                              " apart, but by '" + key + "' " + numberText(other) +
                                              "; correct the wrong one, or remove '" + key +
                                              "', which is not needed");
}

/// stereoRectify() writes the distance between the cameras also in P2 (times the focal length,
/// along x or y) and in Q (its inverse); R1 and R2 turn both cameras to the same axes, so R2 R =
/// R1.
void checkOpenCv(const Node& tree, const Eigen::Isometry3d& T_second_first) {
  const double length = T_second_first.translation().norm();
  const std::vector<double> P2 = comparedNumbers(tree, "P2", 12);
  const double distance = P2.empty() || P2[0] <= 0 ? 0 : std::hypot(P2[3], P2[7]) / P2[0];
  if (distance > 0) compareLengths(tree, length, "P2", distance);
  const std::vector<double> Q = comparedNumbers(tree, "Q", 16);
  if (!Q.empty() && Q[14] != 0) compareLengths(tree, length, "Q", 1 / std::abs(Q[14]));
  const std::optional<Eigen::Matrix3d> R1 = comparedRotation(tree, "R1");
  const std::optional<Eigen::Matrix3d> R2 = comparedRotation(tree, "R2");
  // Programs that do not rectify write R1 and R2 without a turn; stereoRectify() never does.
  if (!R1 || !R2 || (R1->isIdentity() && R2->isIdentity())) return;
  compareRotations(*tree.find({"R"}), T_second_first.linear(), "'R1' and 'R2'",
                   R2->transpose() * *R1);
}

}  // namespace

void checkPair(const Node& tree, const FileCameras& found) {
  if (!found.T_second_first) return;
  if (tree.find({"cam0"}) != nullptr) return checkKalibr(tree, found);
  checkOpenCv(tree, *found.T_second_first);
}

}  // namespace tolman::camera_files
