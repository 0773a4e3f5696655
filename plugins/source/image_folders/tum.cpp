// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "data_error.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

std::int64_t apartNs(const TumParameters& p) {
  return static_cast<std::int64_t>(p.most_apart * 1e9);
}

/// Images without depth are left out, because every frame must have each sensor.
void addDepth(const TumParameters& p, const fs::path& list, ImageDataset& dataset,
              FindingCollector& findings) {
  const StampedFiles depth = readStampedFiles(list, TimeUnit::Seconds, p.path, findings);
  dataset.depth_per_m = p.depth_scale;
  std::vector<bool> keep;
  for (const auto partner : nearestTimes(dataset.stamps_ns, depth.stamps_ns, apartNs(p))) {
    keep.push_back(partner >= 0);
    dataset.depth.push_back(partner < 0 ? fs::path()
                                        : depth.files[static_cast<std::size_t>(partner)]);
  }
  const auto lonely = std::ranges::count(keep, false);
  if (lonely == 0) return;
  if (lonely == std::ssize(keep)) {
    throw DataError(list, "has no time near that of a colour image; set most_apart, or remove it");
  }
  findings.add({Finding::Severity::Warning, list.string(),
                "has no depth near the time of " + std::to_string(lonely) +
                    " colour images, which are left out",
                "restore the depth images, or set most_apart"});
  keepFrames(keep, dataset);
}

/// Poses of the camera at the times of the images, interpolated between the measured ones. A
/// damaged truth is an error in `findings`, and the run can go on without it.
void addTruth(const TumParameters& p, const fs::path& file, ImageDataset& dataset,
              FindingCollector& findings) {
  const auto reject = [&](std::string where, std::string message, Finding::Severity severity) {
    findings.add({severity, std::move(where), std::move(message),
                  "set most_apart, correct the true poses, or remove the file",
                  Finding::Kind::Contradiction});
  };
  try {
    const StampedPoses truth = readTumPoses(file);
    std::vector<Eigen::Isometry3d> poses;
    for (const std::int64_t stamp : dataset.stamps_ns) {
      if (const auto pose = poseAt(truth, stamp, apartNs(p))) poses.push_back(*pose);
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
    addTruth(p, root / "groundtruth.txt", dataset, findings);
  }
  dataset.rig = source_parameters::valueOf(p.rig(dataset.rig.width, dataset.rig.height));
}

}  // namespace tolman::image_folders
