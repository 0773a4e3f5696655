// SPDX-License-Identifier: BSD-3-Clause
#include "message_types.hpp"

#include <array>
#include <map>
#include <sstream>
#include <vector>

namespace tolman::bag_writer {
namespace {

using ros_map::Format;

/// Fields by their published definitions; those that differ in ROS 1 are in kRos1.
const std::map<std::string, std::string> kFields = {
    {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
    {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
    {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
    {"sensor_msgs/Image",
     "std_msgs/Header header\nuint32 height\nuint32 width\nstring encoding\nuint8 is_bigendian\n"
     "uint32 step\nuint8[] data\n"},
    {"sensor_msgs/RegionOfInterest",
     "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n"},
    {"sensor_msgs/CameraInfo",
     "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\n"
     "float64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\n"
     "uint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"},
    {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
    {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
    {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
    {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
    {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
    {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
    {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
    {"geometry_msgs/Transform",
     "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
    {"geometry_msgs/TransformStamped",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
    {"nav_msgs/Odometry",
     "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/PoseWithCovariance pose\n"
     "geometry_msgs/TwistWithCovariance twist\n"},
    {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"}};

const std::map<std::string, std::string> kRos1 = {
    {"std_msgs/Header", "uint32 seq\ntime stamp\nstring frame_id\n"},
    {"sensor_msgs/CameraInfo",
     "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\n"
     "float64[] D\nfloat64[9] K\nfloat64[9] R\nfloat64[12] P\nuint32 binning_x\n"
     "uint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"}};

const std::map<std::string, std::string> kSums = {
    {"sensor_msgs/CompressedImage", "8f7a12909da2c9d3332d540a0977563f"},
    {"sensor_msgs/Image", "060021388200f6f0f447d0fcd9c64743"},
    {"sensor_msgs/CameraInfo", "c9a58c1b0b154e0e6da7578cb991d214"},
    {"geometry_msgs/PoseStamped", "d3812c3cbc69362b77dc0b19b345f8f5"},
    {"nav_msgs/Odometry", "cd5e73d190d741a2f92e81eda573aca7"},
    {"tf2_msgs/TFMessage", "94810edda583a504dfda3829e70d7eec"}};

const std::string& fieldsOf(const std::string& type, Format format) {
  const auto other = kRos1.find(type);
  return format == Format::Ros1 && other != kRos1.end() ? other->second : kFields.at(type);
}

}  // namespace

std::string ros1Type(const std::string& type) {
  const std::size_t at = type.find("/msg/");
  return at == std::string::npos ? type : std::string(type).replace(at, 5, "/");
}

std::string sumOf(const std::string& type) { return kSums.at(ros1Type(type)); }

std::string definitionOf(const std::string& type, Format format) {
  std::vector<std::string> types = {ros1Type(type)};
  std::string text;
  for (std::size_t i = 0; i < types.size(); ++i) {  // grows
    const std::string fields = fieldsOf(types[i], format);
    if (i > 0) text += std::string(80, '=') + "\nMSG: " + types[i] + "\n";
    text += fields;
    std::istringstream lines(fields);
    for (std::string field, name; lines >> field >> name;) {
      const std::string part = field.substr(0, field.find('['));
      const bool is_new = std::find(types.begin(), types.end(), part) == types.end();
      if (kFields.contains(part) && is_new) types.push_back(part);
    }
  }
  return text;
}

}  // namespace tolman::bag_writer
