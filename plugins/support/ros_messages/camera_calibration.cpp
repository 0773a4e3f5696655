// SPDX-License-Identifier: BSD-3-Clause
#include "camera_calibration.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "given_pinhole.hpp"

namespace tolman::ros_messages {

namespace {

using source_parameters::Projection;

bool isRotation(const Eigen::Matrix3d& R) {
  // 1e-3: digits that files print.
  return (R * R.transpose() - Eigen::Matrix3d::Identity()).norm() < 1e-3 && R.determinant() > 0;
}

/// Whether K or P is that of a camera without skew: other numbers would be ignored. The tolerance
/// is for products of matrices.
Status checkForm(const char* name, const Eigen::Matrix3d& matrix) {
  constexpr double kZero = 1e-6;
  const double zero = kZero * std::abs(matrix(0, 0));
  const bool sound = std::abs(matrix(0, 1)) <= zero && std::abs(matrix(1, 0)) <= zero &&
                     std::abs(matrix(2, 0)) <= kZero && std::abs(matrix(2, 1)) <= kZero &&
                     std::abs(matrix(2, 2) - 1) <= kZero;
  if (sound || matrix(0, 0) <= 0) return Status::ok();  // checkPinhole() tells the latter
  return Status::invalidInput(std::string("has a matrix ") + name +
                              " that is not of the form fx 0 cx, 0 fy cy, 0 0 1; correct it, or "
                              "give pinhole of rectified images");
}

Projection matrixP(const CameraInfoMessage& info) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(info.P.data());
}

}  // namespace

Eigen::Matrix3d rotationOf(const CameraInfoMessage& info) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(info.R.data());
}

bool isTurned(const CameraInfoMessage& info) {
  const Eigen::Matrix3d R = rotationOf(info);
  return !R.isZero(0) && (R - Eigen::Matrix3d::Identity()).norm() > 1e-9;
}

bool hasP(const CameraInfoMessage& info) { return info.P[0] > 0 && info.P[5] > 0; }

Pinhole pinholeOfP(const CameraInfoMessage& info) {
  return source_parameters::pinholeOf(matrixP(info));
}

Eigen::Vector3d offsetOf(const CameraInfoMessage& info) {
  return hasP(info) ? source_parameters::offsetOf(matrixP(info)) : Eigen::Vector3d::Zero().eval();
}

Status checkRotation(const CameraInfoMessage& info) {
  const Eigen::Matrix3d R = rotationOf(info);
  if (R.isZero(0) || isRotation(R)) return Status::ok();
  return Status::invalidInput(
      "has no rotation in R; correct it, calibrate the cameras again, or give pinhole of rectified "
      "images");
}

Status checkForms(const CameraInfoMessage& info) {
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> K(info.K.data());
  const Status status = checkForm("K", K);
  return status.isOk() ? checkForm("P", matrixP(info).leftCols<3>()) : status;
}

Status checkSize(const CameraInfoMessage& info, int width, int height) {
  if (info.is_part) {
    return Status::unsupported(
        "has binning or a region of interest, which are not used; record whole images, or give "
        "pinhole "
        "of these");
  }
  if (static_cast<std::int64_t>(info.width) == width &&
      static_cast<std::int64_t>(info.height) == height) {
    return Status::ok();
  }
  return Status::invalidInput("is of " + std::to_string(info.width) + "x" +
                              std::to_string(info.height) + " px, and the images have " +
                              std::to_string(width) + "x" + std::to_string(height) +
                              "; give pinhole of rectified images, or record the right one");
}

Status checkPinhole(const Pinhole& K, int width, int height) {
  const bool sound = K.fx > 0 && K.fy > 0 && K.cx > 0 && K.cx < width && K.cy > 0 && K.cy < height;
  if (sound) return Status::ok();
  return Status::invalidInput(
      "has no focal length, or a principal point outside of the image: the camera was not "
      "calibrated; give pinhole of rectified images");
}

namespace {

Pinhole rectifiedPinhole(const CameraInfoMessage& info) {
  return hasP(info) ? pinholeOfP(info) : Pinhole{info.K[0], info.K[4], info.K[2], info.K[5]};
}

std::string shortText(double value) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.7g", value + 0.0);  // 0, not -0
  return text.data();
}

double largestDifference(const Pinhole& a, const Pinhole& b) {
  return Eigen::Vector4d(a.fx - b.fx, a.fy - b.fy, a.cx - b.cx, a.cy - b.cy).cwiseAbs().maxCoeff();
}

bool isSame(const Pinhole& a, const Pinhole& b) {
  constexpr double kSame = 1e-3;  // px; digits that are recorded
  return largestDifference(a, b) <= kSame;
}

