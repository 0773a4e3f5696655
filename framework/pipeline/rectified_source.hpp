// SPDX-License-Identifier: BSD-3-Clause
// The source as the stages see it: raw images (extra RawRigSource) are rectified.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "config/settings.hpp"
#include "host/stages.hpp"
#include "imaging/pixel_map.hpp"

namespace tolman::pipeline {

class RectifiedSource : private host::SourceStage {
 public:
  explicit RectifiedSource(std::unique_ptr<host::Instance> instance,
                           const config::RectificationSettings& settings = {})
      : SourceStage(std::move(instance)), settings_(settings) {}

  using SourceStage::expect;
  using SourceStage::inspect;
  using SourceStage::instance;
  using SourceStage::startAt;

  /// The cameras and images after rectification. Fails where raw images cannot be rectified.
  Status info(SourceInfo& info);
  Status next(Frame& frame);
  /// The raw cameras, after info(); none where the source gives rectified images.
  const RawRig& rawRig() const { return raw_; }
  /// What is done to the images, after info(); empty for nothing.
  const std::string& text() const { return text_; }
  /// What rectifying the last frame took; 0 where nothing is done.
  std::int64_t rectifyingNs() const { return rectifying_ns_; }

 private:
  Status prepare(CameraRig& rig);

  config::RectificationSettings settings_;
  RawRig raw_;
  CameraRig rig_;  ///< rectified
  std::string text_;
  std::vector<imaging::PixelMap> maps_;  ///< one a camera; none: images stay as they are
  std::int64_t rectifying_ns_ = 0;
  bool left_alone_ = false;  ///< raw pairs are no pairs for the stages
};

}  // namespace tolman::pipeline
