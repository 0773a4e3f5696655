// SPDX-License-Identifier: BSD-3-Clause
// A source of live images: of one camera or a pair, with depth and measurements beside them.
#pragma once

#include <memory>

#include "camera_rigs.hpp"
#include "live_camera.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"

namespace tolman::live_images {

/// A plugin derives from it, and begins in configure().
class LiveImageSource : public Source,
                        public RawRigSource,
                        public LiveSource,
                        public ArrayDescriptions {
 public:
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status rawRig(RawRig& rig) override;
  Status next(Frame& frame) override;
  Status describe(std::vector<ArrayInfo>& arrays) const override;

 protected:
  /// `transport`: the connection, or why there is none.
  Status begin(Result<std::unique_ptr<Transport>> transport, const LiveParameters& parameters,
               const Context& context);

 private:
  Status prepare(std::unique_ptr<Transport> transport, const Context& context);
  Status makeRigs();
  Status give(const ImageSet& set, Frame& frame);
  /// Why the images cannot be used; empty if they can.
  std::string convert(const ImageSet& set, Frame& frame);
  std::string defectOf(const LiveStream& stream, const Arrived& arrived, const Status& status);
  bool hasPair() const { return !camera_->topics().right.empty(); }
  void reportDropped();

  LiveParameters parameters_;
  source_parameters::UsedBits used_bits_;
  FindingCollector* findings_ = nullptr;
  std::unique_ptr<LiveCamera> camera_;
  ros_messages::ImageSize size_;
  ros_messages::ImageSize depth_size_;
  ros_messages::CameraRigs rigs_;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_image_ = 0;  ///< number of the next image of the topic
  std::int64_t next_frame_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  std::size_t reported_left_out_ = 0;
  std::size_t reported_lost_ = 0;
};

}  // namespace tolman::live_images
