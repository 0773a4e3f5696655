// SPDX-License-Identifier: BSD-3-Clause
// Loop truth: which frames of a drive revisit a place, computed from the true poses.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "evaluation/trajectory.hpp"

namespace tolman::dataset {

enum class Heading : std::uint8_t { Same, Opposite };
inline constexpr std::array<std::string_view, 2> kHeadingNames = {"same", "opposite"};
constexpr std::span<const std::string_view> enumNames(Heading) { return kHeadingNames; }

/// What counts as the same place. Headings are those of the optical axes. Headings between the two
/// angles count as neither direction, because the views overlap too little.
struct RevisitRule {
  double distance_m = 5;            ///< largest distance of the two positions
  double path_m = 20;               ///< the path driven in between is longer than this
  double same_below_deg = 45;       ///< headings differ by less: same direction
  double opposite_above_deg = 135;  ///< headings differ by more: opposite direction
  double height_m = 0;  ///< places that are further apart in height (camera's y) differ; 0: off
};

/// The relation of the headings alone, whatever the positions; none for neither direction.
std::optional<Heading> headingBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                                      const RevisitRule& rule = {});

/// Whether two positions are the same place, whatever the headings.
bool isSamePlace(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, const RevisitRule& rule);

/// Frame `frame` is at the place of frame `earlier`.
struct Revisit {
  std::int64_t frame = 0;
  std::int64_t earlier = 0;
  Heading heading = Heading::Same;
  double distance_m = 0;
};

/// For each frame and heading the nearest earlier frame that the rule allows (of equally near ones
/// the earliest), in the order of frames, same before opposite. Poses must be finite.
std::vector<Revisit> findRevisits(const evaluation::Trajectory& truth,
                                  const RevisitRule& rule = {});

/// loops.txt: a comment line, then `frame earlier same|opposite distance_m`.
std::string loopsText(std::span<const Revisit> revisits, const RevisitRule& rule = {});

}  // namespace tolman::dataset
