// SPDX-License-Identifier: BSD-3-Clause
// The steps of one frame: tracking, pose, keyframe, report.
#include "feature_stereo.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "lost_motion.hpp"
#include "odometry_input.hpp"
#include "standing.hpp"
#include "stereo_matching.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::feature_stereo {

namespace {

/// CV_8UC1, or empty for an image without contrast: missing, dark, saturated, covered.
cv::Mat usableGray(const Image& image) {
  cv::Mat gray = asMat(image);
  if (gray.empty()) return {};
  if (gray.channels() == 3) cv::cvtColor(asMat(image), gray, cv::COLOR_BGR2GRAY);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(gray, mean, deviation);
  constexpr double kWeakestContrast = 3;  // grey levels, standard deviation; chosen, not tuned
  return deviation[0] < kWeakestContrast ? cv::Mat() : gray;
}

StereoPixel toStereoPixel(const cv::Point2f& pixel, float disparity, double offset = 0) {
  return {pixel.x, pixel.y, std::isnan(disparity) ? 0.0 : disparity - offset};
}

}  // namespace

Status FeatureOdometry::configure(const Context& context) {
  if (Status status = readParameters(context.parameters); !status.isOk()) return status;
  rig_ = context.rig;
  if (Status status = requireCalibrated(rig_, needsPair()); !status.isOk()) return status;
  if (!needsPair()) rig_.baseline = kVirtualBaseline;
  log_ = &context.log;
  seed_ = context.seed;
  useSettings();
  return reset();
}

Status FeatureOdometry::readParameters(const ParameterValues& values) {
  if (needsPair()) {
    const Result<Parameters> bound = bindParameters<Parameters>(values);
    if (bound.isOk()) parameters_ = bound.value();
    return bound.status();
  }
  const Result<RgbdParameters> bound = bindParameters<RgbdParameters>(values);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  depth_noise_ = bound.value().depth_noise;
  return Status::ok();
}

void FeatureOdometry::useSettings() {
  const Parameters& p = parameters_;
  corner_settings_.count = p.corners;
  stereo_settings_.track.levels = 2;  // guesses along rows are good
  stereo_settings_.max_disparity = largestDisparity(rig_);
  PixelNoise noise;
  double offset_sigma = p.offset_sigma;
  if (!needsPair()) {
    constexpr double kNever = 1e9;  // px of disparity: the noise does not grow with it
    // An error s z^2 of the depth z = fx b / d is an error s fx b of d, at any depth.
    noise.disparity = depth_noise_ * rig_.pinhole.fx * rig_.baseline;
    noise.doubling = kNever;
    offset_sigma = 0;
  }
  pnp_settings_.noise = noise;
  refinement_settings_.noise = noise;
  refinement_settings_.offset_sigma = offset_sigma;
}

Status FeatureOdometry::reset() {
  random_ = RandomStream(seed_);
  window_ = Window();
  history_.clear();
  reference_ = FlowPyramid();
  tracks_.clear();
  T_world_reference_.setIdentity();
  velocity_.setZero();
  last_stamp_ns_ = -1;
  first_lost_ = -1;
  lost_frames_ = 0;
  lost_s_ = 0;
  keyframe_tracks_ = 0;
  fresh_depth_ = FreshDepth();
  told_depth_ = false;
  return Status::ok();
}

Status FeatureOdometry::track(const Frame& frame, Motion& motion) {
  if (Status status = requireImages(frame, rig_, needsPair()); !status.isOk()) return status;
  if (!needsPair()) {
    if (Status status = requireDepth(frame, rig_); !status.isOk()) return status;
  }
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  motion.dt = last_stamp_ns_ < 0 ? 0 : 1e-9 * double(frame.stamp_ns - last_stamp_ns_);
  last_stamp_ns_ = frame.stamp_ns;
  const NamedArray* depth = needsPair() ? nullptr : depthImage(frame);
  const FreshDepth::Kind kind = fresh_depth_.judge(depth);
  views_.depth = kind == FreshDepth::Kind::Fresh ? depth : nullptr;
  answer(lookAt(frame) ? &views_ : nullptr, motion);
  views_.depth = nullptr;  // it is the frame's
  tellDepth(kind, motion);
  setPlanarVelocity(motion, motion.dt);
  return Status::ok();
}

