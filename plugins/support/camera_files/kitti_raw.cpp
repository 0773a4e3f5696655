// SPDX-License-Identifier: BSD-3-Clause
#include <map>

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
  Eigen::Matrix3d rotation(const std::string& name) const {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Matrix3d M = RowMajor(numbers(name, 9).data());
    return rotationOf(M, line(name));
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
  const std::vector<double> K = lines.numbers("K" + number, 9);
  camera.pinhole = {K[0], K[4], K[2], K[5]};
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
  camera.R_rectified_camera = lines.rotation("R_rect" + number);
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

}  // namespace tolman::camera_files
