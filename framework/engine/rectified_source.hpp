// SPDX-License-Identifier: BSD-3-Clause
// The source as the stages get it: with rectified images, and with true poses.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "engine/camera_check.hpp"
#include "engine/pixel_map.hpp"
#include "engine/services.hpp"
#include "evaluation/trajectory.hpp"
#include "host/stages.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::engine {

/// True poses for the frames of any source: of the file that `evaluation.truth` names, or of the
/// table that a folder of EuRoC, TUM-VI or TUM has beside its images.
class TruePath {
 public:
  /// Reads the file, if there is one. `source_path`: the folder of the images, or empty.
  static Result<TruePath> open(const config::EvaluationSettings& settings,
                               const std::string& source_path);
  bool isGiven() const { return !poses_.empty(); }
  /// Whether apply() changes frames: there is a file, or the truth of the source is of another
  /// body.
  bool applies() const { return isGiven() || has_body_; }
  const std::filesystem::path& file() const { return file_; }
  /// Tables beside images are of the raw left camera, which was turned by this rotation.
  void rectify(const Eigen::Matrix3d& R_rectified_raw);
  /// Sets the truth of the frame; frames without a true pose at their time have none. Poses are
  /// seen from the first one of the file.
  void apply(Frame& frame) const;
  /// Why the frame cannot have a true pose, nor any near it: the clocks differ. Else empty.
  std::string clockProblem(const Frame& frame) const;
  /// That the table beside the images has positions alone, and of which point. Else empty.
  std::string pointProblem() const;

 private:
  std::filesystem::path file_;
  evaluation::Trajectory poses_;
  Eigen::Isometry3d T_body_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_body_raw_;  ///< of a table beside the images
  std::int64_t offset_ns_ = 0;
  std::int64_t longest_gap_ns_ = 0;
  bool nearest_ = false;
  bool has_body_ = false;  ///< by evaluation.body
  bool is_point_ = false;  ///< a table beside the images has positions alone
};

/// Raw images (extra RawRigSource) are rectified, then all are cropped and scaled as configured.
class RectifiedSource : private host::SourceStage {
 public:
  explicit RectifiedSource(std::unique_ptr<host::Instance> instance,
                           const config::RectificationSettings& settings = {},
                           config::ImageSettings images = {})
      : SourceStage(std::move(instance)), settings_(settings), images_(std::move(images)) {}

  using SourceStage::instance;
  using SourceStage::resetChecks;
  using SourceStage::startAt;

  /// Describes the cameras and images that the stages get. Fails if raw images cannot be rectified,
  /// or images cannot be cropped as configured.
  Status info(SourceInfo& info);
  Status next(Frame& frame);
  /// From now on next() fails after an error among these findings, unless `on_findings: continue`.
  void judgeBy(Findings& findings) { findings_ = &findings; }
  /// The frames get their truth from here; before info().
  void setTruth(TruePath truth) { truth_ = std::move(truth); }
  /// The raw cameras, after info(); none where the source gives rectified images.
  const RawRig& rawRig() const { return raw_; }
  /// Whether the source does not know its number of frames (a live source); after info().
  bool isEndless() const { return is_endless_; }
  /// How the images are rectified, as text for the user; empty if they are not. After info().
  const std::string& text() const { return text_; }
  /// How the images are cropped and scaled, likewise; empty for whole images. After info().
  std::string cutText() const { return cut_.text(); }
  /// What to look at in the calibration (camera_check.hpp). After info().
  std::vector<std::string> doubts() const;

 private:
  Status prepare(CameraRig& rig);
  Status prepareCut(CameraRig& rig);
  void change(Frame& frame) const;
  void addTruth(Frame& frame);

  config::RectificationSettings settings_;
  config::ImageSettings images_;
  RawRig raw_;
  CameraRig given_;  ///< the rig of the source
  CameraRig rig_;    ///< the rig that the stages get
  std::string text_;
  std::vector<PixelMap> maps_;  ///< one per camera; none: images are not rectified
  Alternation alternation_;
  ImageMask mask_;
  ImageCut cut_;
  std::vector<std::string> depth_arrays_;  ///< sensors that have a value for each pixel
  TruePath truth_;
  Findings* findings_ = nullptr;
  bool is_endless_ = false;
  bool checked_truth_ = false;  ///< its clock
  bool left_only_ = false;      ///< the stages get only the left image of a raw pair
};

}  // namespace tolman::engine
