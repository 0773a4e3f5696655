// SPDX-License-Identifier: BSD-3-Clause
// Observer `bag_writer`: the images of a run, their calibration, truth and poses as a bag.
#pragma once

#include <memory>
#include <string>

#include "bag_output.hpp"
#include "map_messages.hpp"
#include "tolman/parameters.hpp"
#include "tolman/roles.hpp"

namespace tolman::bag_writer {

struct BagWriterParameters {
  std::string path;
  bool replace = false;

  static constexpr auto declaration() {
    using P = BagWriterParameters;
    return parameters(parameter("path", &P::path)
                          .path()
                          .required()
                          .doc("File to write: NAME.mcap (ROS 2) or NAME.bag (ROS 1)."),
                      parameter("replace", &P::replace)
                          .doc("Replace a file that exists; otherwise it is refused."));
  }
};

class BagWriter final : public Observer {
 public:
  using Parameters = BagWriterParameters;

  Status configure(const Context& context) override;
  Status reset() override;
  Status begin(const RunInfo& run) override;
  Status observe(const Snapshot& snapshot) override;
  Status finish(const MapGraph& graph) override;

 private:
  void writeImages(const Frame& frame);
  void writeCamera(const std::string& side, const CameraRig& rig, double baseline);
  void writeDepth(const Frame& frame);
  /// Poses of the run, or of a recording without one what it measured.
  void writePoses(const Snapshot& snapshot);
  void writeOdometry(const ros_map::RosPose& pose, const std::array<double, 6>& twist);
  void write(const std::string& topic, const char* type, const ros_map::FieldWriter& message);

  Parameters parameters_;
  std::unique_ptr<BagOutput> bag_;
  CameraRig rig_;
  std::string depth_;  ///< name of the sensor; empty if there is none
  std::int64_t stamp_ns_ = 0;
  ros_map::RunFrames frames_{"map", "odom", "camera"};
  PlanarPose measured_;
};

}  // namespace tolman::bag_writer
