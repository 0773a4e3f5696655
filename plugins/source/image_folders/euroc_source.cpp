// SPDX-License-Identifier: BSD-3-Clause
#include "euroc_source.hpp"

#include <filesystem>
#include <optional>

#include "image_listing.hpp"
#include "named_times.hpp"
#include "stated_rate.hpp"
#include "text_file.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

/// The images of one camera with their stamps.
struct Camera {
  std::vector<fs::path> images;
  std::vector<std::int64_t> stamps_ns;
};

fs::path firstFolder(std::initializer_list<fs::path> candidates) {
  std::error_code ignored;
  for (const fs::path& folder : candidates) {
    if (fs::is_directory(folder, ignored)) return folder;
  }
  return {};
}

/// data.csv: stamp in ns and name of each image.
Camera readTable(const fs::path& table, const fs::path& images, Inspection& inspection) {
  Camera camera;
  for (const TextLine& line : readLines(table, inspection)) {
    const auto fields = splitFields(line.text);
    const auto ns = fields.size() == 2 ? parseSeconds(fields[0], digitsOf(TimeUnit::Nanoseconds))
                                       : std::nullopt;
    const bool plain = ns && fields[0].find_first_of(".eE") == std::string_view::npos &&
                       fields[1].find('/') == std::string_view::npos;
    if (!plain) {
      inspection.error(
          table, line.number,
          "is not of the form 'nanoseconds,image', with whole nanoseconds; correct it");
    } else if (!camera.stamps_ns.empty() && *ns <= camera.stamps_ns.back()) {
      inspection.error(table, line.number, "is no later than the line before; sort the file");
    } else {
      camera.stamps_ns.push_back(*ns);
      camera.images.push_back(images / fields[1]);
    }
  }
  checkNamedTimes(table, camera.images, camera.stamps_ns, TimeUnit::Nanoseconds, inspection);
  return camera;
}

Camera readImages(const fs::path& folder, Inspection& inspection) {
  const fs::path images = firstFolder({folder / "data", folder / "images"});
  if (images.empty()) {
    inspection.error(folder, "has neither data nor images; set path to the folder above cam0");
    return {};
  }
  const fs::path table = folder / "data.csv";
  std::error_code ignored;
  if (fs::exists(table, ignored)) return readTable(table, images, inspection);
  Camera camera;
  camera.images = findImages(images, inspection);
  camera.stamps_ns = sortByTimes(camera.images, TimeUnit::Nanoseconds, inspection);
  return camera;
}

Camera readCamera(const fs::path& folder, Inspection& inspection) {
  Camera camera = readImages(folder, inspection);
  if (!inspection.hasErrors()) {
    checkStatedRate(folder / "sensor.yaml", camera.stamps_ns, inspection);
  }
  return camera;
}

/// Keeps the images that both cameras took at the same time.
void pair(const fs::path& root, Camera left, Camera right, ImageDataset& dataset,
          Inspection& inspection) {
  const auto partners = nearestTimes(left.stamps_ns, right.stamps_ns, 0);
  for (std::size_t i = 0; i < partners.size(); ++i) {
    if (partners[i] < 0) continue;
    dataset.left.push_back(left.images[i]);
    dataset.right.push_back(right.images[static_cast<std::size_t>(partners[i])]);
    dataset.stamps_ns.push_back(left.stamps_ns[i]);
  }
  const std::size_t lonely = left.images.size() + right.images.size() - 2 * dataset.left.size();
  if (dataset.left.empty()) {
    inspection.error(root, "has no two images of one time; restore cam1, or set mono: true");
  } else if (lonely > 0) {
    inspection.warning(
        root, std::to_string(lonely) + " images have no partner of the same time and are left out");
  }
}

std::vector<fs::path> calibrationFiles(const EurocSource::Parameters& p, const fs::path& root) {
  if (!p.calibration.empty()) return {p.calibration};
  const fs::path chain = root / "camchain.yaml";
  std::error_code ignored;
  if (!fs::exists(root / "cam0/sensor.yaml", ignored)) return {chain};
  if (p.mono) return {root / "cam0/sensor.yaml"};
  return {root / "cam0/sensor.yaml", root / "cam1/sensor.yaml"};
}

}  // namespace

Status EurocSource::load(const ParameterValues& values, FolderParameters& shared,
                         ImageDataset& dataset, Inspection& inspection) {
  const Result<Parameters> bound = bindParameters<Parameters>(values);
  if (!bound.isOk()) return bound.status();
  const Parameters& p = bound.value();
  shared = p;
  dataset.layout = "EuRoC";
  const fs::path root = firstFolder({fs::path(p.path) / "mav0", p.path});
  std::error_code ignored;
  if (root.empty() || !fs::is_directory(root / "cam0", ignored)) {
    inspection.error(p.path, "has no cam0; set path to the folder with mav0, or with cam0");
    return Status::ok();
  }
  Camera left = readCamera(root / "cam0", inspection);
  if (p.mono || !fs::is_directory(root / "cam1", ignored)) {
    dataset.left = std::move(left.images);
    dataset.stamps_ns = std::move(left.stamps_ns);
  } else {
    pair(root, std::move(left), readCamera(root / "cam1", inspection), dataset, inspection);
  }
  findImageSize(dataset, inspection);
  readRawCameras(calibrationFiles(p, root), 0, dataset, inspection);
  return Status::ok();
}

}  // namespace tolman::image_folders