void FeatureOdometry::tellDepth(FreshDepth::Kind kind, const Motion& motion) {
  // A camera at rest may give an image twice in a simulation. Chosen, not tuned.
  constexpr double kMoved_m = 0.01;
  constexpr double kMoved_px = 1;
  const Eigen::Isometry3d& T = motion.T_previous_current;
  const double turned_px = rig_.pinhole.fx * Eigen::AngleAxisd(T.linear()).angle();
  const bool has_moved = T.translation().norm() > kMoved_m || turned_px > kMoved_px;
  const bool is_fault =
      kind == FreshDepth::Kind::Constant || (kind == FreshDepth::Kind::Repeated && has_moved);
  if (is_fault && !told_depth_) {
    log_->warning(kind == FreshDepth::Kind::Constant
                      ? "the depth image has one value everywhere; it is not used"
                      : "the depth image repeats that of the frame before, although the camera "
                        "moves; it is not used");
  }
  if (is_fault || kind == FreshDepth::Kind::Fresh) told_depth_ = is_fault;
}

bool FeatureOdometry::lookAt(const Frame& frame) {
  const cv::Mat left = usableGray(frame.left);
  if (left.empty()) return false;
  if (needsPair()) {
    const cv::Mat right = usableGray(frame.right);
    if (right.empty()) return false;
    views_.right.build(right, track_settings_.window, stereo_settings_.track.levels);
  }
  views_.left.build(left, track_settings_.window, track_settings_.levels);
  return true;
}

std::vector<float> FeatureOdometry::disparitiesOf(const Views& views,
                                                  const std::vector<cv::Point2f>& corners,
                                                  const std::vector<float>& guesses) const {
  if (needsPair()) {
    return matchStereo(views.left, views.right, corners, guesses, stereo_settings_);
  }
  if (views.depth == nullptr) return std::vector<float>(corners.size(), kNoDisparity);
  return depthDisparities(*views.depth, corners, rig_.pinhole.fx * rig_.baseline);
}

void FeatureOdometry::answer(const Views* views, Motion& motion) {
  const bool started = !history_.empty();
  // Frames; afterwards the last tracked view is not searched for. Chosen, not tuned.
  constexpr int kLongestGap = 100;
  if (started && views != nullptr && lost_frames_ <= kLongestGap) {
    if (auto tracked = trackAny(*views, predictPose(motion.dt))) {
      answerMeasured(*views, std::move(*tracked), motion);
      return;
    }
  }
  if (started) answerPredicted(motion);
  if (views != nullptr) restart(*views, motion);
  if (!started) {
    motion.state = TrackingState::Initialising;
    // No motion was measured yet: as uncertain as after 100 lost frames. Chosen, not tuned.
    constexpr int kUnknownFrames = 100;
    if (motion.dt > 0) {
      motion.covariance = predictionCovariance(motion.T_previous_current, kUnknownFrames);
    }
  }
}

Status FeatureOdometry::finish(std::vector<MotionRevision>& revisions) {
  const std::vector<MotionRevision> last = history_.finish();
  revisions.insert(revisions.end(), last.begin(), last.end());
  return Status::ok();
}

Eigen::Isometry3d FeatureOdometry::predictPose(double dt) const {
  return history_.lastPose() * expSe3(velocity_ * dt);
}

Eigen::Isometry3d FeatureOdometry::remember(const Eigen::Isometry3d& T_world_camera,
                                            const Keyframe& keyframe, const Motion& motion) {
  return history_.add(motion.frame, T_world_camera, keyframe.frame,
                      keyframe.T_world_camera.inverse(), motion.covariance, motion.dt);
}

std::optional<FeatureOdometry::Tracked> FeatureOdometry::trackAny(
    const Views& views, const Eigen::Isometry3d& predicted) {
  std::optional<Tracked> best = trackFrom(views, predicted);
  if (best && 2 * best->tracks.size() >= best->attempted) return best;
  // Fewer than half were found: the camera may have stopped or reversed.
  std::optional<Tracked> still = trackFrom(views, T_world_reference_);
  const bool better = still && (!best || still->tracks.size() > best->tracks.size());
  return better ? still : best;
}

