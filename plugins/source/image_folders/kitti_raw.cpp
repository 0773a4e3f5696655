// SPDX-License-Identifier: BSD-3-Clause
// `kitti_raw`: a drive with image_00/data, image_01/data, timestamps.txt; its calibration beside
// it.
#include "data_error.hpp"
#include "image_file.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

fs::path cameraFolder(const fs::path& root, int camera) {
  return root / ("image_0" + std::to_string(camera));
}

fs::path calibrationOfDrive(const fs::path& path) {
  constexpr const char* kName = "calib_cam_to_cam.txt";
  const fs::path root = path / "";
  std::error_code ignored;
  const fs::path above = root.parent_path().parent_path() / kName;
  return !fs::exists(root / kName, ignored) && fs::exists(above, ignored) ? above : root / kName;
}

}  // namespace

void read(const KittiRawParameters& p, ImageDataset& dataset, FindingCollector& findings) {
  dataset.layout = "KITTI raw";
  const fs::path root = p.path;
  std::error_code ignored;
  const int preferred = p.colour ? 2 : 0;
  const int left =
      fs::is_directory(cameraFolder(root, preferred) / "data", ignored) ? preferred : 2 - preferred;
  const fs::path folder = cameraFolder(root, left);
  if (!fs::is_directory(folder / "data", ignored)) {
    throw DataError(root, "has neither image_00/data nor image_02/data; set path to a drive");
  }
  dataset.left = numberedImages(folder / "data");
  const fs::path right = cameraFolder(root, left + 1) / "data";
  if (!p.mono && fs::is_directory(right, ignored)) findPartners(right, dataset, findings);
  setImageSize(dataset);
  const fs::path times = folder / "timestamps.txt";
  if (fs::exists(times, ignored) || p.rate == 0) {
    setStamps(times, {readDates(times), {}}, dataset, findings);
  } else {
    dataset.stamps_ns = uniformStamps(dataset.left.size(), p.rate);
  }

  const fs::path file = calibrationOfDrive(root);
  camera_files::WantedCameras wanted = dataset.wanted(left);
  wanted.width = wanted.height = 0;  // of raw or of rectified images
  dataset.raw = camera_files::readCameras({file}, wanted);
  const auto isOfImages = [&](const auto& camera) {
    return camera.width == dataset.rig.width && camera.height == dataset.rig.height;
  };
  // Drives with the suffix `sync` have the size of the rectified images.
  if (dataset.raw.has_rectified && isOfImages(dataset.raw.rectified)) {
    dataset.rig = dataset.raw.rectified;
    dataset.raw = {};
  } else if (!isOfImages(dataset.raw.cameras.front())) {
    throw DataError(file,
                    "is the calibration of images of another size than those of the drive; give "
                    "that of its day");
  }
}

}  // namespace tolman::image_folders
