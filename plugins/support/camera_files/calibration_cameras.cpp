// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_cameras.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::camera_files {
namespace {

using Names = std::initializer_list<std::string_view>;
using RowMajor3 = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using RowMajor34 = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

const Node& need(const Node& map, Names names) {
  const Node* found = map.find(names);
  if (found != nullptr) return *found;
  throw FileError(map.line, "has no " + inQuotes(*names.begin()) + "; add it");
}

std::vector<double> numbersOf(const Node& node) {
  const Node* data = node.find({"data"});
  return data == nullptr ? node.numbers() : data->numbers();
}

}  // namespace

std::vector<double> numbersOf(const Node& node, std::size_t count) {
  std::vector<double> numbers = numbersOf(node);
  if (numbers.size() == count) return numbers;
  throw FileError(node.line, inQuotes(node.key) + " has " + std::to_string(numbers.size()) +
                                 " numbers instead of " + std::to_string(count));
}

namespace {

Eigen::Matrix3d matrix3(const Node& node) { return RowMajor3(numbersOf(node, 9).data()); }

Eigen::Isometry3d poseOf(const Node& node) {
  const RowMajor4 M(numbersOf(node, 16).data());
  if (M.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    throw FileError(node.line, inQuotes(node.key) + " has a last row other than 0 0 0 1");
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotationOf(M.topLeftCorner<3, 3>(), node.line);
  T.translation() = M.topRightCorner<3, 1>();
  return T;
}

Pinhole pinholeOf(const std::vector<double>& v, std::size_t first) {
  return {v[first], v[first + 1], v[first + 2], v[first + 3]};
}

Pinhole pinholeOf(const Node& matrix) {
  return checkedPinhole(matrix3(matrix), matrix.line, inQuotes(matrix.key));
}

LensModel modelOf(const Node& name) {
  const auto is = [&](Names names) {
    return std::find(names.begin(), names.end(), name.text) != names.end();
  };
  if (is({"radtan", "radial-tangential", "plumb_bob", "rational_polynomial"})) {
    return LensModel::RadialTangential;
  }
  if (is({"equidistant", "equi", "fisheye", "kannala_brandt"})) return LensModel::Equidistant;
  if (is({"none", ""})) return LensModel::Pinhole;
  throw FileError(name.line, "the distortion model " + inQuotes(name.text) +
                                 " is not known; calibrate with radtan, plumb_bob, "
                                 "rational_polynomial or equidistant");
}

/// Refuses a model without coefficients, and coefficients without a model. `[]` and zeros mean no
/// distortion; an empty value counts as missing.
void checkModel(const Node& model, const Node* coefficients, std::string_view wanted) {
  const Node* data = coefficients == nullptr ? nullptr : coefficients->find({"data"});
  const Node* numbers = data == nullptr ? coefficients : data;
  const bool missing =
      numbers == nullptr || (numbers->kind == Node::Kind::Value && numbers->text.empty());
  if (missing && modelOf(model) != LensModel::Pinhole) {
    throw FileError(numbers == nullptr ? model.line : numbers->line,
                    inQuotes(model.text) + " has no " + inQuotes(wanted) +
                        "; add them, or [] for a lens without distortion");
  }
  if (missing || !model.text.empty()) return;
  const std::vector<double> k = numbersOf(*coefficients);
  if (std::all_of(k.begin(), k.end(), [](double v) { return v == 0; })) return;
  throw FileError(model.line, inQuotes(model.key) + " is empty, but " +
                                  inQuotes(coefficients->key) +
                                  " are given; name the model, or none");
}

/// Model and coefficients; without any the camera is a pinhole.
void setDistortion(RawCamera& camera, LensModel model, const Node* coefficients) {
  camera.model = model;
  const std::vector<double> k =
      coefficients == nullptr ? std::vector<double>() : numbersOf(*coefficients);
  if (k.empty() || model == LensModel::Pinhole) {
    camera.model = LensModel::Pinhole;
    return;
  }
  const bool fisheye = model == LensModel::Equidistant;
  const bool thin_prism = std::any_of(k.begin() + std::min<std::ptrdiff_t>(8, std::ssize(k)),
                                      k.end(), [](double v) { return v != 0; });
  const bool known = fisheye ? k.size() == 4 : k.size() == 4 || k.size() == 5 || k.size() >= 8;
  if (!known || k.size() > 14 || thin_prism) {
    throw FileError(coefficients->line, inQuotes(coefficients->key) + " has " +
                                            std::to_string(k.size()) + " numbers; " +
                                            (fisheye ? "a fisheye has 4" : "4, 5 or 8 are known"));
  }
  std::copy_n(k.begin(), std::min<std::size_t>(k.size(), 8), camera.distortion.data());
}

void setSize(FileCamera& found, const Node* width, const Node* height) {
  if (width == nullptr || height == nullptr) return;
  for (const Node* side : {width, height}) {
    const double size = side->number();
    if (size >= 1 && size <= 65000 && size == std::floor(size)) continue;  // more is damage
    throw FileError(side->line, inQuotes(side->text) + " is no size of an image in pixels");
  }
  found.size_line = width->line;
  found.camera.width = static_cast<int>(width->number());
  found.camera.height = static_cast<int>(height->number());
}

void setSize(FileCamera& found, const Node& resolution) {
  if (resolution.children.size() != 2) {
    throw FileError(resolution.line, inQuotes(resolution.key) + " must be [width, height]");
  }
  setSize(found, &resolution.children[0], &resolution.children[1]);
}

/// A camera in the form that Kalibr and EuRoC share: intrinsics as a list, and the same model
/// names.
FileCamera listedCamera(const Node& map) {
  FileCamera found;
  found.line = map.line;
  RawCamera& camera = found.camera;
  const Node& intrinsics = need(map, {"intrinsics"});
  found.pinhole_line = intrinsics.line;
  const Node* lens = map.find({"camera_model"});
  const bool mirror = lens != nullptr && lens->text == "omni";
  if (lens != nullptr && !mirror && lens->text != "pinhole") {
    throw FileError(lens->line, "the camera model " + inQuotes(lens->text) +
                                    " is not known; calibrate with pinhole or omni");
  }
  const std::vector<double> numbers = numbersOf(intrinsics, mirror ? 5 : 4);
  camera.pinhole = pinholeOf(numbers, mirror ? 1 : 0);
  const Node& model = need(map, {"distortion_model"});
  const Node* coefficients = map.find({"distortion_coeffs", "distortion_coefficients"});
  checkModel(model, coefficients, "distortion_coeffs");
  setDistortion(camera, modelOf(model), coefficients);
  if (mirror && camera.model == LensModel::Equidistant) {
    throw FileError(lens->line, "omni with equidistant distortion is not known; use omni-radtan");
  }
  if (mirror) camera.model = LensModel::Omnidirectional;
  if (mirror) camera.xi = numbers[0];
  setSize(found, need(map, {"resolution"}));
  return found;
}

/// cam0, cam1 ... of a camera chain. Poses are relative to cam0 if the chain has them, otherwise to
/// the inertial sensor.
FileCameras kalibrCameras(const Node& tree) {
  FileCameras all;
  for (const char* name : {"cam0", "cam1"}) {
    const Node* map = tree.find({name});
    if (map == nullptr) break;
    FileCamera found = listedCamera(*map);
    if (const Node* pose = map->find({"T_cam_imu"})) {
      found.camera.T_reference_camera = poseOf(*pose).inverse();
      found.has_pose = true;
    }
    if (const Node* step = map->find({"T_cn_cnm1"})) all.T_second_first = poseOf(*step);
    all.cameras.push_back(std::move(found));
  }
  return all;
}

FileCameras eurocCamera(const Node& tree) {
  FileCamera found = listedCamera(tree);
  if (const Node* pose = tree.find({"T_BS"})) {
    found.camera.T_reference_camera = poseOf(*pose);
    found.has_pose = true;
  }
  return {{found}, {}};
}

/// R and T of stereo_calib take coordinates of the first camera to the second.
void addStereo(const Node& tree, FileCameras& all) {
  const Node* R = tree.find({"R"});
  const Node* T = tree.find({"T"});
  if (R == nullptr || T == nullptr) return;
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = rotationOf(matrix3(*R), R->line);
  pose.translation() = Eigen::Vector3d(numbersOf(*T, 3).data());
  all.T_second_first = pose;
}

/// The rectified camera of ROS; a matrix of zeros means that it is not set.
void addRectified(const Node& tree, FileCamera& found) {
  const Node* R = tree.find({"rectification_matrix"});
  const Node* P = tree.find({"projection_matrix"});
  if (R == nullptr || P == nullptr) return;
  const RowMajor34 projection(numbersOf(*P, 12).data());
  if (projection(0, 0) <= 0 || projection(1, 1) <= 0) return;
  (void)checkedPinhole(projection.leftCols<3>(), P->line, inQuotes(P->key));
  found.camera.R_rectified_camera = rotationOf(matrix3(*R), R->line);
  found.P_rectified = projection;
  found.rectified_line = P->line;
}

FileCamera matrixCamera(const Node& tree, Names matrix, Names coefficients) {
  FileCamera found;
  const Node& K = need(tree, matrix);
  found.line = found.pinhole_line = found.size_line = K.line;
  found.camera.pinhole = pinholeOf(K);
  const Node* fisheye = tree.find({"fisheye_model"});
  const Node* name = tree.find({"distortion_model"});
  if (name != nullptr) checkModel(*name, tree.find(coefficients), *coefficients.begin());
  LensModel model = name == nullptr ? LensModel::RadialTangential : modelOf(*name);
  if (fisheye != nullptr && fisheye->number() != 0) model = LensModel::Equidistant;
  setDistortion(found.camera, model, tree.find(coefficients));
  if (const Node* xi = tree.find({"xi"})) {
    found.camera.model = LensModel::Omnidirectional;
    found.camera.xi = numbersOf(*xi, 1)[0];
  }
  setSize(found, tree.find({"image_width"}), tree.find({"image_height"}));
  return found;
}

}  // namespace

Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& M, int line) {
  const double error = (M.transpose() * M - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < 1e-3) || M.determinant() < 0) {  // digits that files print
    throw FileError(line, "has no rotation in its first three columns; correct the calibration");
  }
  // Below 1e-9 it is exact up to rounding.
  return error < 1e-9 ? M : Eigen::Quaterniond(M).normalized().toRotationMatrix();
}

