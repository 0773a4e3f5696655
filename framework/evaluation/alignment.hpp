// SPDX-License-Identifier: BSD-3-Clause
// Aligns an estimate with the truth (S. Umeyama, "Least-squares estimation of
// transformation parameters between two point patterns", PAMI 13(4), 1991).
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <string_view>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

enum class Alignment : std::uint8_t {
  None,    ///< both have the same coordinate frame
  Se2,     ///< rotation about the y axis and shift in the x-z plane, those of the first camera
  Se3,     ///< rigid motion, no scale: for stereo
  Sim3,    ///< rigid motion and scale: for a single camera
  Origin,  ///< the first poses coincide
  Yaw,     ///< shift and rotation about the vertical: for odometry that measures gravity
};
inline constexpr std::array<std::string_view, 6> kAlignmentNames = {"none", "se2",    "se3",
                                                                    "sim3", "origin", "yaw"};
constexpr std::span<const std::string_view> enumNames(Alignment) { return kAlignmentNames; }

/// The scale of the estimate; Sim3 fits it in any case.
enum class ScaleRule : std::uint8_t {
  Keep,  ///< lengths are compared as they are
  Fit,   ///< the one with the smallest errors under the alignment
  Sim3,  ///< that of the Sim(3) alignment, whatever the alignment
};
inline constexpr std::array<std::string_view, 3> kScaleRuleNames = {"keep", "fit", "sim3"};
constexpr std::span<const std::string_view> enumNames(ScaleRule) { return kScaleRuleNames; }

struct AlignmentRule {
  Alignment kind = Alignment::Se3;
  ScaleRule scale = ScaleRule::Keep;
  std::size_t first = 0;  ///< only this many pairs from the first on are aligned; 0: all
  Eigen::Vector3d vertical = Eigen::Vector3d::UnitY();  ///< of Yaw
};

/// x_truth = scale * R * x_estimate + t.
struct Similarity {
  double scale = 1;
  Eigen::Matrix3d R = Eigen::Matrix3d::Identity();
  Eigen::Vector3d t = Eigen::Vector3d::Zero();

  Eigen::Isometry3d apply(const Eigen::Isometry3d& T_world_camera) const;
};

/// The similarity of this kind that minimises the squared distances between the positions of
/// estimate and truth. R is always a proper rotation. Where positions do not determine it, it is
/// that of the first pair of orientations (one pose) or the smallest one (a straight line).
/// InvalidInput where the scale is undetermined because one side does not move.
Result<Similarity> align(const Matches& matches, const AlignmentRule& rule);
inline Result<Similarity> align(const Matches& matches, Alignment kind) {
  return align(matches, AlignmentRule{kind});
}

/// The matches with the estimate transformed into the coordinates of the truth.
Matches aligned(const Matches& matches, const Similarity& similarity);

}  // namespace tolman::evaluation
