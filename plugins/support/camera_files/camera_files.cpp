// SPDX-License-Identifier: BSD-3-Clause
#include "camera_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "base/open_files.hpp"
#include "base/text_encoding.hpp"
#include "calibration_cameras.hpp"
#include "pair_check.hpp"

namespace tolman::camera_files {
namespace fs = std::filesystem;

namespace {

/// Throws FileError.
std::string readText(const fs::path& file) {
  constexpr std::uintmax_t kMaxBytes = 1U << 20U;  // bounds memory
  std::error_code failure;
  if (!fs::is_regular_file(file, failure)) {
    throw FileError(0, "is missing; restore it, or correct the path");
  }
  if (fs::file_size(file, failure) > kMaxBytes || failure) {
    throw FileError(0, "is larger than 1 MiB; this is no calibration");
  }
  std::ifstream stream(file, std::ios::binary);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream.is_open() || (!stream.eof() && !stream)) {
    throw FileError(0, file_opening::notOpened("cannot be read; check its permissions"));
  }
  const std::string problem = text_encoding::encodingProblem(text);
  if (!problem.empty()) throw FileError(0, problem);
  return std::string(text_encoding::withoutMark(text));
}

bool hasLine(std::string_view text, std::string_view start) {
  return text.starts_with(start) || text.find("\n" + std::string(start)) != std::string_view::npos;
}

FileCameras readFile(const fs::path& file, const WantedCameras& wanted) {
  const std::string text = readText(file);
  if (hasLine(text, "K_0")) return kittiRawCameras(text, wanted.kitti_left, wanted.count);
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const bool is_xml = begin != std::string::npos && text[begin] == '<';
  const Node tree = is_xml ? parseXml(text) : parseYaml(text);
  FileCameras cameras = camerasIn(tree);
  if (wanted.count == 2) checkPair(tree, cameras);
  return cameras;
}

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

/// A size that is missing in the file is that of the images; a given size must equal it.
void checkCamera(FileCamera& found, const WantedCameras& wanted) {
  RawCamera& camera = found.camera;
  if (camera.width == 0) {
    camera.width = wanted.width;
    camera.height = wanted.height;
  }
  const bool other = camera.width != wanted.width || camera.height != wanted.height;
  if (other && wanted.width > 0) {
    throw FileError(found.size_line,
                    "is the calibration of images of " + sizeText(camera.width, camera.height) +
                        " px, but they have " + sizeText(wanted.width, wanted.height) +
                        "; give the calibration of these images");
  }
  const Pinhole& K = camera.pinhole;
  if (!(K.fx > 0 && K.fy > 0 && K.fx < 1e6 && K.fy < 1e6)) {  // px; a larger number is damage
    throw FileError(found.pinhole_line, "focal lengths must be positive, in pixels; correct them");
  }
  const bool inside = K.cx > 0 && K.cy > 0 && K.cx < camera.width && K.cy < camera.height;
  if (!inside && camera.width > 0) {
    throw FileError(found.pinhole_line, "the principal point is outside of the image of " +
                                            sizeText(camera.width, camera.height) +
                                            " px; give the calibration of these images");
  }
}

/// Sets the rectified cameras of the calibration, if it has them for all cameras.
void prescribe(const std::vector<FileCamera>& cameras, RawRig& rig) {
  const FileCamera& left = cameras.front();
  const bool alone = cameras.size() == 1 && left.rectified_width == 0;
  for (const FileCamera& camera : cameras) {
    if (!camera.P_rectified || alone) return;
  }
  const Projection& P = *left.P_rectified;
  CameraRig& rectified = rig.rectified;
  rectified.width = left.rectified_width > 0 ? left.rectified_width : left.camera.width;
  rectified.height = left.rectified_width > 0 ? left.rectified_height : left.camera.height;
  rectified.calibrated = true;
  rectified.pinhole = source_parameters::pinholeOf(P);
  rig.has_rectified = true;
  if (cameras.size() == 1) return;
  const FileCamera& right = cameras[1];
  const Projection& Q = *right.P_rectified;
  if (!(P.leftCols<3>() - Q.leftCols<3>()).isZero(1e-3)) {  // px; digits that files print
    throw FileError(right.rectified_line,
                    "the two rectified cameras have different focal lengths or centres; calibrate "
                    "them as a pair");
  }
  const Eigen::Vector3d to_right = source_parameters::offsetOf(P) - source_parameters::offsetOf(Q);
  rectified.baseline = to_right.x();
  if (rectified.baseline < 1e-3) {
    throw FileError(right.rectified_line,
                    "the right camera is not to the right of the left one; exchange the two");
  }
  if (!source_parameters::isBeside(to_right)) {
    throw FileError(right.rectified_line,
                    "the rectified right camera is " + shortNumber(to_right.y()) + " m below and " +
                        shortNumber(to_right.z()) +
                        " m before the left one; correct the fourth numbers of its rows");
  }
}

void placePair(std::vector<FileCamera>& cameras,
               const std::optional<Eigen::Isometry3d>& T_second_first, const RawRig& rig) {
  if (T_second_first) {
    cameras[0].camera.T_reference_camera.setIdentity();
    cameras[1].camera.T_reference_camera = T_second_first->inverse();
  } else if (!(cameras[0].has_pose && cameras[1].has_pose) && !rig.has_rectified) {
    throw FileError(cameras[1].line,
                    "says not where the right camera is; add its pose (Kalibr: T_cn_cnm1, EuRoC: "
                    "T_BS, OpenCV: the file with R and T), or use one camera");
  }
}

}  // namespace

Result<RawRig> readCameras(const std::vector<fs::path>& files, const WantedCameras& wanted) {
  std::vector<FileCamera> cameras;
  std::optional<Eigen::Isometry3d> T_second_first;
  fs::path file;
  const auto count = static_cast<std::size_t>(wanted.count);
  try {
    for (const fs::path& next : files) {
      file = next;
      FileCameras found = readFile(file, wanted);
      if (found.T_second_first) T_second_first = found.T_second_first;
      for (FileCamera& camera : found.cameras) {
        if (cameras.size() == count) break;
        checkCamera(camera, wanted);
        cameras.push_back(std::move(camera));
      }
    }
    if (cameras.size() < count || count == 0) {
      throw FileError(0, "has " + std::to_string(cameras.size()) + " cameras instead of " +
                             std::to_string(count) +
                             "; name the file of the right camera too, or use one camera");
    }
    RawRig rig;
    prescribe(cameras, rig);
    if (count == 2) placePair(cameras, T_second_first, rig);
    for (FileCamera& camera : cameras) rig.cameras.push_back(camera.camera);
    return rig;
  } catch (const FileError& error) {
    const std::string line = error.line > 0 ? ":" + std::to_string(error.line) : "";
    return Status::invalidInput(file.string() + line + ": " + error.what());
  }
}

bool isRawCalibration(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".yaml" || extension == ".yml" || extension == ".xml") return true;
  try {
    return hasLine(readText(file), "K_0");
  } catch (const FileError&) {
    return false;
  }
}

}  // namespace tolman::camera_files
