// SPDX-License-Identifier: BSD-3-Clause
// Raw cameras for tests: real calibrations of three public data sets.
#pragma once

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

#include "tolman/camera.hpp"

namespace tolman::test {

/// OpenCV's camera matrix.
inline cv::Matx33d matrixOf(const Pinhole& K) { return {K.fx, 0, K.cx, 0, K.fy, K.cy, 0, 0, 1}; }

inline RawCamera rawCamera(LensModel model, int width, int height, const Pinhole& pinhole,
                           std::initializer_list<double> distortion) {
  RawCamera camera;
  camera.model = model;
  camera.width = width;
  camera.height = height;
  camera.pinhole = pinhole;
  Eigen::Index i = 0;
  for (const double k : distortion) camera.distortion[i++] = k;
  return camera;
}

/// EuRoC's cam0: pinhole with radial-tangential distortion.
inline RawCamera eurocCamera() {
  return rawCamera(LensModel::RadialTangential, 752, 480, {458.654, 457.296, 367.215, 248.375},
                   {-0.28340811, 0.07395907, 0.00019359, 1.76187114e-05});
}

/// TUM-VI's cam0: a fisheye of 190 degrees.
inline RawCamera fisheyeCamera() {
  return rawCamera(LensModel::Equidistant, 1024, 1024, {380.8104, 380.8119, 510.2947, 514.3305},
                   {0.010171, -0.010816, 0.005943, -0.001662});
}

/// A rational model, as OpenCV fits it to wide lenses; the lens of Azure Kinect's colour camera.
inline RawCamera rationalCamera() {
  return rawCamera(LensModel::RadialTangential, 1280, 720, {605.1, 604.9, 637.7, 366.8},
                   {0.6408, -2.6478, 0.00060, -0.00034, 1.4909, 0.5153, -2.4669, 1.4150});
}

/// A mirror of xi = 1.2 behind a radial-tangential lens.
inline RawCamera omnidirectionalCamera() {
  RawCamera camera = rawCamera(LensModel::Omnidirectional, 1280, 800, {1100, 1101, 640, 402},
                               {-0.21, 0.15, 0.0003, -0.0006});
  camera.xi = 1.2;
  return camera;
}

/// The right camera at `baseline` m along x, turned by the angles (rad) about x, y and z.
inline RawRig pairOf(const RawCamera& camera, double baseline, const Eigen::Vector3d& turned) {
  RawRig rig;
  rig.cameras = {camera, camera};
  Eigen::Isometry3d& T = rig.cameras[1].T_reference_camera;
  T.translation() = Eigen::Vector3d(baseline, 0.003 * baseline, -0.01 * baseline);
  T.linear() = (Eigen::AngleAxisd(turned.x(), Eigen::Vector3d::UnitX()) *
                Eigen::AngleAxisd(turned.y(), Eigen::Vector3d::UnitY()) *
                Eigen::AngleAxisd(turned.z(), Eigen::Vector3d::UnitZ()))
                   .toRotationMatrix();
  return rig;
}

}  // namespace tolman::test
