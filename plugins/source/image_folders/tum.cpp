// SPDX-License-Identifier: BSD-3-Clause
// `tum`: rgb.txt, depth.txt, groundtruth.txt and the folders that they list.
#include <algorithm>

#include "data_error.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

// Largest difference in time between an image and its depth or its true pose, as the benchmark's
// own script has it.
constexpr std::int64_t kApartNs = 20'000'000;

/// Images without depth are left out, because every frame must have each sensor.
void addDepth(const TumParameters& p, const fs::path& list, ImageDataset& dataset,
              FindingCollector& findings) {
  const StampedFiles depth = readStampedFiles(list, TimeUnit::Seconds, p.path, findings);
  dataset.depth_per_m = p.depth_scale;
  std::vector<bool> keep;
  for (const auto partner : nearestTimes(dataset.stamps_ns, depth.stamps_ns, kApartNs)) {
    keep.push_back(partner >= 0);
    dataset.depth.push_back(partner < 0 ? fs::path()
                                        : depth.files[static_cast<std::size_t>(partner)]);
  }
  const auto lonely = std::ranges::count(keep, false);
  if (lonely == 0) return;
  if (lonely == std::ssize(keep)) {
    throw DataError(list,
                    "has no time within 20 ms of that of a colour image; correct or remove it");
  }
  findings.add({Finding::Severity::Warning, list.string(),
                "has no depth near the time of " + std::to_string(lonely) +
                    " colour images, which are left out",
                "restore the depth images"});
  keepFrames(keep, dataset);
}

/// Poses of the camera at the times of the images, interpolated between the measured ones. A
/// damaged truth is an error in `findings`, and the run can go on without it.
void addTruth(const fs::path& file, ImageDataset& dataset, FindingCollector& findings) {
  const auto reject = [&](std::string where, std::string message, Finding::Severity severity) {
    findings.add({severity, std::move(where), std::move(message),
                  "correct the true poses, or remove the file", Finding::Kind::Contradiction});
  };
  try {
    const StampedPoses truth = readTumPoses(file);
    std::vector<Eigen::Isometry3d> poses;
    for (const std::int64_t stamp : dataset.stamps_ns) {
      if (const auto pose = poseAt(truth, stamp, kApartNs)) poses.push_back(*pose);
    }
    const std::size_t images = dataset.stamps_ns.size();
    if (poses.size() == images) {
      dataset.T_world_left = std::move(poses);
      return;
    }
    reject(file.string(),
           "has no pose near the time of " + std::to_string(images - poses.size()) + " of " +
               std::to_string(images) + " images, so the run has no true poses",
           poses.empty() ? Finding::Severity::Error : Finding::Severity::Warning);
  } catch (const DataError& error) {
    reject("truth", error.what(), Finding::Severity::Error);
  }
}

}  // namespace

void read(const TumParameters& p, ImageDataset& dataset, FindingCollector& findings) {
  dataset.layout = "TUM RGB-D";
  const fs::path root = p.path;
  StampedFiles colour = readStampedFiles(root / "rgb.txt", TimeUnit::Seconds, root, findings);
  dataset.left = std::move(colour.files);
  dataset.stamps_ns = std::move(colour.stamps_ns);
  std::error_code ignored;
  if (fs::exists(root / "depth.txt", ignored)) addDepth(p, root / "depth.txt", dataset, findings);
  setImageSize(dataset);
  if (fs::exists(root / "groundtruth.txt", ignored)) {
    addTruth(root / "groundtruth.txt", dataset, findings);
  }
  const CameraRig& size = dataset.rig;
  if (p.isRaw()) {
    dataset.raw.cameras = {
        source_parameters::valueOf(source_parameters::rawCamera(p, size.width, size.height))};
  } else {
    dataset.rig = source_parameters::valueOf(p.rig(size.width, size.height));
  }
}

}  // namespace tolman::image_folders
