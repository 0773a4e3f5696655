// SPDX-License-Identifier: BSD-3-Clause
#include "bag_writer.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <opencv2/imgcodecs.hpp>
#include <span>

#include "map_shapes.hpp"
#include "tolman/geometry.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::bag_writer {
namespace {

using ros_map::FieldWriter;

constexpr const char* kOptical = "camera_optical";

/// P[3] of a right camera, -fx * baseline, so that a division gives the baseline to the last bit.
double offsetOf(double fx, double baseline) {
  const double product = fx * baseline;
  for (const double near : {product, std::nextafter(product, 0), std::nextafter(product, 1e9)}) {
    if (near / fx == baseline) return -near;
  }
  return -product;
}

std::string_view textOf(const std::vector<std::uint8_t>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

ros_map::RosPose poseOf(const PlanarPose& pose) {
  return {{pose.x, pose.y, 0}, 0, 0, std::sin(pose.theta / 2), std::cos(pose.theta / 2)};
}

const NamedArray* sensorOf(const Frame& frame, const std::string& name) {
  const auto found = std::ranges::find(frame.sensors, name, &NamedArray::name);
  return found == frame.sensors.end() ? nullptr : &*found;
}

}  // namespace

Status BagWriter::configure(const Context& context) {
  const Result<Parameters> bound = bindParameters<Parameters>(context.parameters);
  if (!bound.isOk()) return bound.status();
  parameters_ = bound.value();
  const std::string& path = parameters_.path;
  if (!path.ends_with(".mcap") && !path.ends_with(".bag")) {
    return Status::invalidParameter(path + ": is no bag; name it NAME.mcap (ROS 2) or NAME.bag");
  }
  std::error_code ignored;
  if (!parameters_.replace && std::filesystem::exists(path, ignored)) {
    return Status::invalidParameter(path + ": exists already; choose another path, or set replace");
  }
  return reset();
}

Status BagWriter::reset() {
  bag_.reset();
  frames_ = {"map", "odom", "camera"};
  measured_ = {};
  return Status::ok();
}

Status BagWriter::begin(const RunInfo& run) {
  std::ofstream file(parameters_.path, std::ios::binary | std::ios::trunc);
  if (!file) return Status::failed(parameters_.path + ": cannot be written; check the folder");
  const bool ros2 = parameters_.path.ends_with(".mcap");
  bag_ = ros2 ? newMcap(std::move(file)) : newRos1Bag(std::move(file));
  rig_ = run.source.rig;
  const auto depth = std::ranges::find(run.arrays, ArrayKind::DepthImage, &ArrayInfo::kind);
  depth_ = depth == run.arrays.end() ? "" : depth->name;
  return Status::ok();
}

Status BagWriter::observe(const Snapshot& snapshot) {
  if (bag_ == nullptr) return Status::failed("begin() was not called");
  const Frame& frame = *snapshot.frame;
  stamp_ns_ = frame.stamp_ns;
  if (!frame.left.empty()) writeImages(frame);
  if (!depth_.empty()) writeDepth(frame);
  if (frame.has_truth) {
    FieldWriter truth(bag_->format());
    ros_map::writePose(truth, stamp_ns_, "world", ros_map::cameraPose(frame.T_world_camera_truth));
    write("/truth", "geometry_msgs/msg/PoseStamped", truth);
  }
  writePoses(snapshot);
  return Status::ok();
}

Status BagWriter::finish(const MapGraph&) {
  if (bag_ == nullptr) return Status::ok();
  const Status status = bag_->close();
  bag_.reset();
  return status.isOk() ? status : Status::failed(parameters_.path + ": " + status.message());
}

void BagWriter::writeImages(const Frame& frame) {
  for (const bool right : {false, true}) {
    const Image& image = right ? frame.right : frame.left;
    if (image.empty()) continue;
    const std::string side = right ? "/right" : "/left";
    if (rig_.calibrated) writeCamera(side, rig_, right ? rig_.baseline : 0);
    std::vector<std::uint8_t> png;
    cv::imencode(".png", asMat(image), png, {cv::IMWRITE_PNG_COMPRESSION, 1});
    FieldWriter message(bag_->format());
    message.header(stamp_ns_, kOptical).text("png").bytes(textOf(png));
    write(side + (rig_.calibrated ? "/image_rect" : "/image_raw") + "/compressed",
          "sensor_msgs/msg/CompressedImage", message);
  }
}

void BagWriter::writeCamera(const std::string& side, const CameraRig& rig, double baseline) {
  const Pinhole& k = rig.pinhole;
  const double offset = baseline > 0 ? offsetOf(k.fx, baseline) : 0;
  FieldWriter message(bag_->format());
  message.header(stamp_ns_, kOptical).count(static_cast<std::size_t>(rig.height));
  message.count(static_cast<std::size_t>(rig.width)).text("plumb_bob").count(5).zeros(5);
  message.numbers(std::array{k.fx, 0.0, k.cx, 0.0, k.fy, k.cy, 0.0, 0.0, 1.0});
  message.numbers(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  message.numbers(std::array{k.fx, 0.0, k.cx, offset, 0.0, k.fy, k.cy, 0.0, 0.0, 0.0, 1.0, 0.0});
  for (int i = 0; i < 6; ++i) message.count(0);  // binning and region of interest
  message.number(std::uint8_t{0});
  write(side + "/camera_info", "sensor_msgs/msg/CameraInfo", message);
}

void BagWriter::writeDepth(const Frame& frame) {
  const NamedArray* depth = sensorOf(frame, depth_);
  if (depth == nullptr || depth->shape.size() != 2) return;
  FieldWriter message(bag_->format());
  message.header(stamp_ns_, kOptical).count(static_cast<std::size_t>(depth->shape[0]));
  message.count(static_cast<std::size_t>(depth->shape[1])).text("32FC1").number(std::uint8_t{0});
  message.count(static_cast<std::size_t>(depth->shape[1]) * sizeof(float));
  message.bytes(
      {reinterpret_cast<const char*>(depth->values.data()), depth->values.size() * sizeof(float)});
  write("/depth/image", "sensor_msgs/msg/Image", message);
}

void BagWriter::writePoses(const Snapshot& snapshot) {
  const NamedArray* motion = sensorOf(*snapshot.frame, "motion.planar");
  const bool is_run = snapshot.motion->frame >= 0;
  if (!is_run && (motion == nullptr || motion->values.size() != 3)) return;
  if (!is_run) {
    measured_ = compose(measured_, {motion->values[0], motion->values[1], motion->values[2]});
    writeOdometry(poseOf(measured_), {});
    return;
  }
  frames_.add(*snapshot.motion);
  writeOdometry(frames_.inOdom().pose, {snapshot.motion->v, 0, 0, 0, 0, snapshot.motion->omega});
  FieldWriter transforms(bag_->format());
  ros_map::writeTransforms(transforms, stamp_ns_, frames_.all(snapshot.map->T_world_camera));
  write("/tf", "tf2_msgs/msg/TFMessage", transforms);
}

void BagWriter::writeOdometry(const ros_map::RosPose& pose, const std::array<double, 6>& twist) {
  FieldWriter odometry(bag_->format());
  ros_map::writeOdometry(odometry, stamp_ns_, {"odom", "camera", pose}, twist);
  write("/odometry", "nav_msgs/msg/Odometry", odometry);
}

void BagWriter::write(const std::string& topic, const char* type, const FieldWriter& message) {
  bag_->write(topic, type, stamp_ns_, message.message());
}

}  // namespace tolman::bag_writer
