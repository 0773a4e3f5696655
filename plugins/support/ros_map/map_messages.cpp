// SPDX-License-Identifier: BSD-3-Clause
#include "map_messages.hpp"

#include "map_shapes.hpp"

namespace tolman::ros_map {
namespace {

void write(FieldWriter& to, const RosPoint& point) {
  to.number(point.x).number(point.y).number(point.z);
}

void write(FieldWriter& to, const RosPose& pose) {
  write(to, pose.position);
  to.number(pose.qx).number(pose.qy).number(pose.qz).number(pose.qw);
}

struct Style {
  const char* name;
  std::int32_t type;
  double width;  ///< m
  std::array<float, 3> colour;
};

void writeMarker(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
                 const Style& style, const std::vector<RosPoint>& points) {
  to.header(stamp_ns, frame).text(style.name);
  to.number(std::int32_t{0}).number(style.type).number(std::int32_t{0});  // id, type, add
  write(to, RosPose{});
  to.number(style.width).number(style.width).number(0.0);
  for (const float channel : style.colour) to.number(channel);
  to.number(1.0F).time(0).number(std::uint8_t{0});  // opaque, for ever, frame not locked
  to.count(points.size());
  for (const RosPoint& point : points) write(to, point);
  to.count(0);  // colours of points
  if (to.format() == Format::Ros2) {
    to.text("").header(0, "").text("").count(0).count(0);  // texture
  }
  to.text("").text("");                                   // text and mesh
  if (to.format() == Format::Ros2) to.text("").count(0);  // file of the mesh
  to.number(std::uint8_t{0});
}

}  // namespace

Status checkPrefix(const std::string& prefix) {
  constexpr const char* kLegal = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_/";
  const bool is_legal = prefix.starts_with('/') && !prefix.ends_with('/') &&
                        prefix.find_first_not_of(kLegal) == std::string::npos;
  return is_legal
             ? Status::ok()
             : Status::invalidParameter("'" + prefix + "' is no prefix of topics; write /tolman");
}

RosTransform RunFrames::inOdom() const { return {odom_, camera_, robotPose(T_odom_camera_)}; }

std::vector<RosTransform> RunFrames::all(const Eigen::Isometry3d& T_world_camera) const {
  return {{map_, odom_, robotPose(T_world_camera * T_odom_camera_.inverse())},
          inOdom(),
          {camera_, camera_ + "_optical", cameraPose(Eigen::Isometry3d::Identity())}};
}

void writeOdometry(FieldWriter& to, std::int64_t stamp_ns, const RosTransform& pose,
                   const std::array<double, 6>& twist) {
  constexpr std::size_t kCovariance = 36;
  to.header(stamp_ns, pose.frame).text(pose.child);
  write(to, pose.pose);
  to.zeros(kCovariance).numbers(twist).zeros(kCovariance);
}

void writeTransforms(FieldWriter& to, std::int64_t stamp_ns,
                     const std::vector<RosTransform>& transforms) {
  to.count(transforms.size());
  for (const RosTransform& transform : transforms) {
    to.header(stamp_ns, transform.frame).text(transform.child);
    write(to, transform.pose);
  }
}

void writePose(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
               const RosPose& pose) {
  to.header(stamp_ns, frame);
  write(to, pose);
}

void writePath(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
               const std::vector<RosPose>& path) {
  to.header(stamp_ns, frame).count(path.size());
  for (const RosPose& pose : path) writePose(to, stamp_ns, frame, pose);
}

void writeMarkers(FieldWriter& to, std::int64_t stamp_ns, const std::string& frame,
                  const MapShapes& shapes) {
  constexpr std::int32_t kLineList = 5;
  constexpr std::int32_t kPoints = 8;
  to.count(3);
  writeMarker(to, stamp_ns, frame, {"experiences", kPoints, 0.2, {0, 0, 0.9F}}, shapes.experiences);
  writeMarker(to, stamp_ns, frame, {"odometry", kLineList, 0.05, {0.5F, 0.5F, 0.5F}},
              shapes.odometry);
  writeMarker(to, stamp_ns, frame, {"loops", kLineList, 0.08, {0.9F, 0, 0}}, shapes.loops);
}

void writeDiagnosis(FieldWriter& to, std::int64_t stamp_ns, const Diagnosis& diagnosis) {
  to.header(stamp_ns, "").count(1).number(diagnosis.level).text(diagnosis.name);
  to.text(diagnosis.message).text("").count(diagnosis.values.size());
  for (const auto& [key, value] : diagnosis.values) to.text(key).text(value);
}

}  // namespace tolman::ros_map
