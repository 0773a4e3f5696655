// SPDX-License-Identifier: BSD-3-Clause
// Cameras in the calibration files of Kalibr, Basalt, OpenCV, ROS and EuRoC.
//
// A YAML or XML file as a tree of maps, lists and values with their line numbers.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "given_pinhole.hpp"
#include "tolman/camera.hpp"
#include "tolman/status.hpp"

namespace tolman::camera_files {

/// An error at a line (0: the whole file), with the remedy.
struct FileError : std::runtime_error {
  FileError(int at, const std::string& what) : std::runtime_error(what), line(at) {}
  int line;
};

struct Node {
  enum class Kind : unsigned char { Value, List, Map };
  Kind kind = Kind::Value;
  int line = 0;      ///< of its key in a map, else of itself; 0: unknown, as in XML
  std::string key;   ///< its key in a map
  std::string text;  ///< of a value
  std::vector<Node> children;

  /// The child with one of these names, which are synonyms; null if there is none. Throws FileError
  /// if there are two.
  const Node* find(std::initializer_list<std::string_view> names) const;
  /// The same; throws FileError if there is none.
  const Node& need(std::initializer_list<std::string_view> names) const;
  /// All numbers of this node and its children, in order; of a matrix with rows, cols and data
  /// those of its data. Throws FileError for any other text.
  std::vector<double> numbers() const;
  /// Throws FileError unless it has `count` numbers.
  std::vector<double> numbers(std::size_t count) const;
};

/// By yaml-cpp. Throws FileError.
Node parseYaml(const std::string& text);

/// By cv::FileStorage, whose format of XML it must be. Throws FileError.
Node parseXml(const std::string& text);

// The cameras in a calibration file of any supported format.

using source_parameters::Projection;

struct FileCamera {
  RawCamera camera;  ///< width 0: the file does not state the size of the images
  int line = 0;      ///< of the camera; 0: the whole file
  bool has_pose = false;
  /// Rotation (in `camera`) and projection of the rectified camera, where the file has them.
  std::optional<Projection> P_rectified;
  int rectified_width = 0;  ///< px; 0: that of the raw images, and used only for pairs
  int rectified_height = 0;
};

struct FileCameras {
  std::vector<FileCamera> cameras;
  std::optional<Eigen::Isometry3d> T_second_first;  ///< OpenCV's R and T
};

/// Kalibr (camchain.yaml), Basalt (calibration.json), ROS (camera_info), EuRoC (sensor.yaml),
/// OpenCV (calibration and stereo_calib). Throws FileError.
FileCameras camerasIn(const Node& tree);

/// calib_cam_to_cam.txt of KITTI's raw data: camera `left` and the one after it. Throws FileError.
FileCameras kittiRawCameras(std::string_view text, int left);

/// camera.txt of TUM's monocular sets and of DSO. Throws FileError.
FileCameras lineCameras(std::string_view text);
bool isLineCalibration(std::string_view text);

/// P<left> and, for a pair, P<left + 1> of KITTI's calib.txt. Throws FileError.
std::vector<Projection> kittiProjections(std::string_view text, int left, bool stereo);

/// A number in a file. Throws FileError for any other text.
double numberOf(std::string_view field, int line);

/// A size in pixels. Throws FileError for what is none.
int sizeOf(double pixels, int line);

/// Makes a rotation from a file, which has few digits, orthonormal. Throws FileError.
Eigen::Matrix3d rotationOf(const Eigen::Matrix3d& M, int line);

/// The numbers of a camera matrix. Throws FileError unless it is fx 0 cx 0 fy cy 0 0 1.
Pinhole pinholeOf(const Eigen::Matrix3d& K, int line);

// Lenses that are symmetric about their axis, as a function of the angle to it. The host knows one
// family of them, the polynomial of Kannala and Brandt, which fits the others within 0.02 px.

/// Distance from the principal point by angle, rad; for a focal length of 1.
using RadiusByAngle = std::function<double(double)>;

/// Double sphere (`ds`: xi, alpha; Usenko, Demmel, Cremers 2018), extended unified (`eucm`: alpha,
/// beta; Khomutenko, Garcia, Martinet 2016), and field of view (`fov`: w; Devernay, Faugeras 2001).
/// None for another name or number of parameters.
std::optional<RadiusByAngle> roundLens(std::string_view name, std::span<const double> parameters);

/// Sets model, distortion and focal lengths of a camera whose size and pinhole are set. Unsupported
/// if the polynomial differs by more than 0.1 px within the image.
Status setRoundLens(const RadiusByAngle& lens, RawCamera& camera);

}  // namespace tolman::camera_files
