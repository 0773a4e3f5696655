// SPDX-License-Identifier: BSD-3-Clause
// Motion hypotheses and acceptance of their alignment.
#include "tracker.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tolman::direct_sparse {

namespace {

// Fewest samples for the eight variables of an alignment. Chosen, not tuned.
constexpr int kMinSamples = 100;

bool isAccepted(const AlignmentResult& result, Tracker::Demand demand) {
  // The limits of inliers and view are our own (chosen, not tuned); that of the brightness change
  // is the one of DSO (Engel et al.)
  const double least_inliers = demand == Tracker::Demand::Certain ? 0.6 : 0.3;
  constexpr double kMinInView = 0.15;
  constexpr double kMaxGain = 1.2;  // logarithm of the exposure ratio
  return result.samples >= kMinSamples && result.inlier_fraction > least_inliers &&
         result.in_view > kMinInView && std::fabs(result.state.brightness.a) < kMaxGain;
}

/// Least number of samples of an accepted alignment, as a share of the usual number. Chosen on
/// kitti_clips/06: blurred images leave a tenth, and their motion is wrong by a third.
constexpr double kMinShare = 0.15;
constexpr double kRenewal = 0.1;  // of a frame in the mean of samples; chosen, not tuned

/// Largest RMS of an accepted alignment: a wrong place may fit in part. Chosen on kitti_clips/06
/// with simulated faults: right alignments had at most twice the last RMS (behind a lorry, after
/// ten dark frames, in a blurred image), a wrong one four times (after two seconds without images).
double mostRms(double last_rms) {
  constexpr double kGrowth = 2.5;
  constexpr double kMin = 5;  // grey levels: dark and blurred images have smaller ones
  constexpr double kAny = std::numeric_limits<double>::max();
  return last_rms == 0 ? kAny : kGrowth * std::max(last_rms, kMin);
}

/// Motions since the last frame to try when the expected one fails: standing, other speeds, the
/// pose of the keyframe, starts of up to 3.3 m per frame (33 m/s at 10 Hz), and turns of up to 0.1
/// rad. The steps between are chosen, not tuned.
std::vector<Eigen::Isometry3d> hypotheses(const Expectation& expectation) {
  const Eigen::Isometry3d& expected = expectation.T_previous_current;
  std::vector<Eigen::Isometry3d> motions = {Eigen::Isometry3d::Identity()};
  if (expectation.has_velocity) {
    const Vector6d twist = logSe3(expected);
    for (const double factor : {1.0, 0.5, 2.0, -1.0}) motions.push_back(expSe3(factor * twist));
    motions.push_back(expectation.T_reference_previous.inverse());  // as the keyframe
  }
  for (const double metres : {0.3, 0.6, 1.0, 1.5, 2.0, 2.6, 3.3}) {
    for (const double sign : {1.0, -1.0}) {
      motions.emplace_back(Eigen::Translation3d(0, 0, sign * metres));
    }
  }
  const Eigen::Isometry3d base = expectation.has_velocity ? expected : motions.front();
  for (const double radians : {0.02, 0.05, 0.1}) {
    for (const double sign : {1.0, -1.0}) {
      for (const Eigen::Vector3d& axis :
           {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitY().eval(),
            Eigen::Vector3d::UnitZ().eval()}) {
        motions.push_back(base * Eigen::AngleAxisd(sign * radians, axis));
      }
    }
  }
  return motions;
}

}  // namespace

void Tracker::reset() {
  reference_.clear();
  usual_samples_ = 0;
  last_rms_ = 0;
  first_rms_ = 0;
}

bool Tracker::setReference(const CameraRig& rig, const Window& window) {
  reference_.build(rig, window);
  first_rms_ = 0;
  return reference_.level(0).count >= static_cast<std::size_t>(kMinSamples);
}

