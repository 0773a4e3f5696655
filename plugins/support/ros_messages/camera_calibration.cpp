// SPDX-License-Identifier: BSD-3-Clause
#include "camera_calibration.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace tolman::ros_messages {
namespace {

Eigen::Matrix3d rotationOf(const CameraInfoMessage& info) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(info.R.data());
}

bool isRotation(const Eigen::Matrix3d& R) {
  // 1e-3: digits that files print.
  return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && R.determinant() > 0;
}

bool hasP(const CameraInfoMessage& info) { return info.P[0] > 0 && info.P[5] > 0; }

Pinhole pinholeOfP(const CameraInfoMessage& info) {
  return {info.P[0], info.P[5], info.P[2], info.P[6]};
}

Pinhole rectifiedPinhole(const CameraInfoMessage& info) {
  return hasP(info) ? pinholeOfP(info) : Pinhole{info.K[0], info.K[4], info.K[2], info.K[5]};
}

Status checkSize(const CameraInfoMessage& info, int width, int height) {
  if (static_cast<std::int64_t>(info.width) == width &&
      static_cast<std::int64_t>(info.height) == height) {
    return Status::ok();
  }
  return Status::invalidInput("is of " + std::to_string(info.width) + "x" +
                              std::to_string(info.height) + " px, and the images have " +
                              std::to_string(width) + "x" + std::to_string(height) +
                              "; give fx of rectified images, or record the right one");
}

Status checkPinhole(const Pinhole& K, int width, int height) {
  const bool sound = K.fx > 0 && K.fy > 0 && K.cx > 0 && K.cx < width && K.cy > 0 && K.cy < height;
  if (sound) return Status::ok();
  return Status::invalidInput(
      "has no focal length, or a principal point outside of the image: the camera was not "
      "calibrated; give fx of rectified images");
}

std::string shortText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.7g", value + 0.0);  // 0, not -0
  return text.data();
}

/// The failure of one camera, with the name of its topic.
Status named(const std::string& name, const Status& status) {
  if (status.isOk() || name.empty()) return status;
  return {status.code(), name + ": " + status.message()};
}

/// The distance in P of the right camera, whose fourth number is -fx times it.
Result<double> baselineOf(const CameraInfos& infos) {
  const CameraInfoMessage& right = *infos.right;
  if (!hasP(right)) {
    return Status::invalidInput(
        "has no P, so the baseline is not known; record the CameraInfo of a calibrated pair, give "
        "fx and baseline, or set mono: true");
  }
  const double baseline = -right.P[3] / right.P[0];
  if (baseline > 1e-3 && baseline < 5) return baseline;  // m; chosen, not tuned
  const std::string found = "has P[3] = " + shortText(right.P[3]) +
                            " and fx = " + shortText(right.P[0]) + ", a baseline of " +
                            shortText(baseline) + " m";
  if (baseline < 0 || (baseline == 0 && infos.left.P[3] < 0)) {
    return Status::invalidInput(found + ": that of a left camera; exchange left and right");
  }
  if (baseline == 0) {
    return Status::invalidInput(found +
                                ": that of a single camera; calibrate the two as a pair, give fx "
                                "and baseline, or set mono: true");
  }
  return Status::invalidInput(found +
                              "; it must be 1 mm to 5 m: P[3] is -fx times the baseline in metres, "
                              "not in mm or cm; correct it, or give fx and baseline");
}

Status setModel(const CameraInfoMessage& info, RawCamera& camera) {
  const auto zero = [](double coefficient) { return coefficient == 0; };
  const std::vector<double>& D = info.D;
  if (std::all_of(D.begin(), D.end(), zero)) return Status::ok();
  const bool radial = info.model == "plumb_bob" || info.model == "rational_polynomial";
  const bool fisheye = info.model == "equidistant" || info.model == "fisheye";
  const bool fits =
      (radial && (D.size() == 4 || D.size() == 5 || D.size() == 8)) || (fisheye && D.size() == 4);
  if (!fits) {
    return Status::unsupported("has the model '" + info.model.substr(0, 40) + "' with " +
                               std::to_string(D.size()) +
                               " coefficients; known are plumb_bob (4, 5), rational_polynomial (8) "
                               "and equidistant (4)");
  }
  camera.model = radial ? LensModel::RadialTangential : LensModel::Equidistant;
  for (std::size_t i = 0; i < D.size(); ++i) camera.distortion[static_cast<int>(i)] = D[i];
  return Status::ok();
}

