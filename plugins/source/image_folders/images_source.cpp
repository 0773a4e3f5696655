// SPDX-License-Identifier: BSD-3-Clause
#include "images_source.hpp"

#include <filesystem>
#include <optional>

#include "calibration.hpp"
#include "camera_files.hpp"
#include "named_times.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

using Parameters = ImagesSource::Parameters;

fs::path leftFolder(const Parameters& p) {
  const fs::path root = p.path;
  if (!p.left.empty()) return root / p.left;
  std::error_code ignored;
  return fs::is_directory(root / "images", ignored) ? root / "images" : root;
}

/// Contradictions between parameters.
Status checkCombination(const Parameters& p) {
  if (!p.calibration.empty() && (p.fx > 0 || p.baseline > 0)) {
    return Status::invalidParameter("calibration and fx or baseline are both given; keep one");
  }
  if (p.right.empty() && p.baseline > 0) {
    return Status::invalidParameter("baseline is given without right; name the right folder");
  }
  if (!p.right.empty() && p.calibration.empty() && (p.fx == 0 || p.baseline == 0)) {
    return Status::invalidParameter(
        "two cameras need a calibration; give the file, or fx and baseline");
  }
  if (!p.calibration_right.empty() && p.calibration.empty()) {
    return Status::invalidParameter("calibration_right is given without calibration; name both");
  }
  if (p.stamps_in_names && !p.stamps.empty()) {
    return Status::invalidParameter("stamps and stamps_in_names are both given; keep one");
  }
  if (!p.stamps_column.empty() && p.stamps.empty()) {
    return Status::invalidParameter("stamps_column is given without stamps; name the file");
  }
  return Status::ok();
}

void setRig(const Parameters& p, CameraRig& rig) {
  if (!p.isGiven()) return;
  rig.calibrated = true;
  rig.pinhole = p.pinhole(rig.width, rig.height);
  rig.baseline = p.baseline;
}

void readRig(const Parameters& p, ImageDataset& dataset, Inspection& inspection) {
  CameraRig& rig = dataset.rig;
  if (p.calibration.empty()) {
    setRig(p, rig);
    if (rig.calibrated) checkPrincipalPoint("cx, cy", rig, inspection);
    return;
  }
  const fs::path file = fs::path(p.path) / p.calibration;
  if (camera_files::isRawCalibration(file) || !p.calibration_right.empty()) {
    std::vector<fs::path> files = {file};
    if (!p.calibration_right.empty()) files.push_back(fs::path(p.path) / p.calibration_right);
    readRawCameras(files, 0, dataset, inspection);
    return;
  }
  const auto calibration = readKittiCalibration(file, 0, !p.right.empty(), inspection);
  if (!calibration) return;
  rig.calibrated = true;
  rig.pinhole = calibration->pinhole;
  rig.baseline = calibration->baseline;
  checkPrincipalPoint(file, rig, inspection);
}

void readStamps(const Parameters& p, ImageDataset& dataset, Inspection& inspection) {
  if (p.stamps_in_names) return;  // readFolders() has read them
  if (p.stamps.empty()) {
    dataset.stamps_ns = uniformStamps(dataset.left.size(), p.rate);
    return;
  }
  const fs::path file = fs::path(p.path) / p.stamps;
  dataset.stamps_ns = readTimes(file, p.stamps_column, inspection, p.stamps_unit);
  checkCount(file, dataset.stamps_ns.size(), dataset.left.size(), inspection);
  if (inspection.hasErrors()) return;
  if (!p.stamps_column.empty()) checkNamedRows(file, p.path, dataset.left, inspection);
  checkNamedTimes(file, dataset.left, dataset.stamps_ns, p.stamps_unit, inspection);
}

}  // namespace

Status ImagesSource::load(const ParameterValues& values, FolderParameters& shared,
                          ImageDataset& dataset, Inspection& inspection) {
  const Result<Parameters> bound = bindParameters<Parameters>(values);
  if (!bound.isOk()) return bound.status();
  const Parameters& p = bound.value();
  shared = p;
  if (Status status = checkCombination(p); !status.isOk()) return status;
  dataset.layout = "images";
  const fs::path right = p.right.empty() ? fs::path() : fs::path(p.path) / p.right;
  const auto times_in_names = p.stamps_in_names ? std::optional(p.stamps_unit) : std::nullopt;
  readFolders(leftFolder(p), right, times_in_names, dataset, inspection);
  readRig(p, dataset, inspection);
  readStamps(p, dataset, inspection);
  return Status::ok();
}

}  // namespace tolman::image_folders
