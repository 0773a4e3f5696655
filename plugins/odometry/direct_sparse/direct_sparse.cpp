// SPDX-License-Identifier: BSD-3-Clause
// The steps of one frame: tracking, keyframe, report.
#include "direct_sparse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "feature_guess.hpp"
#include "lost_motion.hpp"
#include "odometry_input.hpp"
#include "standing.hpp"

namespace tolman::direct_sparse {
namespace {

// Grey levels, standard deviation: images below it (covered, dark, saturated) are not used.
// Chosen, not tuned.
constexpr float kWeakestContrast = 3;

/// Brightness of a frame that is seen through `relative` from a frame of brightness `reference`.
Affine composed(const Affine& reference, const Affine& relative) {
  return {reference.a + relative.a, relative.b + std::exp(relative.a) * reference.b};
}

/// Tracking and the window use the same images, so an adjustment moves keyframes by centimetres and
/// fractions of a degree. A larger change means that the window is wrong.
bool isSound(const AdjustmentResult& adjustment, double largest_metres) {
  constexpr double kLargestRadians = 0.05;  // 3 degrees; chosen, not tuned
  return adjustment.metres < largest_metres && adjustment.radians < kLargestRadians;
}

Affine relative(const Affine& reference, const Affine& other) {
  const double a = other.a - reference.a;
  return {a, other.b - std::exp(a) * reference.b};
}

std::string pixelText(double pixels) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f", pixels);
  return text.data();
}

template <class P>
Status bind(const ParameterValues& values, Parameters& parameters) {
  const Result<P> bound = bindParameters<P>(values);
  if (bound.isOk()) parameters = bound.value();
  return bound.status();
}

}  // namespace

Status DirectSparse::configure(const Context& context) {
  const Status bound = cameras_ == Cameras::Single
                           ? bind<MonoParameters>(context.parameters, parameters_)
                           : bind<Parameters>(context.parameters, parameters_);
  if (!bound.isOk()) return bound;
  rig_ = context.rig;
  if (Status status = checkRig(); !status.isOk()) return status;
  log_ = &context.log;
  MapperSettings settings;
  settings.points = parameters_.points;
  // Candidates of a keyframe: about as many points leave the window with each. Chosen, not tuned.
  settings.candidates = parameters_.points * (cameras_ == Cameras::Single ? 3 : 4) /
                        (cameras_ == Cameras::Single ? 4 : 5);
  settings.window = parameters_.window;
  settings.max_disparity =
      std::clamp(static_cast<int>(largestDisparity(rig_)) + 1, 8, kMaxDisparities);
  settings.offset_sigma = parameters_.offset_sigma;
  settings.column_sigma = parameters_.offset_sigma > 0 ? parameters_.column_sigma : 0;
  settings.calibration_distance = parameters_.calibration_distance;
  settings.row_sigma = cameras_ == Cameras::Stereo ? parameters_.row_sigma : 0;
  settings.adjustment.iterations = parameters_.iterations;
  settings.adjustment.system.lambda = static_cast<float>(parameters_.coupling);
  const bool scale_is_free = cameras_ == Cameras::Single || parameters_.coupling == 0;
  if (scale_is_free) settings.adjustment.scale = Scale::Free;
  mapper_.configure(rig_, settings);
  return reset();
}

Status DirectSparse::reset() {
  mapper_.forgetCameras();
  mapper_.reset();
  tracker_.reset();
  history_.clear();
  brightness_ = Affine();
  reference_brightness_ = Affine();
  velocity_.setZero();
  recent_velocities_.clear();
  pose_covariance_.setZero();
  has_velocity_ = false;
  can_track_ = false;
  last_stamp_ns_ = -1;
  first_lost_ = -1;
  gap_s_ = 0;
  lost_frames_ = 0;
  untracked_in_a_row_ = 0;
  draft_frames_ = 0;
  had_keyframe_ = false;
  return Status::ok();
}

Status DirectSparse::checkRig() const {
  if (Status status = requireCalibrated(rig_, cameras_ == Cameras::Stereo); !status.isOk()) {
    return status;
  }
  constexpr int kSmallest = 48;  // px; chosen, not tuned
  if (std::min(rig_.width, rig_.height) >= kSmallest) return Status::ok();
  return Status::unsupported("images of " + std::to_string(rig_.width) + "x" +
                             std::to_string(rig_.height) + " pixels are too small; give at least " +
                             std::to_string(kSmallest) + " pixels each way");
}

