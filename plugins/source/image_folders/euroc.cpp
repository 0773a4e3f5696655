// SPDX-License-Identifier: BSD-3-Clause
// `euroc`: mav0/cam0 and cam1 of EuRoC and TUM-VI, each with data.csv, data and sensor.yaml.
#include "data_error.hpp"
#include "image_file.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

fs::path firstFolder(std::initializer_list<fs::path> candidates) {
  std::error_code ignored;
  for (const fs::path& folder : candidates) {
    if (fs::is_directory(folder, ignored)) return folder;
  }
  return {};
}

/// By data.csv, or without it by the names of the images, which are their times in ns.
StampedFiles readCamera(const fs::path& folder, FindingCollector& findings) {
  const fs::path images = firstFolder({folder / "data", folder / "images"});
  if (images.empty()) {
    throw DataError(folder, "has neither data nor images; set path to the folder above cam0");
  }
  const fs::path table = folder / "data.csv";
  std::error_code ignored;
  if (fs::exists(table, ignored)) {
    return readStampedFiles(table, TimeUnit::Nanoseconds, images, findings);
  }
  return sortedByTimes(findImages(images), TimeUnit::Nanoseconds);
}

/// Keeps the images that both cameras took at the same time.
void pairByTime(const fs::path& root, const StampedFiles& left, const StampedFiles& right,
                ImageDataset& dataset, FindingCollector& findings) {
  const auto partners = nearestTimes(left.stamps_ns, right.stamps_ns, 0);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] < 0) continue;
    dataset.left.push_back(left.files[i]);
    dataset.right.push_back(right.files[static_cast<std::size_t>(partners[i])]);
    dataset.stamps_ns.push_back(left.stamps_ns[i]);
  }
  if (dataset.left.empty()) {
    throw DataError(root, "has no two images of one time; restore cam1, or set mono: true");
  }
  const std::size_t lonely = left.files.size() + right.files.size() - 2 * dataset.left.size();
  if (lonely == 0) return;
  findings.add(
      {Finding::Severity::Warning, root.string(),
       std::to_string(lonely) + " images have no partner of the same time and are left out",
       "restore them, or set mono: true"});
}

std::vector<fs::path> calibrationFiles(const EurocParameters& p, const fs::path& root,
                                       bool is_pair) {
  if (!p.calibration.empty()) return {p.calibration};
  std::error_code ignored;
  if (!fs::exists(root / "cam0/sensor.yaml", ignored)) {
    const fs::path of_tumvi = fs::path(p.path) / "dso/camchain.yaml";  // beside its mav0
    return {fs::exists(of_tumvi, ignored) ? of_tumvi : root / "camchain.yaml"};
  }
  if (!is_pair) return {root / "cam0/sensor.yaml"};
  return {root / "cam0/sensor.yaml", root / "cam1/sensor.yaml"};
}

}  // namespace

void read(const EurocParameters& p, ImageDataset& dataset, FindingCollector& findings) {
  dataset.layout = "EuRoC";
  const fs::path root = firstFolder({fs::path(p.path) / "mav0", p.path});
  std::error_code ignored;
  if (root.empty() || !fs::is_directory(root / "cam0", ignored)) {
    throw DataError(p.path, "has no cam0; set path to the folder with mav0, or with cam0");
  }
  StampedFiles left = readCamera(root / "cam0", findings);
  if (p.mono || !fs::is_directory(root / "cam1", ignored)) {
    dataset.left = std::move(left.files);
    dataset.stamps_ns = std::move(left.stamps_ns);
  } else {
    pairByTime(root, left, readCamera(root / "cam1", findings), dataset, findings);
  }
  setImageSize(dataset);
  const auto files = calibrationFiles(p, root, !dataset.right.empty());
  dataset.raw = camera_files::readCameras(files, dataset.wanted());
}

}  // namespace tolman::image_folders