std::optional<FeatureOdometry::Tracked> FeatureOdometry::trackFrom(const Views& views,
                                                                   const Eigen::Isometry3d& guess) {
  const double offset = window_.disparityOffset();
  std::vector<cv::Point2f> from;
  std::vector<cv::Point2f> to;
  std::vector<float> disparities;
  for (const Track& track : tracks_) {
    const auto pixel = project(rig_, guess, window_.find(track.landmark)->point);
    from.push_back(track.pixel);
    to.push_back(pixel ? cv::Point2f(float(pixel->x()), float(pixel->y())) : track.pixel);
    disparities.push_back(pixel ? float(pixel->z() + offset) : kNoDisparity);
  }
  const std::vector<bool> found = trackCorners(reference_, views.left, from, to, track_settings_);
  std::vector<Track> tracks;
  std::vector<cv::Point2f> pixels;
  std::vector<float> guesses;
  for (std::size_t i = 0; i < tracks_.size(); ++i) {
    if (!found[i]) continue;
    tracks.push_back(tracks_[i]);
    pixels.push_back(to[i]);
    guesses.push_back(disparities[i]);
  }
  const std::vector<float> matched = disparitiesOf(views, pixels, guesses);
  std::vector<PointMatch> matches;
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    tracks[i].pixel = pixels[i];
    tracks[i].disparity = matched[i];
    const Landmark& landmark = *window_.find(tracks[i].landmark);
    matches.push_back({landmark.point, landmark.covariance,
                       toStereoPixel(pixels[i], matched[i], offset), !std::isnan(matched[i])});
  }
  auto pose = estimatePose(rig_, matches, guess, pnp_settings_, random_);
  if (!pose) return std::nullopt;
  Tracked tracked{*pose, {}, tracks_.size()};
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    if (pose->inlier[i]) tracked.tracks.push_back(tracks[i]);
  }
  return tracked;
}

std::vector<FeatureOdometry::StereoCorner> FeatureOdometry::findCandidates(
    const Views& views, const std::vector<Track>& tracks) const {
  std::vector<cv::Point2f> occupied;
  occupied.reserve(tracks.size());
  for (const Track& track : tracks) occupied.push_back(track.pixel);
  const std::vector<cv::Point2f> corners =
      detectCorners(views.left.level(0), occupied, corner_settings_);
  const std::vector<float> guesses(corners.size(), kNoDisparity);
  const std::vector<float> disparities = disparitiesOf(views, corners, guesses);
  std::vector<StereoCorner> candidates;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!std::isnan(disparities[i])) candidates.push_back({corners[i], disparities[i]});
  }
  return candidates;
}

bool FeatureOdometry::wantsKeyframe() const {
  std::vector<double> flows;
  for (const Track& track : tracks_) {
    flows.push_back(cv::norm(track.pixel - track.keyframe_pixel));
  }
  const auto middle = flows.begin() + static_cast<std::ptrdiff_t>(flows.size() / 2);
  std::nth_element(flows.begin(), middle, flows.end());
  constexpr double kSurvival = 0.75;  // share of corners below which new ones are due; chosen
  return *middle >= parameters_.keyframe_flow ||
         double(tracks_.size()) < kSurvival * double(keyframe_tracks_);
}

Eigen::Isometry3d FeatureOdometry::makeKeyframe(const Keyframe& keyframe,
                                                const std::vector<StereoCorner>& candidates) {
  window_.addKeyframe(keyframe);
  for (Track& track : tracks_) {
    track.keyframe_pixel = track.pixel;
    Landmark& landmark = *window_.find(track.landmark);
    Observation seen{keyframe.frame, toStereoPixel(track.pixel, track.disparity),
                     !std::isnan(track.disparity)};
    const auto predicted = project(rig_, keyframe.T_world_camera, landmark.point);
    if (!seen.has_disparity && predicted) seen.pixel.z() = predicted->z();
    landmark.observations.push_back(seen);
  }
  for (const StereoCorner& candidate : candidates) {
    const StereoPixel pixel =
        toStereoPixel(candidate.pixel, candidate.disparity, window_.disparityOffset());
    Landmark landmark;
    landmark.point = {keyframe.T_world_camera, triangulate(rig_, pixel)};
    landmark.covariance = triangulationCovariance(rig_, pnp_settings_.noise.sigma(pixel.z()));
    landmark.observations.push_back(
        {keyframe.frame, toStereoPixel(candidate.pixel, candidate.disparity), true});
    tracks_.push_back(
        {window_.addLandmark(landmark), candidate.pixel, candidate.pixel, candidate.disparity});
  }
  if (static_cast<int>(window_.keyframes().size()) > parameters_.window) window_.dropOldest();
  refineWindow(rig_, refinement_settings_, window_);
  std::erase_if(tracks_, [this](const Track& t) { return window_.find(t.landmark) == nullptr; });
  keyframe_tracks_ = tracks_.size();
  return window_.keyframes().back().T_world_camera;
}