bool DirectSparse::buildLeft(const Frame& frame) {
  if (frame.left.empty()) return false;
  // With a right image depths are measured in spite of noise, and smoothing costs accuracy.
  const auto noise =
      cameras_ == Cameras::Single ? ImagePyramid::Noise::Smooth : ImagePyramid::Noise::Keep;
  current_.build(frame.left, ImagePyramid::kMaxLevels, noise);
  return grayStatistics(current_.level(0)).deviation >= kWeakestContrast;
}

void DirectSparse::buildRight(const Frame& frame) {
  right_.clear();
  if (frame.right.empty() || cameras_ == Cameras::Single) return;
  right_.build(frame.right, 1);
  if (grayStatistics(right_.level(0)).deviation < kWeakestContrast) right_.clear();
  if (!right_.empty()) mapper_.rows().correct(right_.level(0));
}

Status DirectSparse::track(const Frame& frame, Motion& motion) {
  Status status = requireImages(frame, rig_, cameras_ == Cameras::Stereo);
  if (!status.isOk()) return status;
  motion.frame = frame.frame;
  motion.stamp_ns = frame.stamp_ns;
  motion.scale_known = cameras_ == Cameras::Stereo;
  motion.dt = last_stamp_ns_ < 0 ? 0 : 1e-9 * static_cast<double>(frame.stamp_ns - last_stamp_ns_);
  last_stamp_ns_ = frame.stamp_ns;
  answer(buildLeft(frame), frame, motion);
  setPlanarVelocity(motion, motion.dt);
  return Status::ok();
}

Expectation DirectSparse::expect(double dt) const {
  const Window& window = mapper_.window();
  Expectation expectation;
  expectation.T_reference_previous = window.newest().T_camera_world() * history_.lastPose();
  if (has_velocity_) expectation.T_previous_current = expSe3(velocity_ * dt);
  expectation.has_velocity = has_velocity_;
  expectation.brightness = reference_brightness_;
  return expectation;
}

void DirectSparse::answer(bool visible, const Frame& frame, Motion& motion) {
  if (history_.empty()) {
    if (visible) restart(frame, motion);
    motion.T_previous_current.setIdentity();
    motion.state = TrackingState::Initialising;
    if (motion.dt > 0) motion.covariance = predictionCovariance(motion.T_previous_current, 100);
    return;
  }
  if (visible && can_track_) {
    if (const auto tracked = align(frame, motion.dt)) {
      answerMeasured(*tracked, frame, motion);
      return;
    }
    ++untracked_in_a_row_;
  }
  answerPredicted(mapper_.window().newest(), motion);
  // A single disturbed image must not discard the window; a window with assumed depths is replaced
  // after the first failure.
  const int patience = mapper_.isDraft() ? 1 : 2;  // frames
  if (visible && (!can_track_ || untracked_in_a_row_ >= patience)) restart(frame, motion);
}

/// Direct alignment from the expected motion; if that fails, from the pose found by features.
std::optional<AlignmentResult> DirectSparse::align(const Frame& frame, double dt) {
  const Expectation expectation = expect(dt);
  if (mapper_.isDraft()) return trackDraft(expectation);
  const auto isGood = [&](const std::optional<AlignmentResult>& tracked) {
    return tracked && isPlausible(*tracked, dt) && !contradictsStereo(*tracked, frame);
  };
  const auto tracked = tracker_.track(rig_, current_, expectation);
  if (isGood(tracked)) return tracked;
  const Eigen::Isometry3d expected =
      (expectation.T_reference_previous * expectation.T_previous_current).inverse();
  const auto guess = guessByFeatures(rig_, mapper_.window(), current_.level(0), expected);
  if (!guess) return std::nullopt;
  const auto refined = tracker_.refine(rig_, current_, {*guess, expectation.brightness});
  return isGood(refined) ? refined : std::nullopt;
}

