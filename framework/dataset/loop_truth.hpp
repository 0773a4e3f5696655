// SPDX-License-Identifier: BSD-3-Clause
// Loop truth: which frames of a drive see a place again, by the true poses alone.
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

/// What counts as the same place. Headings are those of the optical axes; between the two angles
/// the views have too little in common to be called either.
struct RevisitRule {
  double distance_m = 5;            ///< at most so far apart
  double path_m = 20;               ///< more than so much driven in between
  double same_below_deg = 45;       ///< headings differ by less: same direction
  double opposite_above_deg = 135;  ///< headings differ by more: opposite direction
};

/// None for headings that are neither. Whether two poses are near is not looked at.
std::optional<Heading> headingBetween(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b,
                                      const RevisitRule& rule = {});

/// Frame `frame` stands where `earlier` stood.
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
