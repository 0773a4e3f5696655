// SPDX-License-Identifier: BSD-3-Clause
// Order of the steps at a keyframe and between keyframes.
#include "mapper.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "bundle_adjustment.hpp"
#include "epipolar_search.hpp"
#include "tracker.hpp"

namespace tolman::direct_sparse {
namespace {

/// Assumed variance of grey values (standard deviation 4 levels; chosen, not tuned). The
/// photometric energy is in squared grey levels, so a prior of standard deviation sigma enters it
/// with kGreyVariance / sigma^2.
constexpr double kGreyVariance = 16;

}  // namespace

void Mapper::configure(const CameraRig& rig, const MapperSettings& settings) {
  rig_ = rig;
  settings_ = settings;
  window_.field.configure(rig.width, rig.height, rig.pinhole.fx, rig.pinhole.fx * rig.baseline,
                          settings.calibration_distance);
  settings_.adjustment.watch_field = settings.column_sigma > 0;
  rows_.configure(rig.width, rig.height, settings.row_sigma);
  forgetCameras();
  reset();
}

void Mapper::reset() {
  window_.clear();
  selector_.reset();
  activator_.reset();
  draft_ = false;
  adjustment_ = AdjustmentResult();
}

void Mapper::forgetCameras() {
  rows_.reset();
  decision_.reset();
  window_.field.setOn(false);
}

void Mapper::setFieldPrior() {
  constexpr double kLeast = 1e-6;  // px; keeps the division finite
  for (int k = 0; k < kFieldVariables; ++k) {
    const int degree = SmoothField::kDegrees[static_cast<std::size_t>(k)];
    const double wanted =
        degree == 0 ? settings_.offset_sigma : settings_.column_sigma / (1 + degree);
    const double sigma = std::max(wanted, kLeast);
    window_.prior.H(kOffsetIndex + k, kOffsetIndex + k) = kGreyVariance / (sigma * sigma);
  }
}

Keyframe& Mapper::insert(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                         const Affine& affine, ImagePyramid& left) {
  Keyframe& keyframe = window_.add();
  keyframe.frame = frame;
  keyframe.T0_camera_world = T_world_camera.inverse();
  keyframe.affine0 = affine;
  std::swap(keyframe.left, left);
  if (window_.size() == 1) setFieldPrior();
  selectCandidates(keyframe);
  return keyframe;
}

std::size_t Mapper::addKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                                const Affine& affine, ImagePyramid& left, ImagePyramid& right) {
  if (draft_) window_.newest().points.clear();
  draft_ = false;
  Keyframe& keyframe = insert(frame, T_world_camera, affine, left);
  std::swap(keyframe.right, right);
  keyframe.has_right = !keyframe.right.empty();
  if (keyframe.has_right) matchCandidates(keyframe);
  activator_.activate(rig_, settings_.adjustment.system, settings_.points, window_);
  adjustment_ = adjustWindow(rig_, adjustmentFor(keyframe), window_, system_);
  if (settings_.adjustment.watch_field && keyframe.has_right) {
    DisparityField& field = window_.field;
    const bool on = decision_.decide(field.isOn(), adjustment_.field_rms);
    if (on != field.isOn()) field.setOn(on);
  }
  dropOutliers(window_);
  shrink();
  return window_.pointCount();
}

AdjustmentSettings Mapper::adjustmentFor(const Keyframe& keyframe) const {
  constexpr int kFirstIterations = 30;  // chosen, not tuned; DSO has 20
  AdjustmentSettings settings = settings_.adjustment;
  const bool young = window_.size() < settings_.window && !keyframe.has_right;
  if (young) settings.iterations = std::max(settings.iterations, kFirstIterations);
  return settings;
}

void Mapper::draftKeyframe(std::int64_t frame, const Eigen::Isometry3d& T_world_camera,
                           double camera_height, ImagePyramid& left) {
  Keyframe& keyframe = insert(frame, T_world_camera, Affine(), left);
  draftDepths(rig_, camera_height, keyframe);
  draftPoints(keyframe);
  draft_ = true;
}

void Mapper::selectCandidates(Keyframe& keyframe) {
  const std::vector<Pixel>& pixels =
      selector_.select(keyframe.left.level(0), settings_.candidates, kStereoBorder);
  keyframe.immature.resize(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ImmaturePoint point;
    point.u = static_cast<float>(pixels[i].u);
    point.v = static_cast<float>(pixels[i].v);
    point.pattern = patternAt(keyframe.left.level(0), pixels[i].u, pixels[i].v);
    keyframe.immature[i] = point;
  }
}

