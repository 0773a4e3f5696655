// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>

#include "calibration_cameras.hpp"

namespace tolman::camera_files {
namespace {

/// The lines "K_00: 1 2 3" of a file, by name.
std::map<std::string, Node> linesByName(std::string_view text) {
  std::map<std::string, Node> lines;
  for (int number = 1; !text.empty(); ++number) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos) continue;
    const std::string name(line.substr(0, colon));
    const Node value = {Node::Kind::Value, number, name, std::string(line.substr(colon + 1)), {}};
    const auto [same, is_new] = lines.emplace(name, value);
    if (!is_new) throw givenTwice(number, name, same->second.line);
  }
  return lines;
}

class Lines {
 public:
  explicit Lines(std::string_view text) : lines_(linesByName(text)) {}

  bool has(const std::string& name) const { return lines_.contains(name); }
  int line(const std::string& name) const { return lines_.at(name).line; }
  std::vector<double> numbers(const std::string& name, std::size_t count) const {
    const auto found = lines_.find(name);
    if (found == lines_.end()) throw FileError(0, "has no " + name + "; restore the file");
    std::vector<double> numbers = found->second.numbers();
    if (numbers.size() == count) return numbers;
    throw FileError(found->second.line, name + " has " + std::to_string(numbers.size()) +
                                            " numbers instead of " + std::to_string(count));
  }
  Eigen::Matrix3d matrix(const std::string& name) const {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    return RowMajor(numbers(name, 9).data());
  }
  Eigen::Matrix3d rotation(const std::string& name) const {
    const Eigen::Matrix3d M = matrix(name);
    return rotationOf(M, line(name));
  }
  Pinhole pinhole(const std::string& name) const {
    const Eigen::Matrix3d K = matrix(name);
    return checkedPinhole(K, line(name), name);
  }
  void size(const std::string& name, int& width, int& height) const {
    const std::vector<double> size = numbers(name, 2);
    if (!(size[0] >= 1 && size[0] <= 65000 && size[1] >= 1 && size[1] <= 65000)) {
      throw FileError(line(name), name + " is no size of an image in pixels");
    }
    width = static_cast<int>(size[0]);
    height = static_cast<int>(size[1]);
  }

 private:
  std::map<std::string, Node> lines_;
};

FileCamera cameraOf(const Lines& lines, const std::string& number) {
  FileCamera found;
  found.has_pose = true;
  RawCamera& camera = found.camera;
  lines.size("S" + number, camera.width, camera.height);
  camera.pinhole = lines.pinhole("K" + number);
  found.line = found.size_line = lines.line("S" + number);
  found.pinhole_line = lines.line("K" + number);
  const std::vector<double> D = lines.numbers("D" + number, 5);
  camera.model = LensModel::RadialTangential;
  std::copy(D.begin(), D.end(), camera.distortion.data());
  Eigen::Isometry3d T_camera_first = Eigen::Isometry3d::Identity();
  T_camera_first.linear() = lines.rotation("R" + number);
  T_camera_first.translation() = Eigen::Vector3d(lines.numbers("T" + number, 3).data());
  camera.T_reference_camera = T_camera_first.inverse();
  if (!lines.has("P_rect" + number)) return found;
  using RowMajor = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
  found.P_rectified = RowMajor(lines.numbers("P_rect" + number, 12).data());
  found.rectified_line = lines.line("P_rect" + number);
  (void)checkedPinhole(found.P_rectified->leftCols<3>(), found.rectified_line, "P_rect" + number);
  camera.R_rectified_camera = lines.rotation("R_rect" + number);
  lines.size("S_rect" + number, found.rectified_width, found.rectified_height);
  return found;
}

std::string placeText(const Eigen::Vector3d& place) {
  return "(" + shortNumber(place.x()) + ", " + shortNumber(place.y()) + ", " +
         shortNumber(place.z()) + ") m";
}

/// The rotation from the reference to the rectified axes: R_rect R.
Eigen::Matrix3d rectifyingRotation(const RawCamera& camera) {
  return camera.R_rectified_camera * camera.T_reference_camera.linear().transpose();
}

/// The origin of the reference in the rectified axes: R_rect T.
Eigen::Vector3d rectifiedOrigin(const RawCamera& camera) {
  return camera.R_rectified_camera * camera.T_reference_camera.inverse().translation();
}

/// Refuses a pair whose rectified cameras differ from the raw ones that they were computed from:
/// both must have one size and one orientation, and P_rect must place them as T does. `l` and `r`
/// are the numbers of the two cameras.
void checkPair(const Lines& lines, const FileCamera& left, const FileCamera& right,
               const std::string& l, const std::string& r) {
  // The tolerances are chosen. KITTI's files of 2011_09_26 and 2011_09_30 have less than 1e-6
  // degrees and 0.06 % (0.003 % the grey pairs); 0.1 degrees move a pixel by 1.3 px.
  constexpr double kApart = 0.1;   // degrees
  constexpr double kOther = 0.05;  // of the baseline
  const auto size = [](const FileCamera& camera) {
    return std::to_string(camera.rectified_width) + "x" + std::to_string(camera.rectified_height);
  };
  if (size(left) != size(right)) {
    throw FileError(lines.line("S_rect" + r), "S_rect" + r + " is " + size(right) +
                                                  " px, but S_rect" + l + " " + size(left) +
                                                  " px; restore the file");
  }
  const Eigen::AngleAxisd turn(rectifyingRotation(right.camera) *
                               rectifyingRotation(left.camera).transpose());
  const double apart = turn.angle() * 180 / std::numbers::pi;
  if (!(apart <= kApart)) {
    throw FileError(lines.line("R_rect" + r),
                    "R_rect" + r + " R" + r + " and R_rect" + l + " R" + l + " are " +
                        shortNumber(apart) +
                        " degrees apart, but are one rotation in a rectified pair; restore the "
                        "file");
  }
  const Eigen::Vector3d by_P = source_parameters::offsetOf(*left.P_rectified) -
                               source_parameters::offsetOf(*right.P_rectified);
  const Eigen::Vector3d by_T = rectifiedOrigin(left.camera) - rectifiedOrigin(right.camera);
  if (!((by_P - by_T).norm() <= kOther * std::max(by_P.norm(), by_T.norm()))) {
    throw FileError(right.rectified_line, "P_rect" + l + " and P_rect" + r +
                                              " place the right camera at " + placeText(by_P) +
                                              " from the left one, but T" + l + " and T" + r +
                                              " at " + placeText(by_T) + "; restore the file");
  }
}

}  // namespace

FileCameras kittiRawCameras(std::string_view text, int left, int wanted) {
  const Lines lines(text);
  FileCameras all;
  for (const int camera : {left, left + 1}) {
    const std::string number = "_0" + std::to_string(camera);
    if (camera > left && !lines.has("K" + number)) break;
    all.cameras.push_back(cameraOf(lines, number));
  }
  const bool pair = wanted == 2 && all.cameras.size() == 2;
  if (pair && all.cameras[0].P_rectified && all.cameras[1].P_rectified) {
    checkPair(lines, all.cameras[0], all.cameras[1], "_0" + std::to_string(left),
              "_0" + std::to_string(left + 1));
  }
  return all;
}

}  // namespace tolman::camera_files
