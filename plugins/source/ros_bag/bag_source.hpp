// SPDX-License-Identifier: BSD-3-Clause
// Source `ros_bag`: images, calibration and other sensors of a bag of ROS 1 or 2, without ROS.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "bag.hpp"
#include "bag_parameters.hpp"
#include "camera_rigs.hpp"
#include "frame_table.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "topic_choice.hpp"
#include "true_poses.hpp"
#include "used_bits.hpp"
#include "video_pictures.hpp"

namespace tolman::ros_bag {

class BagSource final : public Source, public ArrayDescriptions, public RawRigSource {
 public:
  using Parameters = BagParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status rawRig(RawRig& rig) override;
  Status next(Frame& frame) override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 private:
  Status prepare(const Context& context);
  /// What was found about the messages of the chosen topics. A failure if one has none.
  Status reportTopics() const;
  /// Of the first image that is not damaged.
  Status findSize();
  Status makeRigs();
  Status makeSequence();
  std::int64_t imageStampNs(std::int64_t source_index) const;
  Result<Image> readImage(const BagTopic& topic, std::size_t index);
  /// The picture of a packet of video.
  Result<Image> decode(const BagTopic& topic, std::size_t index);
  Result<NamedArray> readDepth(const FrameRow& row);
  std::string roleOf(const BagTopic& topic) const;

  Parameters parameters_;
  std::optional<Bag> bag_;
  ChosenTopics chosen_;
  FrameTable table_;
  SideMeasurements side_;
  TruePoses truth_;
  std::map<const BagTopic*, std::unique_ptr<coded_video::PacketDecoder>> decoders_;
  ImageSize size_;
  ImageSize depth_size_;
  CameraRigs rigs_;
  FrameSequence sequence_;
  source_parameters::UsedBits used_bits_;
  FindingCollector* findings_ = nullptr;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_frame_ = 0;
};

}  // namespace tolman::ros_bag
