// SPDX-License-Identifier: BSD-3-Clause
// Claims that a place is passed in the opposite direction, against the true poses of a drive.
#pragma once

#include <cstdint>
#include <vector>

#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::bench {

/// Image `query` was recognised as the place of the earlier image `place`.
struct TurnedAnswer {
  std::int64_t query = -1;
  std::int64_t place = -1;
  double score = 0;
  Eigen::Isometry3d T_place_query = Eigen::Isometry3d::Identity();
};

/// Whether the observation says that the template was seen in the opposite direction.
bool isTurned(const PlaceObservation& seen);
/// The camera pose relative to the template by the observation: the measured one, or without one
/// the position of the template, turned by relative_yaw.
Eigen::Isometry3d claimedPose(const PlaceObservation& seen);

struct OppositePlaces {
  struct Claim {
    std::int64_t query = -1;
    std::int64_t place = -1;
    double score = 0;
    double error_m = 0;  ///< claimed position to the true one
    bool right = false;  ///< within 5 m, and the headings are opposite
  };

  std::int64_t findable = 0;  ///< images that pass a place in the opposite direction alone
  std::int64_t found = 0;     ///< those of `findable` at most 5 m of path after a right claim
  std::vector<Claim> claims;

  std::int64_t right() const;
  /// Median error of the right claims; 0 without any.
  double medianError() const;
};

/// `truth` has a pose for each image; `height_m`: as RevisitRule::height_m.
OppositePlaces judgeOpposite(const evaluation::Trajectory& truth,
                             const std::vector<TurnedAnswer>& answers, double height_m = 0);

}  // namespace tolman::bench
