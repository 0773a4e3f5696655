// SPDX-License-Identifier: BSD-3-Clause
// KITTI's files of lines "NAME: numbers": calib_cam_to_cam.txt of the raw data, and calib.txt of
// the odometry benchmark.
#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/text_file.hpp"
#include "calibration_cameras.hpp"
#include "given_pinhole.hpp"

namespace tolman::camera_files {
namespace {

/// The lines of a file by their names.
class Lines {
 public:
  explicit Lines(std::string_view text) {
    for (const text_encoding::TextLine& line : text_encoding::contentLines(text)) {
      const std::size_t colon = line.text.find(':');
      if (colon == std::string::npos) {
        throw FileError(line.number, "is not of the form 'NAME: numbers'; correct it");
      }
      const std::string name = line.text.substr(0, colon);
      const auto [same, is_new] = lines_.try_emplace(
          name, text_encoding::TextLine{line.number, line.text.substr(colon + 1)});
      if (is_new) continue;
      throw FileError(line.number, name + " is given twice, first in line " +
                                       std::to_string(same->second.number) +
                                       "; remove one of the two");
    }
  }

  bool has(const std::string& name) const { return lines_.contains(name); }
  int line(const std::string& name) const { return lines_.at(name).number; }
  std::vector<double> numbers(const std::string& name, std::size_t count) const {
    const auto found = lines_.find(name);
    if (found == lines_.end()) throw FileError(0, "has no " + name + "; restore the file");
    const int line = found->second.number;
    std::vector<double> numbers;
    for (const std::string_view field : text_encoding::splitFields(found->second.text)) {
      numbers.push_back(numberOf(field, line));
    }
    if (numbers.size() == count) return numbers;
    throw FileError(line, name + " has " + std::to_string(numbers.size()) + " numbers instead of " +
                              std::to_string(count));
  }
  Eigen::Matrix3d matrix(const std::string& name) const {
    return Eigen::Matrix<double, 3, 3, Eigen::RowMajor>(numbers(name, 9).data());
  }
  /// P = K [I | t].
  Projection projection(const std::string& name) const {
    const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> P(numbers(name, 12).data());
    const Pinhole pinhole = pinholeOf(P.leftCols<3>(), line(name));
    if (pinhole.fx > 0 && pinhole.fy > 0) return P;
    throw FileError(line(name), "has focal lengths that are not positive; correct them");
  }
  void size(const std::string& name, int& width, int& height) const {
    const std::vector<double> size = numbers(name, 2);
    width = sizeOf(size[0], line(name));
    height = sizeOf(size[1], line(name));
  }

 private:
  std::map<std::string, text_encoding::TextLine> lines_;
};

FileCamera cameraOf(const Lines& lines, const std::string& number) {
  FileCamera found;
  found.has_pose = true;
  RawCamera& camera = found.camera;
  lines.size("S" + number, camera.width, camera.height);
  camera.pinhole = pinholeOf(lines.matrix("K" + number), lines.line("K" + number));
  found.line = lines.line("K" + number);
  (void)source_parameters::setLens("radtan", lines.numbers("D" + number, 5), camera);
  Eigen::Isometry3d T_camera_first = Eigen::Isometry3d::Identity();
  T_camera_first.linear() = rotationOf(lines.matrix("R" + number), lines.line("R" + number));
  T_camera_first.translation() = Eigen::Vector3d(lines.numbers("T" + number, 3).data());
  camera.T_reference_camera = T_camera_first.inverse();
  if (!lines.has("P_rect" + number)) return found;
  found.P_rectified = lines.projection("P_rect" + number);
  camera.R_rectified_camera =
      rotationOf(lines.matrix("R_rect" + number), lines.line("R_rect" + number));
  lines.size("S_rect" + number, found.rectified_width, found.rectified_height);
  return found;
}

}  // namespace

FileCameras kittiRawCameras(std::string_view text, int left) {
  const Lines lines(text);
  FileCameras all;
  for (const int camera : {left, left + 1}) {
    const std::string number = "_0" + std::to_string(camera);
    if (camera > left && !lines.has("K" + number)) break;
    all.cameras.push_back(cameraOf(lines, number));
  }
  return all;
}

std::vector<Projection> kittiProjections(std::string_view text, int left, bool stereo) {
  const Lines lines(text);
  std::vector<Projection> projections = {lines.projection("P" + std::to_string(left))};
  if (stereo) projections.push_back(lines.projection("P" + std::to_string(left + 1)));
  return projections;
}

}  // namespace tolman::camera_files
