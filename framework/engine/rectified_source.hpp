// SPDX-License-Identifier: BSD-3-Clause
// The source with rectified images: raw images (extra RawRigSource) are rectified, then all are
// cropped and scaled as configured.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "engine/findings.hpp"
#include "engine/image_mask.hpp"
#include "engine/pixel_map.hpp"
#include "engine/true_path.hpp"
#include "host/stages.hpp"

namespace tolman::engine {

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
  /// What the images of a camera whose projector blinks need, once; empty for others.
  std::optional<Finding> alternation();

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
  bool alternates_ = false;
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
