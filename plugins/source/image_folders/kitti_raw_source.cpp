// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_raw_source.hpp"

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "dates.hpp"
#include "text_file.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

fs::path cameraFolder(const fs::path& root, int camera) {
  return root / ("image_0" + std::to_string(camera));
}

fs::path calibrationFile(const KittiRawSource::Parameters& p) {
  if (!p.calibration.empty()) return p.calibration;
  constexpr const char* kName = "calib_cam_to_cam.txt";
  const fs::path root = fs::path(p.path) / "";
  std::error_code ignored;
  const fs::path above = root.parent_path().parent_path() / kName;
  return !fs::exists(root / kName, ignored) && fs::exists(above, ignored) ? above : root / kName;
}

void readStamps(const KittiRawSource::Parameters& p, const fs::path& folder, ImageDataset& dataset,
                Inspection& inspection) {
  const fs::path file = folder / "timestamps.txt";
  std::error_code ignored;
  if (fs::exists(file, ignored)) {
    dataset.stamps_ns = readDates(file, inspection);
    checkCount(file, dataset.stamps_ns.size(), dataset.left.size(), inspection);
  } else if (p.rate > 0) {
    dataset.stamps_ns = uniformStamps(dataset.left.size(), p.rate);
  } else {
    inspection.error(file, "is missing; restore it, or set rate to the frames a second");
  }
}

/// Warns where the right images are of other times than the left ones of the same name. Times of
/// the right camera are not needed, so those that are damaged or missing are no problem.
void checkRightTimes(const fs::path& file, const std::vector<std::int64_t>& left,
                     Inspection& inspection) {
  std::error_code ignored;
  if (left.size() < 2 || !fs::exists(file, ignored)) return;
  Inspection of_right;
  const std::vector<std::int64_t> right = readDates(file, of_right);
  if (of_right.hasErrors() || right.size() != left.size()) return;
  // Half a frame: another image would be nearer. The cameras of the drives are triggered together.
  const std::int64_t limit = (left.back() - left.front()) / (2 * (std::ssize(left) - 1));
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::int64_t apart = right[i] - left[i];
    if (std::abs(apart) <= limit) continue;
    inspection.warning(file, "puts right image " + std::to_string(i) + " " +
                                 fixed(static_cast<double>(std::abs(apart)) * 1e-9, 3) + " s " +
                                 (apart < 0 ? "before" : "behind") +
                                 " the left one, more than half a frame; are the images of one "
                                 "drive? Then correct the times, otherwise set mono: true");
    return;
  }
}

/// Drives with the suffix `sync` are rectified already: of the size of the rectified images.
void useRectified(ImageDataset& dataset) {
  CameraRig& rig = dataset.rig;
  rig = dataset.raw.rectified;
  dataset.raw = {};
}

}  // namespace

Status KittiRawSource::load(const ParameterValues& values, FolderParameters& shared,
                            ImageDataset& dataset, Inspection& inspection) {
  const Result<Parameters> bound = bindParameters<Parameters>(values);
  if (!bound.isOk()) return bound.status();
  const Parameters& p = bound.value();
  shared = p;
  dataset.layout = "KITTI raw";
  const fs::path root = p.path;
  std::error_code ignored;
  const int preferred = p.colour ? 2 : 0;
  const int left =
      fs::is_directory(cameraFolder(root, preferred) / "data", ignored) ? preferred : 2 - preferred;
  const fs::path folder = cameraFolder(root, left);
  if (!fs::is_directory(folder / "data", ignored)) {
    inspection.error(root, "has neither image_00/data nor image_02/data; set path to a drive");
    return Status::ok();
  }
  const fs::path right = cameraFolder(root, left + 1) / "data";
  const bool stereo = !p.mono && fs::is_directory(right, ignored);
  readFolders(folder / "data", stereo ? right : fs::path(), std::nullopt, dataset, inspection);
  readStamps(p, folder, dataset, inspection);
  const fs::path right_times = right.parent_path() / "timestamps.txt";
  if (stereo && !inspection.hasErrors())
    checkRightTimes(right_times, dataset.stamps_ns, inspection);
  const ImageSize size = dataset.size();
  dataset.rig.width = 0;  // of raw or of rectified images
  dataset.rig.height = 0;
  readRawCameras({calibrationFile(p)}, left, dataset, inspection);
  dataset.rig.width = size.width;
  dataset.rig.height = size.height;
  if (dataset.raw.cameras.empty()) return Status::ok();
  const CameraRig& rectified = dataset.raw.rectified;
  const RawCamera& camera = dataset.raw.cameras.front();
  if (dataset.raw.has_rectified && size == ImageSize{rectified.width, rectified.height}) {
    useRectified(dataset);
  } else if (size != ImageSize{camera.width, camera.height}) {
    inspection.error(calibrationFile(p),
                     "is of images of another size than those of the drive; give the "
                     "calibration of its day");
  }
  return Status::ok();
}

}  // namespace tolman::image_folders