Pinhole checkedPinhole(const Eigen::Matrix3d& K, int line, std::string_view name) {
  constexpr double kUnused = 1e-4;  // chosen: less moves no pixel by a tenth
  const Pinhole pinhole = {K(0, 0), K(1, 1), K(0, 2), K(1, 2)};
  Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
  expected << pinhole.fx, 0, pinhole.cx, 0, pinhole.fy, pinhole.cy, 0, 0, 1;
  if ((K - expected).cwiseAbs().maxCoeff() <= kUnused) return pinhole;
  throw FileError(line, std::string(name) +
                            " has other numbers than 0 for the skew, or than 0 0 1 in the third "
                            "row (fx 0 cx, 0 fy cy, 0 0 1); correct the calibration");
}

FileCameras camerasIn(const Node& tree) {
  if (tree.find({"cam0"}) != nullptr) return kalibrCameras(tree);
  if (tree.find({"intrinsics"}) != nullptr) return eurocCamera(tree);
  FileCameras all;
  if (tree.find({"M1", "K1", "cameraMatrix1"}) != nullptr) {
    all.cameras = {matrixCamera(tree, {"M1", "K1", "cameraMatrix1"}, {"D1", "distCoeffs1"}),
                   matrixCamera(tree, {"M2", "K2", "cameraMatrix2"}, {"D2", "distCoeffs2"})};
  } else if (tree.find({"camera_matrix", "cameraMatrix", "Camera_Matrix", "K"}) != nullptr) {
    all.cameras = {
        matrixCamera(tree, {"camera_matrix", "cameraMatrix", "Camera_Matrix", "K"},
                     {"distortion_coefficients", "distCoeffs", "Distortion_Coefficients", "D"})};
    addRectified(tree, all.cameras.front());
  }
  addStereo(tree, all);
  if (!all.cameras.empty() || all.T_second_first) return all;
  throw FileError(0,
                  "is no calibration of Kalibr (cam0), EuRoC (intrinsics), ROS or OpenCV "
                  "(camera_matrix; M1, D1, M2, D2, R, T); give one of these");
}

}  // namespace tolman::camera_files