/// The failure of one camera, with the name of its topic.
Status named(const std::string& name, const Status& status) {
  if (status.isOk() || name.empty()) return status;
  return {status.code(), name + ": " + status.message()};
}

/// The distance of the cameras. The fourth number of P is -fx times it for the right one, and 0
/// for the left one, except in pairs that are not the first of a rig (the colour pair of KITTI).
Result<double> baselineOf(const CameraInfos& infos) {
  const CameraInfoMessage& right = *infos.right;
  if (!hasP(right)) {
    return Status::invalidInput(
        "has no P, so the baseline is not known; record the CameraInfo of a calibrated pair, give "
        "pinhole and baseline, or set mono: true");
  }
  const Eigen::Vector3d t = offsetOf(infos.left) - offsetOf(right);
  const double baseline = t.x();
  const bool aligned = source_parameters::isBeside(t);
  // The sign of P[3] is often wrong; the host decides by the images whether they are exchanged.
  const double distance = std::abs(baseline);
  if (distance > 1e-3 && distance < 5 && aligned) return distance;  // m; chosen, not tuned
  const std::string of_left =
      infos.left.P[3] == 0 ? "" : " (left: " + shortText(infos.left.P[3]) + ")";
  const std::string found = "has P[3] = " + shortText(right.P[3]) + of_left +
                            " and fx = " + shortText(right.P[0]) + ", a baseline of " +
                            shortText(baseline) + " m";
  if (!aligned) {
    return Status::invalidInput("is " + shortText(t.y()) + " m below and " + shortText(t.z()) +
                                " m before the left camera by P[7] and P[11]; calibrate the two as "
                                "a pair, or give pinhole and baseline");
  }
  if (baseline == 0) {
    return Status::invalidInput(
        found +
        ": that of a single camera; calibrate the two as a pair, give pinhole "
        "and baseline, or set mono: true");
  }
  return Status::invalidInput(found +
                              "; it must be 1 mm to 5 m: P[3] is -fx times the baseline in metres, "
                              "not in mm or cm; correct it, or give pinhole and baseline");
}

Result<RawCamera> rawCamera(const CameraInfoMessage& info, int width, int height) {
  RawCamera camera;
  camera.width = width;
  camera.height = height;
  camera.pinhole = {info.K[0], info.K[4], info.K[2], info.K[5]};
  Status status = checkSize(info, width, height);
  if (status.isOk()) status = checkForms(info);
  if (status.isOk()) status = checkRotation(info);
  if (status.isOk()) status = checkPinhole(camera.pinhole, width, height);
  if (status.isOk()) status = source_parameters::setLens(info.model, info.D, camera);
  if (!status.isOk()) return status;
  if (isTurned(info)) camera.R_rectified_camera = rotationOf(info);
  // The reference is the rectified left camera.
  camera.T_reference_camera.linear() = camera.R_rectified_camera;
  return camera;
}

/// Disparities are only those of depths if both cameras have one focal length and centre.
Status checkRight(const CameraInfoMessage& right, const CameraRig& rig) {
  Status status = checkSize(right, rig.width, rig.height);
  if (status.isOk()) status = checkForms(right);
  if (!status.isOk()) return status;
  const Pinhole p = rectifiedPinhole(right);
  if (isSame(p, rig.pinhole)) return Status::ok();
  return Status::invalidInput(
      "the two rectified cameras have different focal lengths or centres (P of the right one, by " +
      std::to_string(largestDifference(p, rig.pinhole)) +
      " px); calibrate them as a pair with zero disparity at infinity");
}

}  // namespace

bool isRectified(const std::string& topic, const CameraInfos& infos) {
  const auto plain = [](const CameraInfoMessage& info) {
    const auto zero = [](double coefficient) { return coefficient == 0; };
    const Pinhole K{info.K[0], info.K[4], info.K[2], info.K[5]};
    return std::all_of(info.D.begin(), info.D.end(), zero) && !isTurned(info) &&
           isSame(K, rectifiedPinhole(info));
  };
  const std::string images = untransported(topic);  // /left/image_rect_color/compressed
  if (images.substr(images.rfind('/') + 1).starts_with("image_rect")) return true;
  return plain(infos.left) && (!infos.right || plain(*infos.right));
}

bool hasWrongSign(const CameraInfos& infos) {
  if (!infos.right || !hasP(*infos.right)) return false;
  return offsetOf(infos.left).x() < offsetOf(*infos.right).x();
}

Result<CameraRig> rectifiedRig(const CameraInfos& infos, int width, int height) {
  const CameraInfoMessage& left = infos.left;
  CameraRig rig;
  rig.width = width;
  rig.height = height;
  rig.calibrated = true;
  rig.pinhole = rectifiedPinhole(left);
  Status status = checkSize(left, width, height);
  if (status.isOk()) status = checkForms(left);
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
