// SPDX-License-Identifier: BSD-3-Clause
// Source `ros_bag`: images, calibration and other sensors of a bag of ROS 1 or 2, without ROS.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bag.hpp"
#include "bag_parameters.hpp"
#include "camera_rigs.hpp"
#include "frame_table.hpp"
#include "side_measurements.hpp"
#include "tolman/extras.hpp"
#include "tolman/roles.hpp"
#include "topic_choice.hpp"
#include "used_bits.hpp"

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
  /// Lists the topics of the bag and its problems.
  Status inspect(std::vector<Finding>& findings);

 private:
  Status prepare(const Context& context);
  Status judgeProblems(Logger& log) const;
  std::vector<std::string> messageProblems() const;
  std::vector<std::string> imageDoubts() const;
  std::vector<std::string> depthDoubts() const;
  Status judgeTopics(Logger& log) const;
  /// The size of the first image whose header is sound.
  Status findSize();
  Status makeRigs();
  Status makeSequence(Logger& log);
  /// Loads the other sensors, and refuses what is damaged or was measured at other times than the
  /// run's.
  Status loadSensors(Logger& log);
  Status judgeOdometry(Logger& log);
  std::int64_t imageStampNs(std::int64_t source_index) const;
  Status readImage(const BagTopic& topic, std::size_t index, Image& image);
  Status readImages(const FrameRow& row, Frame& frame);
  void tellUsedBits();
  Status addDepth(const FrameRow& row, Frame& frame);
  void inspectTopics(std::vector<Finding>& findings) const;
  std::string roleOf(const BagTopic& topic) const;

  Parameters parameters_;
  std::optional<Bag> bag_;
  ChosenTopics chosen_;
  FrameTable table_;
  SideMeasurements side_;
  std::vector<std::string> odometry_problems_;  ///< with the topic
  ImageSize size_;
  ImageSize depth_size_;
  CameraRigs rigs_;
  FrameSequence sequence_;
  source_parameters::UsedBits used_bits_;
  Logger* log_ = nullptr;  ///< of configure()
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_frame_ = 0;
};

}  // namespace tolman::ros_bag