Result<RawCamera> rawCamera(const CameraInfoMessage& info, int width, int height) {
  RawCamera camera;
  camera.width = width;
  camera.height = height;
  camera.pinhole = {info.K[0], info.K[4], info.K[2], info.K[5]};
  Status status = checkSize(info, width, height);
  if (status.isOk()) status = checkPinhole(camera.pinhole, width, height);
  if (status.isOk()) status = setModel(info, camera);
  if (!status.isOk()) return status;
  const Eigen::Matrix3d R = rotationOf(info);
  camera.R_rectified_camera = isRotation(R) ? R : Eigen::Matrix3d::Identity();
  // The reference is the rectified left camera.
  camera.T_reference_camera.linear() = camera.R_rectified_camera;
  return camera;
}

/// Disparities are only those of depths if both cameras have one focal length and centre.
Status checkRight(const CameraInfoMessage& right, const CameraRig& rig) {
  constexpr double kSame = 1e-3;  // px; digits that are recorded
  if (Status status = checkSize(right, rig.width, rig.height); !status.isOk()) return status;
  const Pinhole p = rectifiedPinhole(right);
  const Pinhole& q = rig.pinhole;
  const Eigen::Vector4d apart(p.fx - q.fx, p.fy - q.fy, p.cx - q.cx, p.cy - q.cy);
  if (apart.isZero(kSame)) return Status::ok();
  return Status::invalidInput(
      "the two rectified cameras have different focal lengths or centres (P of the right one, by " +
      std::to_string(apart.cwiseAbs().maxCoeff()) +
      " px); calibrate them as a pair with zero disparity at infinity");
}

}  // namespace

bool isRectified(const std::string& topic, const CameraInfos& infos) {
  const auto plain = [](const CameraInfoMessage& info) {
    const auto zero = [](double coefficient) { return coefficient == 0; };
    const Eigen::Matrix3d R = rotationOf(info);
    const bool turned = isRotation(R) && (R - Eigen::Matrix3d::Identity()).norm() > 1e-9;
    return std::all_of(info.D.begin(), info.D.end(), zero) && !turned;
  };
  if (topic.find("rect") != std::string::npos) return true;
  return plain(infos.left) && (!infos.right || plain(*infos.right));
}

Result<CameraRig> rectifiedRig(const CameraInfos& infos, int width, int height) {
  const CameraInfoMessage& left = infos.left;
  CameraRig rig;
  rig.width = width;
  rig.height = height;
  rig.calibrated = true;
  rig.pinhole = rectifiedPinhole(left);
  Status status = checkSize(left, width, height);
  if (status.isOk()) status = checkPinhole(rig.pinhole, width, height);
  if (!status.isOk()) return named(infos.left_name, status);
  if (!infos.right) return rig;
  status = checkRight(*infos.right, rig);
  if (!status.isOk()) return named(infos.right_name, status);
  const Result<double> baseline = baselineOf(infos);
  if (!baseline.isOk()) return named(infos.right_name, baseline.status());
  rig.baseline = baseline.value();
  return rig;
}

Result<RawRig> rawRig(const CameraInfos& infos, int width, int height) {
  RawRig rig;
  const Result<RawCamera> left = rawCamera(infos.left, width, height);
  if (!left.isOk()) return named(infos.left_name, left.status());
  rig.cameras.push_back(left.value());
  if (!infos.right) {
    rig.cameras.front().T_reference_camera.setIdentity();
    rig.cameras.front().R_rectified_camera.setIdentity();
    return rig;
  }
  Result<RawCamera> right = rawCamera(*infos.right, width, height);
  if (!right.isOk()) return named(infos.right_name, right.status());
  Result<CameraRig> rectified = rectifiedRig(infos, width, height);
  if (!rectified.isOk()) return rectified.status();
  right.value().T_reference_camera.translation().x() = rectified.value().baseline;
  rig.cameras.push_back(right.value());
  rig.rectified = rectified.value();
  rig.has_rectified = true;
  return rig;
}

}  // namespace tolman::ros_messages
