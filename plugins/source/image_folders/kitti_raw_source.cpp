// SPDX-License-Identifier: BSD-3-Clause
#include "kitti_raw_source.hpp"

#include <filesystem>
#include <optional>

#include "dates.hpp"
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