/// Few samples, or road marks and fences after a gap, may also fit at a wrong place, which would
/// need an acceleration of more than one g. The reversed velocity is allowed too, for clips that
/// are played forwards and backwards. The limits were chosen on faults of KITTI 06
/// (docs/report/odometry.md).
bool DirectSparse::isPlausible(const AlignmentResult& tracked, double dt) const {
  const bool in_metres = cameras_ == Cameras::Stereo;
  if (!has_velocity_ || !in_metres) return true;
  constexpr double kAcceleration = 10;  // m/s^2
  constexpr double kSlack = 0.2;        // m
  constexpr double kShare = 0.1;        // of the expected translation since the last frame
  const Eigen::Vector3d moved = (history_.lastPose().inverse() * poseOf(tracked)).translation();
  const Eigen::Vector3d expected = expSe3(velocity_ * dt).translation();
  const double error = std::min((moved - expected).norm(), (moved + expected).norm());
  const double since = gap_s_ + dt;
  return error < 0.5 * kAcceleration * since * since + kSlack + kShare * expected.norm();
}

/// After a gap the frame may have been aligned at a wrong place: compares with its static stereo.
bool DirectSparse::contradictsStereo(const AlignmentResult& tracked, const Frame& frame) {
  if (first_lost_ < 0) return false;
  buildRight(frame);
  if (right_.empty()) return false;
  return !mapper_.compareWithStereo(poseOf(tracked), current_, right_).confirms();
}

std::optional<AlignmentResult> DirectSparse::trackDraft(Expectation expectation) {
  constexpr int kRounds = 2;  // chosen, not tuned
  std::vector<ImmaturePoint>& candidates = mapper_.window().newest().immature;
  auto tracked = tracker_.track(rig_, current_, expectation, Tracker::Demand::Guess);
  for (int round = 1; tracked && round <= kRounds; ++round) {
    const std::vector<ImmaturePoint> before = candidates;
    const Eigen::Isometry3d T_world_camera = poseOf(*tracked);
    const Affine& brightness = tracked->state.brightness;
    mapper_.observe(T_world_camera, composed(mapper_.window().newest().affine(), brightness),
                    current_);
    const bool enough = tracker_.setReference(rig_, mapper_.window());
    candidates = before;  // the frame is observed again when its pose is final
    if (!enough) return std::nullopt;
    expectation.T_previous_current = history_.lastPose().inverse() * T_world_camera;
    expectation.brightness = brightness;
    expectation.has_velocity = true;
    tracked = tracker_.track(rig_, current_, expectation,
                             round < kRounds ? Tracker::Demand::Guess : Tracker::Demand::Certain);
  }
  return tracked;
}

Eigen::Isometry3d DirectSparse::poseOf(const AlignmentResult& tracked) const {
  return normalised(mapper_.window().newest().T_world_camera() *
                    tracked.state.T_current_reference.inverse());
}

Status DirectSparse::finish(std::vector<MotionRevision>& revisions) {
  if (const RowAlignment& rows = mapper_.rows(); rows.isCorrecting()) {
    log_->info("rows of the right images were off by " + pixelText(rows.field().rms()) +
               " px (root mean square over the image) and have been corrected");
  }
  if (const DisparityField& field = mapper_.window().field; field.isOn()) {
    log_->info("disparities had errors of " + pixelText(field.atInfinity().rmsWithoutOffset()) +
               " px (root mean square over the image) and an offset of " +
               pixelText(field.offset()) + " px, which have been corrected");
  }
  std::vector<MotionRevision> owed = history_.finish();
  revisions.insert(revisions.end(), owed.begin(), owed.end());
  return Status::ok();
}

Eigen::Isometry3d DirectSparse::remember(const Eigen::Isometry3d& T_world_camera,
                                         const Keyframe& keyframe, const Motion& motion) {
  return history_.add(motion.frame, T_world_camera, keyframe.frame, keyframe.T_camera_world(),
                      motion.covariance, motion.dt);
}

bool DirectSparse::wantsKeyframe(const AlignmentResult& tracked) const {
  constexpr int kDraftFrames = 2;  // that must refine the assumed depths first; chosen, not tuned
  if (mapper_.isDraft() && draft_frames_ < kDraftFrames) return false;
  // Engel et al., section 3.1: a keyframe when a weighted sum of flow, flow without rotation and
  // brightness change exceeds 1. The weights are those of DSO, 0.04 and 0.02
  // for flow relative to 640 + 480 px, and 2; so is the limit of twice the first RMS. The limits of
  // view and coverage (shares) are our own: chosen, not tuned.
  constexpr double kTranslationFlow = 0.04 * (640 + 480);
  constexpr double kFlow = 0.02 * (640 + 480);
  const double size = rig_.width + rig_.height;
  const double change = parameters_.keyframe_weight *
                            (kTranslationFlow * tracked.translation_flow + kFlow * tracked.flow) /
                            size +
                        2 * std::fabs(tracked.state.brightness.a);
  return change > 1 || tracked.rms > 2 * tracker_.firstRms() || tracked.in_view < 0.6 ||
         tracked.coverage < 0.8;
}

