// SPDX-License-Identifier: BSD-3-Clause
#include "calibration_cameras.hpp"

#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/core.hpp>
#include <span>

#include "base/text_file.hpp"
#include "given_pinhole.hpp"

#pragma GCC visibility push(default)  // of its exceptions, which the library throws
#include <yaml-cpp/yaml.h>
#pragma GCC visibility pop

namespace tolman::camera_files {

namespace {

using text_encoding::inQuotes;

constexpr int kDeepest = 16;  // levels; an alias in YAML may contain itself

Node treeOf(const YAML::Node& yaml, int depth) {
  Node node;
  node.line = yaml.Mark().line + 1;
  if (depth > kDeepest) throw FileError(node.line, "is nested too deeply; it is no calibration");
  if (yaml.IsScalar()) node.text = yaml.Scalar();
  if (yaml.IsSequence()) node.kind = Node::Kind::List;
  if (yaml.IsMap()) node.kind = Node::Kind::Map;
  for (const auto& entry : yaml) {
    const bool in_map = node.kind == Node::Kind::Map;
    node.children.push_back(treeOf(in_map ? entry.second : entry, depth + 1));
    if (!in_map) continue;
    node.children.back().key = entry.first.Scalar();
    node.children.back().line = entry.first.Mark().line + 1;
  }
  return node;
}

Node treeOf(const cv::FileNode& xml) {
  Node node;
  if (xml.isString()) node.text = xml.string();
  if (xml.isInt() || xml.isReal()) node.text = text_encoding::rounded(xml.real(), 17);
  if (!xml.isSeq() && !xml.isMap()) return node;
  node.kind = xml.isMap() ? Node::Kind::Map : Node::Kind::List;
  for (const cv::FileNode& child : xml) {
    node.children.push_back(treeOf(child));
    if (xml.isMap()) node.children.back().key = child.name();
  }
  return node;
}

void appendNumbers(const Node& node, std::vector<double>& numbers) {
  for (const Node& child : node.children) appendNumbers(child, numbers);
  if (node.kind != Node::Kind::Value || node.text.empty()) return;
  numbers.push_back(numberOf(node.text, node.line));
}

}  // namespace

double numberOf(std::string_view field, int line) {
  if (const std::optional<double> number = text_encoding::parseNumber(field)) return *number;
  throw FileError(line, inQuotes(field) + " " + std::string(text_encoding::numberProblem(field)) +
                            "; correct it");
}

const Node* Node::find(std::initializer_list<std::string_view> names) const {
  const Node* found = nullptr;
  for (const Node& child : children) {
    if (std::find(names.begin(), names.end(), child.key) == names.end()) continue;
    if (found != nullptr) {
      const std::string what = child.key == found->key
                                   ? " is given twice, first in line "
                                   : " means the same as " + inQuotes(found->key) + " in line ";
      throw FileError(child.line, inQuotes(child.key) + what + std::to_string(found->line) +
                                      "; remove one of the two");
    }
    found = &child;
  }
  return found;
}

const Node& Node::need(std::initializer_list<std::string_view> names) const {
  const Node* found = find(names);
  if (found != nullptr) return *found;
  throw FileError(line, "has no " + inQuotes(*names.begin()) + "; add it");
}

std::vector<double> Node::numbers() const {
  const Node* data = find({"data"});
  std::vector<double> numbers;
  appendNumbers(data == nullptr ? *this : *data, numbers);
  return numbers;
}

std::vector<double> Node::numbers(std::size_t count) const {
  std::vector<double> all = numbers();
  if (all.size() == count) return all;
  throw FileError(line, inQuotes(key) + " has " + std::to_string(all.size()) +
                            " numbers instead of " + std::to_string(count));
}

Node parseYaml(const std::string& text) {
  try {
    Node node = treeOf(YAML::Load(text), 0);
    node.line = 0;
    return node;
  } catch (const YAML::Exception& error) {
    throw FileError(error.mark.line + 1, "is no YAML (" + error.msg + "); correct it");
  }
}

Node parseXml(const std::string& text) {
  try {
    constexpr int kMode =
        cv::FileStorage::READ | cv::FileStorage::MEMORY | cv::FileStorage::FORMAT_XML;
    return treeOf(cv::FileStorage(text, kMode).root());
  } catch (const cv::Exception& error) {
    throw FileError(0, "is no XML that OpenCV can read (" + error.err + "); correct it");
  }
}

namespace {

using text_encoding::inQuotes;
using Names = std::initializer_list<std::string_view>;
template <int kRows, int kColumns>
using RowMajor = Eigen::Matrix<double, kRows, kColumns, Eigen::RowMajor>;

Eigen::Matrix3d matrix3(const Node& node) { return RowMajor<3, 3>(node.numbers(9).data()); }

Eigen::Isometry3d poseOf(const Node& node) {
  const RowMajor<4, 4> M(node.numbers(16).data());
  if (M.row(3) != Eigen::RowVector4d(0, 0, 0, 1)) {
    throw FileError(node.line, inQuotes(node.key) + " has a last row other than 0 0 0 1");
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = rotationOf(M.topLeftCorner<3, 3>(), node.line);
  T.translation() = M.topRightCorner<3, 1>();
  return T;
}

/// `coefficients`: null for none, which a named model must not have; `[]` and zeros mean a lens
/// without distortion.
void setDistortion(std::string_view model, int line, const Node* coefficients, RawCamera& camera) {
  const bool is_named = !model.empty() && model != "none";
  const bool is_there = coefficients != nullptr &&
                        (coefficients->kind != Node::Kind::Value || !coefficients->text.empty());
  if (is_named && !is_there) {
    throw FileError(
        line,
        inQuotes(model) + " has no coefficients; add them, or [] for a lens without distortion");
  }
  const std::vector<double> k = is_there ? coefficients->numbers() : std::vector<double>();
  const Status status = source_parameters::setLens(model, k, camera);
  if (!status.isOk()) throw FileError(is_there ? coefficients->line : line, status.message());
}

void setSize(FileCamera& found, const Node* width, const Node* height) {
  if (width == nullptr || height == nullptr) return;
  found.camera.width = sizeOf(width->numbers(1)[0], width->line);
  found.camera.height = sizeOf(height->numbers(1)[0], height->line);
}

void setRound(std::string_view name, std::span<const double> parameters, int line,
              RawCamera& camera) {
  const std::optional<RadiusByAngle> lens = roundLens(name, parameters);
  if (!lens) {
    throw FileError(line, "has " + std::to_string(parameters.size()) + " parameters of the model " +
                              inQuotes(name) + "; known are ds, eucm (2) and fov (1)");
  }
  const Status status = setRoundLens(*lens, camera);
  if (!status.isOk()) throw FileError(line, status.message());
}

/// A camera in the form that Kalibr and EuRoC share: intrinsics as a list, those of the lens first,
/// and the same model names.
FileCamera listedCamera(const Node& map) {
  FileCamera found;
  found.line = map.line;
  const Node* lens = map.find({"camera_model"});
  const std::string name = lens == nullptr ? "pinhole" : lens->text;
  const bool is_mirror = name == "omni";
  const bool is_round = name == "ds" || name == "eucm";
  if (!is_mirror && !is_round && name != "pinhole") {
    throw FileError(lens->line, "the camera model " + inQuotes(name) +
                                    " is not known; calibrate with pinhole, omni, eucm or ds");
  }
  const std::size_t first = is_mirror ? 1 : is_round ? 2 : 0;
  const std::vector<double> v = map.need({"intrinsics"}).numbers(first + 4);
  found.camera.pinhole = {v[first], v[first + 1], v[first + 2], v[first + 3]};
  const Node& size = map.need({"resolution"});
  if (size.children.size() != 2) {
    throw FileError(size.line, inQuotes(size.key) + " must be [width, height]");
  }
  setSize(found, &size.children[0], &size.children[1]);
  if (is_round) {
    setRound(name, std::span(v).first(2), lens->line, found.camera);
    return found;
  }
  const Node& model = map.need({"distortion_model"});
  const Node* k = map.find({"distortion_coeffs", "distortion_coefficients"});
  if (model.text == "fov" && k != nullptr && !is_mirror) {
    setRound(model.text, k->numbers(), k->line, found.camera);
    return found;
  }
  setDistortion(model.text, model.line, k, found.camera);
  if (is_mirror && found.camera.model == LensModel::Equidistant) {
    throw FileError(lens->line, "omni with equidistant distortion is not known; use omni-radtan");
  }
  if (is_mirror) found.camera.model = LensModel::Omnidirectional;
  if (is_mirror) found.camera.xi = v[0];
  return found;
}

/// Basalt's calibration, JSON: intrinsics and poses in the axes of the inertial sensor, by camera.
FileCameras basaltCameras(const Node& tree) {
  const Node& cameras = tree.need({"intrinsics"});
  const Node& poses = tree.need({"T_imu_cam"});
  const Node& sizes = tree.need({"resolution"});
  FileCameras all;
  for (std::size_t i = 0; i < cameras.children.size(); ++i) {
    const Node& map = cameras.children[i];
    if (i >= poses.children.size() || i >= sizes.children.size()) {
      throw FileError(map.line, "has no pose or resolution for each camera; add them");
    }
    const Node& model = map.need({"camera_type"});
    const Node& values = map.need({"intrinsics"});
    const auto number = [](const Node& of, const char* name) {
      return of.need({name}).numbers(1)[0];
    };
    FileCamera found;
    found.line = map.line;
    found.has_pose = true;
    const Node& size = sizes.children[i];
    if (size.children.size() != 2) throw FileError(size.line, "must be [width, height]");
    setSize(found, &size.children[0], &size.children[1]);
    found.camera.pinhole = {number(values, "fx"), number(values, "fy"), number(values, "cx"),
                            number(values, "cy")};
    std::vector<double> k;
    for (const char* name : {"k1", "k2", "k3", "k4"}) {
      if (values.find({name}) != nullptr) k.push_back(number(values, name));
    }
    if (model.text == "ds") {
      setRound("ds", std::array{number(values, "xi"), number(values, "alpha")}, model.line,
               found.camera);
    } else if (model.text == "eucm") {
      setRound("eucm", std::array{number(values, "alpha"), number(values, "beta")}, model.line,
               found.camera);
    } else if (model.text == "kb4" || model.text == "pinhole") {
      const Status status = source_parameters::setLens(
          model.text == "kb4" ? "kannala_brandt4" : "none", k, found.camera);
      if (!status.isOk()) throw FileError(model.line, status.message());
    } else {
      throw FileError(model.line, "the camera type " + inQuotes(model.text) +
                                      " is not known; calibrate with pinhole, kb4, eucm or ds");
    }
    const Node& pose = poses.children[i];
    const Eigen::Quaterniond q(number(pose, "qw"), number(pose, "qx"), number(pose, "qy"),
                               number(pose, "qz"));
    found.camera.T_reference_camera.linear() = rotationOf(q.toRotationMatrix(), pose.line);
    found.camera.T_reference_camera.translation() << number(pose, "px"), number(pose, "py"),
        number(pose, "pz");
    all.cameras.push_back(std::move(found));
  }
  return all;
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
  pose.translation() = Eigen::Vector3d(T->numbers(3).data());
  all.T_second_first = pose;
}

/// The rectified camera of ROS; a matrix of zeros means that it is not set.
void addRectified(const Node& tree, FileCamera& found) {
  const Node* R = tree.find({"rectification_matrix"});
  const Node* P = tree.find({"projection_matrix"});
  if (R == nullptr || P == nullptr) return;
  const RowMajor<3, 4> projection(P->numbers(12).data());
  if (projection(0, 0) <= 0 || projection(1, 1) <= 0) return;
  (void)pinholeOf(projection.leftCols<3>(), P->line);
  found.camera.R_rectified_camera = rotationOf(matrix3(*R), R->line);
  found.P_rectified = projection;
}

/// A camera as ROS and OpenCV write it: a matrix, coefficients, and perhaps the name of a model.
FileCamera matrixCamera(const Node& tree, Names matrix, Names coefficients) {
  FileCamera found;
  const Node& K = tree.need(matrix);
  found.line = K.line;
  found.camera.pinhole = pinholeOf(matrix3(K), K.line);
  const Node* fisheye = tree.find({"fisheye_model"});
  const Node* name = tree.find({"distortion_model"});
  const Node* k = tree.find(coefficients);
  std::string model = name != nullptr ? name->text : k != nullptr ? "plumb_bob" : "none";
  if (fisheye != nullptr && fisheye->numbers(1)[0] != 0) model = "fisheye";
  setDistortion(model, name != nullptr ? name->line : K.line, k, found.camera);
  if (const Node* xi = tree.find({"xi"})) {
    found.camera.model = LensModel::Omnidirectional;
    found.camera.xi = xi->numbers(1)[0];
  }
  setSize(found, tree.find({"image_width"}), tree.find({"image_height"}));
  return found;
}

}  // namespace

int sizeOf(double pixels, int line) {
  if (pixels >= 1 && pixels <= 65000 && pixels == std::floor(pixels)) {
    return static_cast<int>(pixels);
  }
  throw FileError(line, text_encoding::rounded(pixels) + " is no size of an image in pixels");
}

Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& M, int line) {
  const double error = (M.transpose() * M - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  if (!(error < 1e-3) || M.determinant() < 0) {  // digits that files print
    throw FileError(line, "has no rotation in its first three columns; correct the calibration");
  }
  // Below 1e-9 it is exact up to rounding.
  return error < 1e-9 ? M : Eigen::Quaterniond(M).normalized().toRotationMatrix();
}

Pinhole pinholeOf(const Eigen::Matrix3d& K, int line) {
  constexpr double kUnused = 1e-4;  // chosen: less moves no pixel by a tenth
  const Pinhole pinhole = {K(0, 0), K(1, 1), K(0, 2), K(1, 2)};
  Eigen::Matrix3d expected = Eigen::Matrix3d::Identity();
  expected << pinhole.fx, 0, pinhole.cx, 0, pinhole.fy, pinhole.cy, 0, 0, 1;
  if ((K - expected).cwiseAbs().maxCoeff() <= kUnused) return pinhole;
  throw FileError(line,
                  "is not the matrix fx 0 cx, 0 fy cy, 0 0 1 of a camera without skew; correct the "
                  "calibration");
}

FileCameras camerasIn(const Node& tree) {
  if (tree.find({"cam0"}) != nullptr) return kalibrCameras(tree);
  if (const Node* basalt = tree.find({"value0"})) return basaltCameras(*basalt);
  if (tree.find({"intrinsics"}) != nullptr) return eurocCamera(tree);
  FileCameras all;
  const Names kMatrix = {"camera_matrix", "cameraMatrix", "Camera_Matrix", "K"};
  if (tree.find({"M1", "K1", "cameraMatrix1"}) != nullptr) {
    all.cameras = {matrixCamera(tree, {"M1", "K1", "cameraMatrix1"}, {"D1", "distCoeffs1"}),
                   matrixCamera(tree, {"M2", "K2", "cameraMatrix2"}, {"D2", "distCoeffs2"})};
  } else if (tree.find(kMatrix) != nullptr) {
    all.cameras = {matrixCamera(
        tree, kMatrix, {"distortion_coefficients", "distCoeffs", "Distortion_Coefficients", "D"})};
    addRectified(tree, all.cameras.front());
  }
  addStereo(tree, all);
  if (!all.cameras.empty() || all.T_second_first) return all;
  throw FileError(
      0,
      "is no calibration of Kalibr (cam0), Basalt (value0), EuRoC (intrinsics), ROS or OpenCV "
      "(camera_matrix; M1, D1, M2, D2, R, T); give one of these");
}

std::optional<RadiusByAngle> roundLens(std::string_view name, std::span<const double> parameters) {
  if (name == "ds" && parameters.size() == 2) {
    return [xi = parameters[0], alpha = parameters[1]](double angle) {
      const double z = xi + std::cos(angle);
      return std::sin(angle) / (alpha * std::hypot(std::sin(angle), z) + (1 - alpha) * z);
    };
  }
  if (name == "eucm" && parameters.size() == 2) {
    return [alpha = parameters[0], beta = parameters[1]](double angle) {
      const double d = std::hypot(std::sqrt(beta) * std::sin(angle), std::cos(angle));
      return std::sin(angle) / (alpha * d + (1 - alpha) * std::cos(angle));
    };
  }
  if (name == "fov" && parameters.size() == 1 && parameters[0] > 0) {
    return [w = parameters[0]](double angle) {
      return std::atan2(2 * std::tan(w / 2) * std::sin(angle), std::cos(angle)) / w;
    };
  }
  return std::nullopt;
}

Status setRoundLens(const RadiusByAngle& lens, RawCamera& camera) {
  constexpr double kStep = 1e-3;      // rad
  constexpr double kMostError = 0.1;  // px
  constexpr int kSamples = 400;
  const Pinhole& K = camera.pinhole;
  const double farthest = std::hypot(std::max(K.cx, camera.width - K.cx) / K.fx,
                                     std::max(K.cy, camera.height - K.cy) / K.fy);
  double widest = 0;  // the angle of the farthest corner, or from which the radius decreases
  for (double radius = 0; radius < farthest; widest += kStep) {
    const double next = lens(widest + kStep);
    if (!(next > radius)) break;
    radius = next;
  }
  Eigen::Matrix<double, kSamples, 5> powers;
  Eigen::Matrix<double, kSamples, 1> radii;
  for (int i = 0; i < kSamples; ++i) {
    const double angle = widest * (i + 1) / kSamples;
    radii(i) = lens(angle);
    for (int k = 0; k < 5; ++k) powers(i, k) = std::pow(angle, 2 * k + 1);
  }
  const Eigen::Matrix<double, 5, 1> c = powers.colPivHouseholderQr().solve(radii);
  const double error = (powers * c - radii).cwiseAbs().maxCoeff() * std::max(K.fx, K.fy);
  if (!(error < kMostError) || !(c[0] > 0)) {
    return Status::unsupported(
        "has a lens that the polynomial of Kannala and Brandt does not fit; calibrate with "
        "equidistant (kb4)");
  }
  camera.model = LensModel::Equidistant;
  camera.distortion.setZero();
  camera.distortion.head<4>() = c.tail<4>() / c[0];
  camera.pinhole.fx *= c[0];
  camera.pinhole.fy *= c[0];
  return Status::ok();
}

}  // namespace tolman::camera_files
