// SPDX-License-Identifier: BSD-3-Clause
#include "publishers.hpp"

#include <geometry_msgs/PoseStamped.h>
#include <nav_msgs/Path.h>
#include <tf2_msgs/TFMessage.h>
#include <visualization_msgs/MarkerArray.h>

namespace tolman::ros1_publisher {
namespace {

std_msgs::Header headerOf(std::int64_t stamp_ns, const std::string& frame) {
  std_msgs::Header header;
  header.stamp.fromNSec(static_cast<std::uint64_t>(stamp_ns));
  header.frame_id = frame;
  return header;
}

geometry_msgs::Point messageOf(const RosPoint& point) {
  geometry_msgs::Point message;
  message.x = point.x;
  message.y = point.y;
  message.z = point.z;
  return message;
}

geometry_msgs::Pose messageOf(const RosPose& pose) {
  geometry_msgs::Pose message;
  message.position = messageOf(pose.position);
  message.orientation.x = pose.qx;
  message.orientation.y = pose.qy;
  message.orientation.z = pose.qz;
  message.orientation.w = pose.qw;
  return message;
}

visualization_msgs::Marker markerOf(const std_msgs::Header& header, const char* name, int type,
                                    double width, const std::vector<RosPoint>& points) {
  visualization_msgs::Marker marker;
  marker.header = header;
  marker.ns = name;
  marker.type = type;
  marker.action = visualization_msgs::Marker::ADD;
  marker.pose.orientation.w = 1;
  marker.scale.x = marker.scale.y = width;
  marker.color.a = 1;
  for (const RosPoint& point : points) marker.points.push_back(messageOf(point));
  return marker;
}

}  // namespace

Publishers::Publishers(ros::NodeHandle& node, const std::string& prefix,
                       const std::string& map_frame, const std::string& camera_frame, bool tf)
    : map_frame_(map_frame), camera_frame_(camera_frame), has_tf_(tf) {
  pose_ = node.advertise<geometry_msgs::PoseStamped>(prefix + "/pose", 10);
  path_ = node.advertise<nav_msgs::Path>(prefix + "/path", 1, true);
  map_ = node.advertise<visualization_msgs::MarkerArray>(prefix + "/map", 1, true);
  if (tf) tf_ = node.advertise<tf2_msgs::TFMessage>("/tf", 10);
}

void Publishers::publishPose(std::int64_t stamp_ns, const RosPose& robot, const RosPose& camera) {
  geometry_msgs::PoseStamped pose;
  pose.header = headerOf(stamp_ns, map_frame_);
  pose.pose = messageOf(robot);
  pose_.publish(pose);
  if (!has_tf_) return;
  geometry_msgs::TransformStamped transform;
  transform.header = pose.header;
  transform.child_frame_id = camera_frame_;
  transform.transform.translation.x = camera.position.x;
  transform.transform.translation.y = camera.position.y;
  transform.transform.translation.z = camera.position.z;
  transform.transform.rotation = messageOf(camera).orientation;
  tf2_msgs::TFMessage transforms;
  transforms.transforms.push_back(transform);
  tf_.publish(transforms);
}

void Publishers::publishMap(std::int64_t stamp_ns, const MapShapes& shapes) {
  using visualization_msgs::Marker;
  const std_msgs::Header header = headerOf(stamp_ns, map_frame_);
  nav_msgs::Path path;
  path.header = header;
  for (const RosPose& place : shapes.path) {
    geometry_msgs::PoseStamped pose;
    pose.header = header;
    pose.pose = messageOf(place);
    path.poses.push_back(pose);
  }
  path_.publish(path);
  Marker places = markerOf(header, "experiences", Marker::POINTS, 0.2, shapes.experiences);
  Marker odometry = markerOf(header, "odometry", Marker::LINE_LIST, 0.05, shapes.odometry);
  Marker loops = markerOf(header, "loops", Marker::LINE_LIST, 0.08, shapes.loops);
  places.color.b = 0.9F;
  odometry.color.r = odometry.color.g = odometry.color.b = 0.5F;
  loops.color.r = 0.9F;
  visualization_msgs::MarkerArray markers;
  markers.markers = {places, odometry, loops};
  map_.publish(markers);
}

}  // namespace tolman::ros1_publisher
