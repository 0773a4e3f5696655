// SPDX-License-Identifier: BSD-3-Clause
// Errors of an estimate: absolute and relative ones (Sturm et al., "A benchmark for the evaluation
// of RGB-D SLAM systems", IROS 2012), the drift of the KITTI odometry benchmark (Geiger, Lenz,
// Urtasun, CVPR 2012), and whether the covariances that an odometry reports fit its errors: the
// normalised estimation error squared (Bar-Shalom, Li, Kirubarajan, "Estimation with applications
// to tracking and navigation", 2001, section 5.4).
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "evaluation/association.hpp"
#include "evaluation/trajectory.hpp"
#include "tolman/records.hpp"

namespace tolman::evaluation {

struct Statistics {
  std::size_t count = 0;
  double rmse = 0;
  double mean = 0;
  double deviation = 0;  ///< standard deviation, n - 1; 0 for one value
  double median = 0;     ///< of an even count: the mean of the middle two
  double p90 = 0;        ///< 90th percentile
  double min = 0;
  double max = 0;
};

/// All 0 for no values.
Statistics statistics(std::vector<double> values);

/// The quantile, interpolated between the two nearest sorted values (numpy's default method).
double quantile(const std::vector<double>& sorted, double share);

/// The parts of a distance. Vertical is along the y axis of the truth's world frame; horizontal
/// is in its x-z plane. score() makes that world the first true camera.
enum class Direction : std::uint8_t { All, Horizontal, Vertical };

/// Distances between matched positions, m.
std::vector<double> positionErrors(const Matches& aligned, Direction direction = Direction::All);
/// Statistics of positionErrors().
Statistics absoluteError(const Matches& aligned, Direction direction = Direction::All);

/// Angles between matched orientations, degrees.
std::vector<double> rotationErrors(const Matches& aligned);

/// Distances without regard to time, m: from each position to the nearest point of the other path.
struct PathDistance {
  Statistics to_truth_m;   ///< from the poses of the estimate to the true path
  double hausdorff_m = 0;  ///< the largest distance, in either direction
};
PathDistance pathDistance(const Trajectory& truth, const Trajectory& aligned);

/// The error of motion over a step: |T_truth^-1 T_estimate| of matched motions.
struct RelativeError {
  Statistics translation_m;
  Statistics rotation_deg;
  Statistics length_m;        ///< difference of the straight distances
  Statistics length_percent;  ///< the same, of the true distance
};

enum class StepUnit : std::uint8_t { Frames, Poses, Seconds, Metres, Degrees };
/// Where a step ends that begins at a given pair.
enum class StepEnd : std::uint8_t {
  First,    ///< at the first pair that is far enough
  Tenth,    ///< at the pair nearest to the length, at most a tenth of it away
  Closest,  ///< at the pair nearest to the length, be it the first itself; not at the last pose
            ///< of the estimate
};
/// Over which steps motions are compared.
struct Steps {
  double length = 1;
  StepUnit unit = StepUnit::Frames;
  StepEnd end = StepEnd::First;
  bool all = true;            ///< a step from each pair; else each begins where the last one ended
  bool of_truth = true;       ///< metres and degrees are those of the truth, else of the estimate
  bool over_gaps = false;     ///< also from one piece of the path to the next, by the straight line
  bool divided = false;       ///< errors are divided by the length of the true path
  bool in_end_frame = false;  ///< the difference of translations is seen from the end of the step
  bool as_written = false;  ///< matrices are taken as they are, even if they are no exact rotations
};
/// Frames are those of the estimate: missing ones give no pair. Poses count the matched ones.
/// Metres and degrees are summed from pair to pair; with Tenth, degrees are the angle between both
/// ends, and all ends within the tenth count.
RelativeError relativeError(const Matches& aligned, const Steps& steps);

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

/// The mean errors over one length, or over all of them.
struct SegmentMean {
  double length_m = 0;
  std::size_t segments = 0;
  double t_rel_percent = 0;  ///< translation error per length
  double r_rel_deg_per_100m = 0;
};

struct SegmentErrors {
  SegmentLengths lengths;    ///< the requested lengths
  std::size_t segments = 0;  ///< how many were measured; 0: the path is too short, no figures
  std::size_t segments_in_gaps = 0;  ///< left out: they end where poses have no estimate, or in
                                     ///< another piece of the path
  double t_rel_percent = 0;          ///< mean translation error per length
  double r_rel_deg_per_100m = 0;
  std::vector<SegmentMean> table;  ///< by length
};

/// As in the benchmark's own program: a segment starts at every 10th matched frame and ends at the
/// first one that is more than the length of true path away; all segments have the same weight.
/// Where true poses before that end have no estimate, errors are divided by the segment's true
/// length, and segments more than a tenth too long are left out. So are segments that end in
/// another piece of the path than they begin in (Matches::piece).
/// `whole_truth`: starts and ends are poses of this truth instead, and segments with an end
/// without estimate are left out; matrices are taken as they are written. `single`: in the single
/// precision of that program.
SegmentErrors segmentErrors(const Matches& matches, const SegmentLengths& lengths,
                            const Trajectory* whole_truth = nullptr, bool single = false);

struct MotionConsistency {
  std::size_t motions = 0;             ///< tracked motions in metres, with truth at both ends
  std::size_t without_covariance = 0;  ///< of those: the covariance is not positive definite
  double mean = 0;             ///< mean of the others; degrees_of_freedom for correct covariances
  double share_99 = 0;         ///< share of `motions` within the ellipsoid that should contain 99 %
  int degrees_of_freedom = 6;  ///< 3 for an estimate in the plane
};

/// Compares motions with the truth, one at a time in the order of frames.
class MotionErrors {
 public:
  /// `planar`: only the motion in the plane counts (camera x, z and the turn about y).
  MotionErrors(const Trajectory& truth, bool planar);
  /// `motion` is since the motion that was added before.
  void add(const Motion& motion);
  MotionConsistency result() const;

 private:
  const Trajectory& truth_;
  bool planar_;
  Trajectory::const_iterator next_;
  const TrajectoryPose* before_ = nullptr;  ///< truth at the motion before; null for none
  MotionConsistency sums_;                  ///< `mean` and `share_99` not yet divided
};

/// Null numbers, with the cause in `reason`, where no motion could be compared.
nlohmann::ordered_json toJson(const MotionConsistency& consistency);

}  // namespace tolman::evaluation