void FeatureOdometry::answerMeasured(const Views& views, Tracked&& tracked, Motion& motion) {
  Eigen::Isometry3d T_world_camera = tracked.pose.T_world_camera;
  if (first_lost_ >= 0) history_.interpolate(first_lost_, T_world_camera, motion.dt);
  tracks_ = std::move(tracked.tracks);
  motion.tracked = tracked.pose.inliers;
  motion.is_keyframe = wantsKeyframe();
  if (motion.is_keyframe) {
    T_world_camera = makeKeyframe({motion.frame, T_world_camera}, findCandidates(views, tracks_));
    history_.followKeyframes(findKeyframe());
    motion.revisions = history_.removeOld(findKeyframe());
    publishPoints(motion);
  }
  const std::vector<MotionRevision> changed = history_.largeRevisions();
  motion.revisions.insert(motion.revisions.end(), changed.begin(), changed.end());
  motion.state = TrackingState::Tracking;
  motion.covariance = tracked.pose.covariance;
  const Eigen::Isometry3d T_world_reported =
      first_lost_ >= 0 ? T_world_camera
                       : heldWhileStanding(history_.lastPose(), T_world_camera, motion.covariance);
  motion.T_previous_current = remember(T_world_reported, window_.keyframes().back(), motion);
  if (motion.dt > 0) velocity_ = logSe3(motion.T_previous_current) / motion.dt;
  keepImage(T_world_camera);
  if (first_lost_ >= 0) log_->info("tracking again");
  first_lost_ = -1;
  lost_frames_ = 0;
  lost_s_ = 0;
}

void FeatureOdometry::keepImage(const Eigen::Isometry3d& T_world_camera) {
  std::swap(reference_, views_.left);
  T_world_reference_ = T_world_camera;
}

void FeatureOdometry::answerPredicted(Motion& motion) {
  if (first_lost_ < 0) {
    first_lost_ = motion.frame;
    log_->warning("tracking lost; the motion is predicted until tracking succeeds again");
  }
  ++lost_frames_;
  const LostMotion lost = lostMotion(velocity_, lost_s_, motion.dt, lost_frames_);
  lost_s_ += motion.dt;
  motion.state = TrackingState::Lost;
  motion.covariance = lost.covariance;
  const Eigen::Isometry3d T_world_camera = history_.lastPose() * lost.T_previous_current;
  motion.T_previous_current = remember(T_world_camera, window_.keyframes().back(), motion);
}

void FeatureOdometry::restart(const Views& views, Motion& motion) {
  const std::vector<StereoCorner> candidates = findCandidates(views, {});
  if (static_cast<int>(candidates.size()) < pnp_settings_.min_inliers) return;
  const Keyframe keyframe{motion.frame,
                          history_.empty() ? Eigen::Isometry3d::Identity() : history_.lastPose()};
  window_.clear();
  tracks_.clear();
  makeKeyframe(keyframe, candidates);
  if (history_.empty()) {
    remember(keyframe.T_world_camera, keyframe, motion);
  }
  motion.revisions = history_.removeOld(findKeyframe());
  motion.is_keyframe = true;
  publishPoints(motion);
  keepImage(keyframe.T_world_camera);
  first_lost_ = -1;
  lost_frames_ = 0;
  lost_s_ = 0;
}

void FeatureOdometry::publishPoints(Motion& motion) {
  constexpr double kMinInverseDepth = 1e-4;  // 1/m; leaves out points at infinity
  const double fb = rig_.pinhole.fx * rig_.baseline;
  std::vector<Eigen::Vector4f> points;
  for (const Track& track : tracks_) {
    const Landmark& landmark = *window_.find(track.landmark);
    ProjectionJacobians J;
    const auto pixel = project(rig_, window_.keyframes().back().T_world_camera, landmark.point, &J);
    if (!pixel || pixel->z() < kMinInverseDepth * fb) continue;
    const Eigen::RowVector3d by_point = J.point.row(2) / fb;
    const double variance = by_point * landmark.covariance * by_point.transpose();
    points.push_back(
        Eigen::Vector4d(pixel->x(), pixel->y(), pixel->z() / fb, variance).cast<float>());
  }
  motion.points_frame = motion.frame;
  motion.points.resize(4, static_cast<Eigen::Index>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    motion.points.col(static_cast<Eigen::Index>(i)) = points[i];
  }
}

}  // namespace tolman::feature_stereo