void DirectSparse::answerMeasured(const AlignmentResult& tracked, const Frame& frame,
                                  Motion& motion) {
  const Keyframe& reference = mapper_.window().newest();
  const Eigen::Isometry3d T_world_camera = poseOf(tracked);
  if (first_lost_ >= 0) history_.interpolate(first_lost_, T_world_camera, motion.dt);
  brightness_ = composed(reference.affine(), tracked.state.brightness);
  const Eigen::Isometry3d T_previous_current =
      normalised(history_.lastPose().inverse() * T_world_camera);
  motion.covariance = motionCovariance(tracked, T_previous_current);
  motion.tracked = tracked.samples;
  motion.state = TrackingState::Tracking;
  Eigen::Isometry3d T_world_final = T_world_camera;
  if (wantsKeyframe(tracked)) {
    const std::int64_t draft = mapper_.isDraft() ? mapper_.window().newest().frame : -1;
    if (!makeKeyframe(frame, T_world_camera, brightness_, motion)) {
      abandonWindow(frame, motion);
      return;
    }
    T_world_final = mapper_.window().newest().T_world_camera();
    // Motions of frames tracked against assumed depths have a wrong scale.
    if (draft >= 0) history_.interpolate(draft + 1, T_world_final, motion.dt);
    pose_covariance_.setZero();
    motion.revisions = history_.removeOld(findKeyframe());
  } else {
    mapper_.observe(T_world_camera, brightness_, current_);
    if (mapper_.isDraft()) can_track_ = tracker_.setReference(rig_, mapper_.window());
  }
  if (first_lost_ < 0 && !mapper_.isDraft()) {
    T_world_final = heldWhileStanding(history_.lastPose(), T_world_final, motion.covariance);
  }
  // After a gap the reported motion also corrects the error of the predicted motions.
  const Eigen::Isometry3d step = history_.lastPose().inverse() * T_world_final;
  motion.T_previous_current = remember(T_world_final, mapper_.window().newest(), motion);
  reference_brightness_ = relative(mapper_.window().newest().affine(), brightness_);
  if (first_lost_ >= 0) recent_velocities_.clear();
  if (motion.dt > 0) {
    velocity_ = logSe3(normalised(step)) / motion.dt;
    recent_velocities_.add(velocity_);
  }
  has_velocity_ = motion.dt > 0;
  if (mapper_.isDraft()) {
    answerDraft(motion);
  } else {
    const std::vector<MotionRevision> changed = history_.largeRevisions();
    motion.revisions.insert(motion.revisions.end(), changed.begin(), changed.end());
  }
  if (first_lost_ >= 0) log_->info("tracking again");
  first_lost_ = -1;
  gap_s_ = 0;
  lost_frames_ = 0;
  untracked_in_a_row_ = 0;
}

void DirectSparse::answerDraft(Motion& motion) {
  ++draft_frames_;
  if (had_keyframe_) return;  // after a loss the motion is reported, although its scale is a guess
  history_.setLastReportedIdentity();
  motion.state = TrackingState::Initialising;
  motion.T_previous_current.setIdentity();
  motion.covariance = predictionCovariance(motion.T_previous_current, 100);
}

bool DirectSparse::makeKeyframe(const Frame& frame, const Eigen::Isometry3d& T_world_camera,
                                const Affine& affine, Motion& motion) {
  buildRight(frame);
  // Without a right image depth comes from motion only. In a sharp turn every frame is a keyframe,
  // so keyframes too must refine the depths of the candidates.
  if (right_.empty()) mapper_.observe(T_world_camera, affine, current_);
  const bool was_draft = mapper_.isDraft();  // assumed depths may change by any amount
  mapper_.addKeyframe(frame.frame, T_world_camera, affine, current_, right_);
  const bool is_sound = isSound(mapper_.adjustment(), parameters_.largest_adjustment);
  if (!was_draft && !is_sound) return false;
  had_keyframe_ = true;
  can_track_ = tracker_.setReference(rig_, mapper_.window());
  history_.followKeyframes(findKeyframe());
  brightness_ = mapper_.window().newest().affine();
  motion.is_keyframe = true;
  publishPoints(motion);
  return true;
}