AlignmentResult Tracker::bestOf(const CameraRig& rig, const ImagePyramid& image,
                                const Expectation& expectation) {
  const int coarsest = reference_.levels() - 1;
  const int finest = std::max(0, std::min(2, coarsest));
  AlignmentResult best;
  double best_rms = std::numeric_limits<double>::max();
  for (const Eigen::Isometry3d& motion : hypotheses(expectation)) {
    AlignmentState guess;
    guess.T_current_reference = (expectation.T_reference_previous * motion).inverse();
    guess.brightness = expectation.brightness;
    const AlignmentResult result = aligner_.align(rig, reference_, image, guess, coarsest, finest);
    // Share in view: chosen, not tuned.
    if (result.in_view < 0.3 || result.rms >= best_rms) continue;
    best_rms = result.rms;
    best = result;
  }
  if (best_rms == std::numeric_limits<double>::max()) return best;
  return aligner_.align(rig, reference_, image, best.state, std::max(0, finest - 1), 0);
}

std::optional<AlignmentResult> Tracker::track(const CameraRig& rig, const ImagePyramid& image,
                                              const Expectation& expectation, Demand demand) {
  constexpr double kRmsGrowth =
      1.5;  // above it other motions are tried, as in the program of Engel et al.
  AlignmentResult result;
  bool good = false;
  if (expectation.has_velocity) {
    AlignmentState guess;
    guess.T_current_reference =
        (expectation.T_reference_previous * expectation.T_previous_current).inverse();
    guess.brightness = expectation.brightness;
    result = aligner_.align(rig, reference_, image, guess, reference_.levels() - 1, 0);
    good = isAccepted(result, demand) && (last_rms_ == 0 || result.rms < kRmsGrowth * last_rms_);
  }
  if (!good) {
    const AlignmentResult other = bestOf(rig, image, expectation);
    const bool better =
        isAccepted(other, demand) && (!isAccepted(result, demand) || other.rms < result.rms);
    if (better) result = other;
  }
  return accept(rig, result, demand) ? std::optional(result) : std::nullopt;
}

std::optional<AlignmentResult> Tracker::refine(const CameraRig& rig, const ImagePyramid& image,
                                               const AlignmentState& guess) {
  constexpr int kCoarsest = 2;  // level; chosen, not tuned
  AlignmentResult result = aligner_.align(rig, reference_, image, guess,
                                          std::min(kCoarsest, reference_.levels() - 1), 0);
  return accept(rig, result, Demand::Confirmed) ? std::optional(result) : std::nullopt;
}

bool Tracker::accept(const CameraRig& rig, AlignmentResult& result, Demand demand) {
  // An object that covers a part of the view makes the RMS large at the right place, too.
  const bool confirmed = demand == Demand::Confirmed;
  const bool is_alike = confirmed || result.rms <= mostRms(last_rms_);
  if (!isAccepted(result, demand) || !is_alike) return false;
  if (result.samples < kMinShare * usual_samples_) return false;
  usual_samples_ += kRenewal * (result.samples - usual_samples_);
  if (!confirmed) last_rms_ = result.rms;
  if (first_rms_ == 0) first_rms_ = result.rms;
  measureFlow(rig, reference_, result);
  return true;
}

// Inverse depths of ground and walls.

void draftDepths(const CameraRig& rig, double height, Keyframe& keyframe) {
  constexpr double kWall = 5;  // distance of the walls, in heights of the camera; chosen, not tuned
  constexpr double kFarthest = 40;    // largest depth, in heights of the camera; chosen, not tuned
  constexpr float kDeviation = 0.5F;  // of the inverse depth; chosen, not tuned
  for (ImmaturePoint& point : keyframe.immature) {
    const Eigen::Vector3d ray = rig.pinhole.ray({point.u, point.v});
    const double ground = ray.y();
    const double wall = std::fabs(ray.x()) / kWall;
    point.inverse_depth = static_cast<float>(std::max({ground, wall, 1 / kFarthest}) / height);
    point.sigma = kDeviation * point.inverse_depth;
    point.has_depth = true;
  }
}

void draftPoints(Keyframe& keyframe) {
  constexpr int kMaxFailures = 3;  // as in activation.cpp
  keyframe.points.clear();
  for (const ImmaturePoint& candidate : keyframe.immature) {
    if (candidate.failures >= kMaxFailures) continue;
    Point point;
    point.u = candidate.u;
    point.v = candidate.v;
    point.inverse_depth = candidate.inverse_depth;
    point.pattern = candidate.pattern;
    keyframe.points.push_back(point);
  }
}

}  // namespace tolman::direct_sparse
