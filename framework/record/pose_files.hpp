// SPDX-License-Identifier: BSD-3-Clause
// Trajectories in the text formats of TUM and KITTI. Equal poses give equal bytes on every machine.
#pragma once

#include <string>

#include "evaluation/trajectory.hpp"
#include "tolman/status.hpp"

namespace tolman::record {

/// The shortest text that reads back as exactly this double; no negative zero.
std::string numberText(double value);

/// Seconds with nine decimals.
std::string secondsText(std::int64_t time_ns);

/// `x y z qx qy qz qw` with qw >= 0.
std::string poseText(const Eigen::Isometry3d& T);

/// Lines `stamp tx ty tz qx qy qz qw`; the stamp has nine decimals, exactly as recorded.
std::string tumText(const evaluation::Trajectory& poses);

/// Twelve numbers per line, one line per frame from frame 0. The format has no frame numbers: a
/// frame without a pose repeats the previous pose (the identity before the first), so that line
/// numbers are frame numbers; so do those after the last pose up to `frames`. InvalidInput for
/// frames out of order, for gaps of more than a million frames, and for frame numbers above 100
/// million.
Result<std::string> kittiText(const evaluation::Trajectory& poses, std::int64_t frames = 0);

}  // namespace tolman::record