void Mapper::matchCandidates(Keyframe& keyframe) {
  StereoSearch search;
  search.max_disparity = settings_.max_disparity;
  balanceBrightness(keyframe.left.level(0), keyframe.right.level(0), search);
  matches_.assign(keyframe.immature.size(), std::nullopt);
  tbb::parallel_for(std::size_t{0}, matches_.size(), [&](std::size_t i) {
    const ImmaturePoint& point = keyframe.immature[i];
    matches_[i] = matchStereo(keyframe.left.level(0), keyframe.right.level(0),
                              static_cast<int>(point.u), static_cast<int>(point.v), search);
  });
  balanceRight(keyframe, search);
  if (rows_.isOn()) learnRows(keyframe, search.gain);
  const auto focal_baseline = static_cast<float>(rig_.pinhole.fx * rig_.baseline);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    // Removed: without a clear match in its row, a point has no depth to begin with.
    if (!matches_[i]) continue;
    ImmaturePoint& point = keyframe.immature[i];
    const float disparity = matches_[i]->disparity;
    const auto error = static_cast<float>(window_.field.at(
        static_cast<double>(point.u - disparity), point.v, static_cast<double>(disparity)));
    point.inverse_depth = std::max((disparity + error) / focal_baseline, 1e-5F);
    point.sigma = matches_[i]->sigma / focal_baseline;
    point.quality = matches_[i]->quality;
    point.has_depth = true;
    keyframe.immature[kept++] = point;
  }
  keyframe.immature.resize(kept);
}

void Mapper::collectGreyPairs(const Keyframe& keyframe) {
  grey_pairs_.clear();
  const GrayLevel& right = keyframe.right.level(0);
  for (std::size_t i = 0; i < matches_.size(); ++i) {
    if (!matches_[i]) continue;
    const ImmaturePoint& point = keyframe.immature[i];
    const float u = point.u - matches_[i]->disparity;
    if (!right.contains(u, point.v, kPatternRadius)) continue;
    for (std::size_t k = 0; k < kPatternSize; ++k) {
      grey_pairs_.push_back(
          {point.pattern.value[k], right.at(u + static_cast<float>(kPatternU[k]),
                                            point.v + static_cast<float>(kPatternV[k]))});
    }
  }
}

void Mapper::balanceRight(Keyframe& keyframe, const StereoSearch& search) {
  collectGreyPairs(keyframe);
  double gain = search.gain;
  double offset = search.offset;
  for (int iteration = 0; iteration < 4; ++iteration) {  // bounds the time
    double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const GreyPair& pair : grey_pairs_) {
      const double x = pair.left;
      const double y = pair.right;
      const double w = huberWeight(static_cast<float>(y - gain * x - offset));
      n += w;
      sx += w * x;
      sy += w * y;
      sxx += w * x * x;
      sxy += w * x * y;
    }
    const double spread = n * sxx - sx * sx;
    if (!(n > 100) || !(spread > n * n)) break;  // pixels, and grey levels^2: chosen, not tuned
    // Larger ratios of exposure are not followed: chosen, not tuned.
    gain = std::clamp((n * sxy - sx * sy) / spread, 0.3, 3.0);
    offset = (sy - gain * sx) / n;
  }
  keyframe.right_gain = static_cast<float>(gain);
  keyframe.right_offset = static_cast<float>(offset);
}

void Mapper::learnRows(const Keyframe& keyframe, float gain) {
  constexpr std::size_t kMost = 400;  // bounds the time; chosen, not tuned
  const std::size_t step = 1 + matches_.size() / kMost;
  corners_.clear();
  for (std::size_t i = 0; i < matches_.size(); i += step) {
    if (!matches_[i]) continue;
    const ImmaturePoint& point = keyframe.immature[i];
    corners_.push_back(
        {static_cast<int>(point.u), static_cast<int>(point.v), matches_[i]->disparity});
  }
  rows_.observe(keyframe.left.level(0), keyframe.right.level(0), corners_, gain);
}

void Mapper::shrink() {
  const std::vector<int> leaving = chooseLeaving(window_, settings_.window);
  marginalisePoints(rig_, settings_.adjustment.system, leaving, settings_.marginal_weight, window_,
                    system_);
  for (const int slot : leaving) marginaliseKeyframe(slot, window_);
  projectOutGauge(window_);
}

void Mapper::observe(const Eigen::Isometry3d& T_world_camera, const Affine& affine,
                     const ImagePyramid& left) {
  observed_frame_.T0_camera_world = T_world_camera.inverse();
  observed_frame_.affine0 = affine;
  EpipolarSettings settings;
  // Chosen, not tuned; DSO has 0.027.
  settings.longest = 0.03F * static_cast<float>(rig_.width + rig_.height);
  for (const int slot : window_.order()) {
    Keyframe& keyframe = window_.keyframe(slot);
    const PairGeometry pair = pairGeometry(rig_.pinhole, keyframe, observed_frame_);
    tbb::parallel_for(std::size_t{0}, keyframe.immature.size(), [&](std::size_t i) {
      observeImmature(pair, left.level(0), settings, keyframe.immature[i]);
    });
  }
  if (draft_) draftPoints(window_.newest());
}

}  // namespace tolman::direct_sparse
