// SPDX-License-Identifier: BSD-3-Clause
// `images`: any folder, or two (left, right), in natural order, with a calibration file.
#include "data_error.hpp"
#include "image_file.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

using P = ImagesParameters;

fs::path leftFolder(const P& p) {
  const fs::path root = p.path;
  if (!p.left.empty()) return root / p.left;
  std::error_code ignored;
  return fs::is_directory(root / "images", ignored) ? root / "images" : root;
}

/// Throws for parameters that contradict each other.
void checkCombination(const P& p) {
  const auto refuseIf = [](bool contradicts, const char* message) {
    if (contradicts) throw source_parameters::DataError(Status::invalidParameter(message));
  };
  refuseIf(!p.calibration.empty() && (p.isGiven() || p.baseline > 0),
           "calibration and pinhole or baseline are both given; keep one");
  refuseIf(p.right.empty() && p.baseline > 0,
           "baseline is given without right; name the right folder");
  refuseIf(!p.right.empty() && p.calibration.empty() && (!p.isGiven() || p.baseline == 0),
           "two cameras need a calibration; give the file, or pinhole and baseline");
  refuseIf(!p.calibration_right.empty() && p.calibration.empty(),
           "calibration_right is given without calibration; name both");
  refuseIf(p.stamps_in_names && (!p.stamps.empty() || !p.list.empty()),
           "stamps_in_names is given with stamps or list; keep one");
  refuseIf(!p.response.empty() && !p.right.empty(),
           "response is given for two cameras, but is of one; leave it out, or give one camera");
  refuseIf(!p.stamps_column.empty() && p.stamps.empty(),
           "stamps_column is given without stamps; name the file");
}

void readRig(const P& p, ImageDataset& dataset) {
  if (p.calibration.empty()) {
    dataset.rig = source_parameters::valueOf(p.rig(dataset.rig.width, dataset.rig.height));
    return;
  }
  const fs::path file = fs::path(p.path) / p.calibration;
  if (p.calibration_right.empty() && !camera_files::isRawCalibration(file)) {
    dataset.rig = camera_files::readRectified(file, dataset.wanted()).rig;
    return;
  }
  std::vector<fs::path> files = {file};
  if (!p.calibration_right.empty()) files.push_back(fs::path(p.path) / p.calibration_right);
  dataset.raw = camera_files::readCameras(files, dataset.wanted());
}

}  // namespace

void read(const P& p, ImageDataset& dataset, FindingCollector& findings) {
  checkCombination(p);
  dataset.layout = "images";
  const fs::path root = p.path;
  const fs::path folder = leftFolder(p);
  if (p.stamps_in_names) {
    StampedFiles sorted = sortedByTimes(findImages(folder), p.stamps_unit);
    dataset.left = std::move(sorted.files);
    dataset.stamps_ns = std::move(sorted.stamps_ns);
  } else {
    dataset.left = p.list.empty() ? numberedImages(folder) : listedImages(root / p.list, folder);
  }
  if (!p.right.empty()) findPartners(root / p.right, dataset, findings);
  setImageSize(dataset);
  readRig(p, dataset);
  if (!p.response.empty()) {
    dataset.photometric = {root / p.response, dataset.rig.width, dataset.rig.height};
  }
  if (p.stamps_in_names) return;
  if (p.stamps.empty()) {
    dataset.stamps_ns = uniformStamps(dataset.left.size(), p.rate);
    return;
  }
  const fs::path file = root / p.stamps;
  setStamps(file, readTimes(file, p.stamps_column, p.stamps_unit), dataset, findings);
}

}  // namespace tolman::image_folders
