// SPDX-License-Identifier: BSD-3-Clause
// Source `ros1`: images of one camera or a pair, live from topics of ROS 1.
#pragma once

#include <memory>

#include "camera_rigs.hpp"
#include "live_camera.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"

namespace tolman::ros1 {

class Ros1Source final : public Source, public RawRigSource, public LiveSource {
 public:
  using Parameters = Ros1Parameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status info(SourceInfo& info) override;
  Status rawRig(RawRig& rig) override;
  Status next(Frame& frame) override;

 private:
  Status prepare(const Context& context);
  Status makeRigs();
  Status give(const ArrivedPair& pair, Frame& frame);
  /// Why there is no image; empty if there is one.
  std::string convert(const std::string& topic, const std::string& type, const Arrived& arrived,
                      Image& image);
  void tellLeftOut();

  Parameters parameters_;
  source_parameters::UsedBits used_bits_;
  Logger* log_ = nullptr;
  FindingCollector* findings_ = nullptr;
  std::unique_ptr<LiveCamera> camera_;
  ros_messages::ImageSize size_;
  ros_messages::CameraRigs rigs_;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_image_ = 0;  ///< number of the next image of the topic
  std::int64_t next_frame_ = 0;
  std::int64_t last_stamp_ns_ = 0;
  bool told_left_out_ = false;
};

}  // namespace tolman::ros1
