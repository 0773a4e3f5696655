// SPDX-License-Identifier: BSD-3-Clause
// The error of the KITTI odometry benchmark: drift over segments of given lengths (Geiger, Lenz,
// Urtasun, CVPR 2012).
#pragma once

#include <string>
#include <vector>

#include "evaluation/association.hpp"

namespace tolman::evaluation {

/// A named list of lengths, so that errors over short segments are not mistaken for KITTI's.
struct SegmentLengths {
  std::string name;
  std::vector<double> lengths_m;
};

/// "kitti": 100, 200 ... 800 m.
SegmentLengths kittiLengths();
/// "short": 5, 10, 20, 30, 40, 50 m.
SegmentLengths shortLengths();
/// kittiLengths() for paths of at least 200 m, else shortLengths().
SegmentLengths lengthsFor(double truth_path_length_m);

struct SegmentErrors {
  SegmentLengths lengths;    ///< the requested lengths
  std::size_t segments = 0;  ///< how many were measured; 0: the path is too short, no figures
  std::size_t segments_in_gaps = 0;  ///< left out: they end where poses have no estimate, or in
                                     ///< another piece of the path
  double t_rel_percent = 0;          ///< mean translation error per length
  double r_rel_deg_per_100m = 0;
};

/// As in the benchmark's own program: a segment starts at every 10th matched frame and ends at the
/// first one that is more than the length of true path away; all segments have the same weight.
/// Where true poses before that end have no estimate, errors are divided by the segment's true
/// length, and segments more than a tenth too long are left out. So are segments that end in
/// another piece of the path than they begin in (Matches::piece).
SegmentErrors segmentErrors(const Matches& matches, const SegmentLengths& lengths);

}  // namespace tolman::evaluation