void DirectSparse::abandonWindow(const Frame& frame, Motion& motion) {
  log_->warning("the adjusted window contradicts tracking; a new window is started");
  motion.tracked = 0;
  const Window& window = mapper_.window();
  answerPredicted(window.keyframe(window.order().front()), motion);
  buildLeft(frame);  // again: addKeyframe() has moved the pyramid into the window
  restart(frame, motion);
}

void DirectSparse::answerPredicted(const Keyframe& keyframe, Motion& motion) {
  if (first_lost_ < 0) {
    first_lost_ = motion.frame;
    log_->warning("tracking lost; the motion is predicted until tracking succeeds again");
  }
  ++lost_frames_;
  const LostMotion lost = lostMotion(recent_velocities_.median(), gap_s_, motion.dt, lost_frames_);
  gap_s_ += motion.dt;
  motion.state = TrackingState::Lost;
  motion.covariance = lost.covariance;
  motion.T_previous_current =
      remember(normalised(history_.lastPose() * lost.T_previous_current), keyframe, motion);
}

void DirectSparse::restart(const Frame& frame, Motion& motion) {
  const bool first = history_.empty();
  const Eigen::Isometry3d T_world_camera =
      first ? Eigen::Isometry3d::Identity() : history_.lastPose();
  mapper_.reset();
  tracker_.reset();
  if (cameras_ == Cameras::Single) {
    mapper_.draftKeyframe(frame.frame, T_world_camera, parameters_.camera_height, current_);
    can_track_ = tracker_.setReference(rig_, mapper_.window());
    motion.is_keyframe = true;
    draft_frames_ = 0;
  } else {
    makeKeyframe(frame, T_world_camera, Affine(), motion);
  }
  brightness_ = reference_brightness_ = Affine();
  if (first) {
    remember(T_world_camera, mapper_.window().newest(), motion);
  }
  motion.revisions = history_.removeOld(findKeyframe());
  untracked_in_a_row_ = 0;
}

Matrix6d DirectSparse::motionCovariance(const AlignmentResult& tracked,
                                        const Eigen::Isometry3d& T_previous_current) {
  // Number of samples per independent sample: errors of neighbouring samples are correlated, and
  // samples share the errors of depths. It multiplies the variance. Chosen on the first 200 frames
  // of the town along KITTI 07 (with 20, 8 % of the errors were outside of their 99 % ellipsoid).
  constexpr double kCorrelation = 30;
  Eigen::Matrix<double, 8, 8> information = tracked.information;
  information.diagonal().array() += 1e-6;  // keeps the solution finite
  const Eigen::Matrix<double, 8, 8> covariance = information.ldlt().solve(
      Eigen::Matrix<double, 8, 8>::Identity() * (kCorrelation * tracked.rms * tracked.rms));
  // The aligner perturbs the reference side; the record needs the tangent space of the new frame.
  const Matrix6d A = adjointSe3(tracked.state.T_current_reference);
  const Matrix6d own = A * covariance.topLeftCorner<6, 6>() * A.transpose();
  const Matrix6d B = adjointSe3(T_previous_current.inverse());
  Matrix6d both = own + B * pose_covariance_ * B.transpose();
  both = (0.5 * (both + both.transpose())).eval();
  both.diagonal().array() += 1e-12;  // m^2, rad^2; positive definite in spite of rounding
  pose_covariance_ = own;
  return both;
}

void DirectSparse::publishPoints(Motion& motion) const {
  constexpr float kGreyVariance = 16;  // as in mapper.cpp
  const Keyframe& newest = mapper_.window().newest();
  motion.points_frame = motion.frame;
  motion.points.resize(4, static_cast<Eigen::Index>(newest.points.size()));
  for (std::size_t i = 0; i < newest.points.size(); ++i) {
    const Point& p = newest.points[i];
    motion.points.col(static_cast<Eigen::Index>(i)) =
        Eigen::Vector4f(p.u, p.v, p.inverse_depth, kGreyVariance / std::max(p.information, 1e-3F));
  }
}

}  // namespace tolman::direct_sparse
