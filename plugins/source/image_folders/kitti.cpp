// SPDX-License-Identifier: BSD-3-Clause
// `kitti`: image_0/NNNNNN.png and image_1, calib.txt (P0, P1), times.txt, poses.txt.
#include "data_error.hpp"
#include "image_file.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

fs::path imageFolder(const fs::path& root, int camera) {
  return root / ("image_" + std::to_string(camera));
}

/// Number of the left camera: 0 of the grey pair, 2 of the colour pair. Throws DataError.
int leftCamera(const KittiParameters& p) {
  const fs::path root = p.path;
  std::error_code ignored;
  for (const int camera : {p.colour ? 2 : 0, p.colour ? 0 : 2}) {
    if (fs::is_directory(imageFolder(root, camera), ignored)) return camera;
  }
  throw DataError(
      root,
      "has neither image_0 nor image_2; set path to a sequence, such as "
      ".../sequences/06, or take the source of another layout (`tolman init` finds it)");
}

/// Also of a link that leads nowhere: reading it then names it, instead of going without it.
bool isThere(const fs::path& file) {
  std::error_code ignored;
  return fs::symlink_status(file, ignored).type() != fs::file_type::not_found;
}

std::vector<std::int64_t> readStamps(const KittiParameters& p, const fs::path& file,
                                     std::size_t images) {
  if (isThere(file)) return readTimes(file, "", TimeUnit::Seconds).stamps_ns;
  if (p.rate > 0) return uniformStamps(images, p.rate);
  throw DataError(file, "is missing; restore it, or set rate to the frames a second");
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

/// A damaged truth is an error in `findings`, and the run can go on without it.
void readTruth(const fs::path& file, const Eigen::Vector3d& t_left_camera0, ImageDataset& dataset,
               FindingCollector& findings) {
  const auto reject = [&](std::string where, std::string message) {
    findings.add({Finding::Severity::Error, std::move(where), std::move(message),
                  "correct the true poses, or remove the file", Finding::Kind::Contradiction});
  };
  try {
    std::vector<Eigen::Isometry3d> poses = readKittiPoses(file);
    if (poses.size() != dataset.left.size()) {
      return reject(file.string(), "has " + std::to_string(poses.size()) +
                                       " poses, but there are " +
                                       std::to_string(dataset.left.size()) + " images");
    }
    const Eigen::Translation3d T_camera0_left(-t_left_camera0);
    for (Eigen::Isometry3d& T : poses) T = T * T_camera0_left;
    dataset.T_world_left = std::move(poses);
  } catch (const DataError& error) {
    reject("truth", error.what());
  }
}

}  // namespace

void read(const KittiParameters& p, ImageDataset& dataset, FindingCollector& findings) {
  dataset.layout = "KITTI odometry";
  const fs::path root = p.path;
  const int left = leftCamera(p);
  dataset.left = numberedImages(imageFolder(root, left));
  const fs::path right_folder = imageFolder(root, left + 1);
  std::error_code ignored;
  if (!p.mono && fs::is_directory(right_folder, ignored)) {
    findPartners(right_folder, dataset, findings);
  }
  setImageSize(dataset);
  const auto calibration = camera_files::readRectified(root / "calib.txt", dataset.wanted(left));
  dataset.rig = calibration.rig;
  const fs::path times = root / "times.txt";
  setStamps(times, {readStamps(p, times, dataset.left.size()), {}}, dataset, findings);
  const fs::path poses = posesFile(p);
  if (!poses.empty()) readTruth(poses, calibration.t_left_camera0, dataset, findings);
}

}  // namespace tolman::image_folders
