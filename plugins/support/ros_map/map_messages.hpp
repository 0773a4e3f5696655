// SPDX-License-Identifier: BSD-3-Clause
// Messages of poses, maps and states, by their published definitions (Humble; Noetic).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "field_writer.hpp"
#include "ros_geometry.hpp"
#include "tolman/geometry.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::ros_map {

/// A pose of `child` in `frame`.
struct RosTransform {
  std::string frame;
  std::string child;
  RosPose pose;
};

/// InvalidParameter for what cannot be the first part of topics: "/tolman" can.
Status checkPrefix(const std::string& prefix);

/// The frames of a run as REP 105 has them: the odometry never jumps in `odom`, which moves in
/// `map` where loops close. The camera has axes of ROS; with "_optical" behind its name, its own.
class RunFrames {
 public:
  RunFrames(std::string map, std::string odom, std::string camera)
      : map_(std::move(map)), odom_(std::move(odom)), camera_(std::move(camera)) {}

  /// The camera has moved on.
  void add(const Motion& motion) {
    T_odom_camera_ = normalised(T_odom_camera_ * motion.T_previous_current);
  }
  RosTransform inOdom() const;
  /// Map to odom, odom to camera, camera to its optical axes.
  std::vector<RosTransform> all(const Eigen::Isometry3d& T_world_camera) const;

 private:
  std::string map_, odom_, camera_;
  Eigen::Isometry3d T_odom_camera_ = Eigen::Isometry3d::Identity();
};

/// nav_msgs/Odometry; `twist`: m/s and rad/s in the axes of the child. Covariances are unknown.
void writeOdometry(FieldWriter& to, std::int64_t stamp_ns, const RosTransform& pose,
                   const std::array<double, 6>& twist);
/// tf2_msgs/TFMessage.
void writeTransforms(FieldWriter& to, std::int64_t stamp_ns,
                     const std::vector<RosTransform>& transforms);
/// geometry_msgs/PoseStamped.
void writePose(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
               const RosPose& pose);
/// nav_msgs/Path.
void writePath(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
               const std::vector<RosPose>& path);
/// visualization_msgs/MarkerArray: experiences and links, of which rejected ones are left out.
void writeMarkers(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
                  const MapShapes& shapes);

/// diagnostic_msgs/DiagnosticArray with one status.
struct Diagnosis {
  std::uint8_t level = 0;  ///< 0: sound, 1: warning, 2: error
  std::string name;
  std::string message;
  std::vector<std::pair<std::string, std::string>> values;
};
void writeDiagnosis(FieldWriter& to, std::int64_t stamp_ns, const Diagnosis& diagnosis);

}  // namespace tolman::ros_map
