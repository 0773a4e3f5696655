// SPDX-License-Identifier: BSD-3-Clause
#include "camera_info_checks.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "projection.hpp"

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
                              "give fx of rectified images");
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
      "has no rotation in R; correct it, calibrate the cameras again, or give fx of rectified "
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
        "has binning or a region of interest, which are not used; record whole images, or give fx "
        "of these");
  }
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

}  // namespace tolman::ros_messages
