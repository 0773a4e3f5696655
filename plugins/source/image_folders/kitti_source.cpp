// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_source.hpp"

#include <filesystem>
#include <optional>

#include "calibration.hpp"
#include "times_and_poses.hpp"
#include "true_speeds.hpp"
#include "tum_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

using KittiParameters = KittiSource::Parameters;

fs::path imageFolder(const fs::path& root, int camera) {
  return root / ("image_" + std::to_string(camera));
}

/// Number of the left camera: 0 of the grey pair, 2 of the colour pair, -1 if there is neither.
int leftCamera(const KittiParameters& p) {
  const fs::path root = p.path;
  std::error_code ignored;
  for (const int camera : {p.colour ? 2 : 0, p.colour ? 0 : 2}) {
    if (fs::is_directory(imageFolder(root, camera), ignored)) return camera;
  }
  return -1;
}

void readCalibration(const fs::path& file, int left, bool stereo, ImageDataset& dataset,
                     Eigen::Vector3d& t_left_camera0, Inspection& inspection) {
  const auto calibration = readKittiCalibration(file, left, stereo, inspection);
  if (!calibration) return;
  dataset.rig.calibrated = true;
  dataset.rig.pinhole = calibration->pinhole;
  dataset.rig.baseline = calibration->baseline;
  t_left_camera0 = calibration->t_left_camera0;
  checkPrincipalPoint(file, dataset.rig, inspection);
}

/// Also of a link that leads nowhere: reading it then names it, instead of going without it.
bool isThere(const fs::path& file) {
  std::error_code ignored;
  return fs::symlink_status(file, ignored).type() != fs::file_type::not_found;
}

void readStamps(const KittiParameters& p, ImageDataset& dataset, Inspection& inspection) {
  const fs::path file = fs::path(p.path) / "times.txt";
  if (!isThere(file)) {
    if (p.rate > 0) {
      dataset.stamps_ns = uniformStamps(dataset.left.size(), p.rate);
    } else {
      inspection.error(file, "is missing; restore it, or set rate to the frames a second");
    }
    return;
  }
  dataset.stamps_ns = readTimes(file, "", inspection);
  checkCount(file, dataset.stamps_ns.size(), dataset.left.size(), inspection);
}

/// The file of poses: from the parameter, in the folder of the sequence, or in the folders of the
/// benchmark.
fs::path posesFile(const KittiParameters& p) {
  if (!p.poses.empty()) return p.poses;
  const fs::path root = fs::path(p.path) / "";
  const fs::path sequence = root.parent_path();
  const fs::path benchmark =
      sequence.parent_path().parent_path() / "poses" / (sequence.filename().string() + ".txt");
  for (const fs::path& file : {sequence / "poses.txt", benchmark}) {
    if (isThere(file)) return file;
  }
  return {};
}

void readTruth(const KittiParameters& p, const Eigen::Vector3d& t_left_camera0,
               ImageDataset& dataset, Inspection& inspection) {
  const fs::path file = posesFile(p);
  if (file.empty()) return;
  StampedPoses truth;
  truth.T_world_camera = readKittiPoses(file, inspection, &truth.lines);
  checkCount(file, truth.T_world_camera.size(), dataset.left.size(), inspection);
  truth.stamps_ns = dataset.stamps_ns;
  if (!inspection.hasErrors()) checkTrueSpeeds(file, truth, inspection);
  dataset.T_world_left = std::move(truth.T_world_camera);
  const Eigen::Translation3d T_camera0_left(-t_left_camera0);
  for (Eigen::Isometry3d& T : dataset.T_world_left) T = T * T_camera0_left;
}

}  // namespace

Status KittiSource::load(const ParameterValues& values, FolderParameters& shared,
                         ImageDataset& dataset, Inspection& inspection) {
  const Result<Parameters> bound = bindParameters<Parameters>(values);
  if (!bound.isOk()) return bound.status();
  const Parameters& p = bound.value();
  shared = p;
  dataset.layout = "KITTI odometry";
  const fs::path root = p.path;
  std::error_code ignored;
  if (!fs::is_directory(root, ignored)) {
    inspection.error(root, "is no folder; set path to a sequence, such as .../sequences/06");
    return Status::ok();
  }
  const int left = leftCamera(p);
  if (left < 0) {
    inspection.error(root,
                     "has neither image_0 nor image_2; set path to a sequence, such as "
                     ".../sequences/06, or take the source of another layout (`tolman init` finds "
                     "it)");
    return Status::ok();
  }
  const fs::path right_folder = imageFolder(root, left + 1);
  const bool stereo = !p.mono && fs::is_directory(right_folder, ignored);
  readFolders(imageFolder(root, left), stereo ? right_folder : fs::path(), std::nullopt, dataset,
              inspection);
  Eigen::Vector3d t_left_camera0 = Eigen::Vector3d::Zero();
  readCalibration(root / "calib.txt", left, stereo, dataset, t_left_camera0, inspection);
  readStamps(p, dataset, inspection);
  readTruth(p, t_left_camera0, dataset, inspection);
  return Status::ok();
}

}  // namespace tolman::image_folders
