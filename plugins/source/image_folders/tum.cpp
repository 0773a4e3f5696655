// SPDX-License-Identifier: BSD-3-Clause
// `tum`: rgb.txt, depth.txt and the folders that they list; the host reads groundtruth.txt.
#include <algorithm>

#include "data_error.hpp"
#include "layouts.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using source_parameters::DataError;

namespace {

// Largest difference in time between an image and its depth, as the benchmark's own script has it.
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
  const CameraRig& size = dataset.rig;
  if (p.isRaw()) {
    dataset.raw.cameras = {
        source_parameters::valueOf(source_parameters::rawCamera(p, size.width, size.height))};
  } else {
    dataset.rig = source_parameters::valueOf(p.rig(size.width, size.height));
  }
}

}  // namespace tolman::image_folders
