// SPDX-License-Identifier: BSD-3-Clause
#include "camera_files.hpp"

#include "base/text_file.hpp"
#include "calibration_cameras.hpp"
#include "data_error.hpp"
#include "image_size.hpp"

namespace tolman::camera_files {
namespace fs = std::filesystem;
using source_parameters::DataError;
using source_parameters::ImageSize;
using text_encoding::rounded;

namespace {

std::string textOf(const fs::path& file) {
  return source_parameters::valueOf(text_encoding::readText(file, std::uintmax_t{1} << 20U));
}

bool isKittiRaw(std::string_view text) {
  return text.starts_with("K_0") || text.find("\nK_0") != std::string_view::npos;
}

FileCameras readFile(const fs::path& file, const WantedCameras& wanted) {
  const std::string text = textOf(file);
  try {
    if (isKittiRaw(text)) return kittiRawCameras(text, wanted.kitti_left);
    if (isLineCalibration(text)) return lineCameras(text);
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string::npos) throw FileError(0, "is empty; restore it");
    return camerasIn(text[begin] == '<' ? parseXml(text) : parseYaml(text));
  } catch (const FileError& error) {
    throw DataError(file, error.line, error.what());
  }
}

/// Why `K` cannot be that of images of this size (0: of any); empty if it can.
std::string problemOf(const Pinhole& K, int width, int height) {
  if (!(K.fx > 0 && K.fy > 0 && K.fx < 1e6 && K.fy < 1e6)) {  // px
    return "the focal lengths are not positive numbers of pixels; correct them";
  }
  const bool is_inside = K.cx > 0 && K.cy > 0 && K.cx < width && K.cy < height;
  if (is_inside || width == 0) return "";
  return "the principal point (" + rounded(K.cx) + ", " + rounded(K.cy) +
         ") is outside of the image of " + ImageSize{width, height}.text() +
         "; give the calibration of these images";
}

/// A size that is missing in the file is that of the images; a given size must equal it.
void checkCamera(const fs::path& file, FileCamera& found, const WantedCameras& wanted) {
  RawCamera& camera = found.camera;
  if (camera.width == 0) {
    camera.width = wanted.width;
    camera.height = wanted.height;
  }
  const bool is_other = camera.width != wanted.width || camera.height != wanted.height;
  if (is_other && wanted.width > 0) {
    throw DataError(file, found.line,
                    "is the calibration of images of " +
                        ImageSize{camera.width, camera.height}.text() + ", but they have " +
                        ImageSize{wanted.width, wanted.height}.text() +
                        "; give the calibration of these images");
  }
  const std::string problem = problemOf(camera.pinhole, camera.width, camera.height);
  if (!problem.empty()) throw DataError(file, found.line, problem);
}

/// The rig of two rectified cameras, or of one if the right one is null. The size is not set.
CameraRig rectifiedRig(const fs::path& file, const Projection& left, const Projection* right) {
  constexpr double kLongest = 5;      // m, of a baseline
  constexpr double kShortest = 1e-3;  // m
  CameraRig rig;
  rig.calibrated = true;
  rig.pinhole = source_parameters::pinholeOf(left);
  if (right == nullptr) return rig;
  if (!(left.leftCols<3>() - right->leftCols<3>()).isZero(1e-3)) {  // px; digits that files print
    throw DataError(file,
                    "has rectified cameras of different focal lengths or centres; calibrate them "
                    "as a pair");
  }
  const Eigen::Vector3d t = source_parameters::offsetOf(left) - source_parameters::offsetOf(*right);
  rig.baseline = t.x();
  if (!(rig.baseline >= kShortest && rig.baseline <= kLongest)) {
    throw DataError(file, "has a baseline of " + rounded(rig.baseline) +
                              " m, which must be 1 mm to 5 m: the fourth number of the right "
                              "matrix is -fx times it, in px m. For a negative one exchange the "
                              "cameras, or correct the sign");
  }
  if (source_parameters::isBeside(t)) return rig;
  throw DataError(file, "has a right camera " + rounded(t.y()) + " m below and " + rounded(t.z()) +
                            " m before the left one, so the images are not rectified; correct the "
                            "fourth numbers, or rectify the images");
}

/// Sets the rectified cameras of the calibration, if it has them for all cameras.
void prescribe(const fs::path& file, const std::vector<FileCamera>& cameras, RawRig& rig) {
  const FileCamera& left = cameras.front();
  const bool alone = cameras.size() == 1 && left.rectified_width == 0;
  for (const FileCamera& camera : cameras) {
    if (!camera.P_rectified || alone) return;
  }
  rig.rectified = rectifiedRig(file, *left.P_rectified,
                               cameras.size() == 1 ? nullptr : &*cameras[1].P_rectified);
  rig.rectified.width = left.rectified_width > 0 ? left.rectified_width : left.camera.width;
  rig.rectified.height = left.rectified_width > 0 ? left.rectified_height : left.camera.height;
  rig.has_rectified = true;
}

}  // namespace

RawRig readCameras(const std::vector<fs::path>& files, const WantedCameras& wanted) {
  std::vector<FileCamera> cameras;
  std::optional<Eigen::Isometry3d> T_second_first;
  const auto count = static_cast<std::size_t>(wanted.count);
  for (const fs::path& file : files) {
    FileCameras found = readFile(file, wanted);
    if (found.T_second_first) T_second_first = found.T_second_first;
    for (FileCamera& camera : found.cameras) {
      if (cameras.size() == count) break;
      checkCamera(file, camera, wanted);
      cameras.push_back(std::move(camera));
    }
  }
  const fs::path& file = files.back();
  if (cameras.size() < count) {
    throw DataError(file, "has " + std::to_string(cameras.size()) + " cameras instead of " +
                              std::to_string(count) +
                              "; name the file of the right camera too, or use one camera");
  }
  RawRig rig;
  prescribe(file, cameras, rig);
  if (count == 2 && T_second_first) {
    cameras[0].camera.T_reference_camera.setIdentity();
    cameras[1].camera.T_reference_camera = T_second_first->inverse();
  } else if (count == 2 && !(cameras[0].has_pose && cameras[1].has_pose) && !rig.has_rectified) {
    throw DataError(file, cameras[1].line,
                    "does not state where the right camera is; add its pose (Kalibr: T_cn_cnm1, "
                    "EuRoC: T_BS, OpenCV: the file with R and T), or use one camera");
  }
  for (FileCamera& camera : cameras) rig.cameras.push_back(camera.camera);
  return rig;
}

RectifiedCameras readRectified(const fs::path& file, const WantedCameras& wanted) {
  const std::string text = textOf(file);
  std::vector<Projection> P;
  try {
    P = kittiProjections(text, wanted.kitti_left, wanted.count == 2);
  } catch (const FileError& error) {
    throw DataError(file, error.line, error.what());
  }
  RectifiedCameras cameras{rectifiedRig(file, P[0], P.size() == 2 ? &P[1] : nullptr),
                           source_parameters::offsetOf(P[0])};
  cameras.rig.width = wanted.width;
  cameras.rig.height = wanted.height;
  const std::string problem = problemOf(cameras.rig.pinhole, wanted.width, wanted.height);
  if (!problem.empty()) throw DataError(file, problem);
  return cameras;
}

bool isRawCalibration(const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".yaml" || extension == ".yml" || extension == ".xml" || extension == ".json") {
    return true;
  }
  const Result<std::string> text = text_encoding::readText(file);
  return text.isOk() && (isKittiRaw(text.value()) || isLineCalibration(text.value()));
}

}  // namespace tolman::camera_files
