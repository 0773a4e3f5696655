// SPDX-License-Identifier: BSD-3-Clause
#include "tum_source.hpp"

#include <algorithm>
#include <filesystem>

#include "named_times.hpp"
#include "text_file.hpp"
#include "true_speeds.hpp"
#include "tum_poses.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

struct StampedFiles {
  std::vector<std::int64_t> stamps_ns;
  std::vector<fs::path> files;
};

/// rgb.txt or depth.txt: time in s and file.
StampedFiles readList(const fs::path& root, const char* name, Inspection& inspection) {
  StampedFiles list;
  const fs::path file = root / name;
  for (const TextLine& line : readLines(file, inspection)) {
    const auto fields = splitFields(line.text);
    const auto ns = fields.size() == 2 ? parseSeconds(fields[0]) : std::nullopt;
    if (!ns || fields[1].find("..") != std::string_view::npos) {
      inspection.error(file, line.number, "is not of the form 'seconds file'; correct it");
    } else if (!list.stamps_ns.empty() && *ns <= list.stamps_ns.back()) {
      inspection.error(file, line.number, "is no later than the line before; sort the file");
    } else {
      list.stamps_ns.push_back(*ns);
      list.files.push_back(root / fields[1]);
    }
  }
  checkNamedTimes(file, list.files, list.stamps_ns, TimeUnit::Seconds, inspection);
  return list;
}

std::int64_t apart(const TumSource::Parameters& p) {
  return static_cast<std::int64_t>(p.most_apart * 1e9);
}

/// Frames without a depth image are left out, because every frame must have each sensor.
void addDepth(const TumSource::Parameters& p, ImageDataset& dataset, Inspection& inspection) {
  const fs::path root = p.path;
  const StampedFiles depth = readList(root, "depth.txt", inspection);
  if (depth.files.empty()) return;
  dataset.depth_per_m = p.depth_scale;
  const auto partners = nearestTimes(dataset.stamps_ns, depth.stamps_ns, apart(p));
  std::vector<bool> keep;
  for (const std::ptrdiff_t partner : partners) {
    keep.push_back(partner >= 0);
    dataset.depth.push_back(partner < 0 ? fs::path()
                                        : depth.files[static_cast<std::size_t>(partner)]);
  }
  const auto lonely = std::count(keep.begin(), keep.end(), false);
  if (lonely == 0) return;
  if (lonely == std::ssize(keep)) {
    inspection.error(root / "depth.txt",
                     "has no time near that of a colour image; set most_apart, or depth: false");
    return;
  }
  inspection.warning(root / "depth.txt", "has no depth near the time of " + std::to_string(lonely) +
                                             " colour images, which are left out");
  keepFrames(keep, dataset);
}

/// Poses of the camera at the times of the images, interpolated between the measured ones.
void addTruth(const TumSource::Parameters& p, ImageDataset& dataset, Inspection& inspection) {
  const fs::path file = fs::path(p.path) / "groundtruth.txt";
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const StampedPoses truth = readTumPoses(file, inspection);
  checkTrueSpeeds(file, truth, inspection);
  std::vector<Eigen::Isometry3d> poses;
  for (const std::int64_t stamp : dataset.stamps_ns) {
    if (const auto pose = poseAt(truth, stamp, apart(p))) poses.push_back(*pose);
  }
  if (poses.empty() && !truth.stamps_ns.empty() && !dataset.stamps_ns.empty()) {
    const bool covers = truth.stamps_ns.front() <= dataset.stamps_ns.back() &&
                        dataset.stamps_ns.front() <= truth.stamps_ns.back();
    inspection.error(file, covers ? "has no poses on both sides of the time of any image within " +
                                        fixed(p.most_apart, 3) +
                                        " s, although it is of the same time; set most_apart, or "
                                        "remove it to run without truth"
                                  : "has no pose near the time of any image, so it is of another "
                                    "recording; put back that of this one, or remove it to run "
                                    "without truth");
  }
  const std::size_t without = dataset.stamps_ns.size() - poses.size();
  if (without > 0 && !poses.empty()) {
    inspection.warning(file, "has no pose near the time of " + std::to_string(without) + " of " +
                                 std::to_string(dataset.stamps_ns.size()) +
                                 " images; the run has no true poses");
  }
  if (without > 0) return;
  dataset.T_world_left = std::move(poses);
}

}  // namespace

Status TumSource::load(const ParameterValues& values, FolderParameters& shared,
                       ImageDataset& dataset, Inspection& inspection) {
  const Result<Parameters> bound = bindParameters<Parameters>(values);
  if (!bound.isOk()) return bound.status();
  const Parameters& p = bound.value();
  shared = p;
  dataset.layout = "TUM RGB-D";
  StampedFiles colour = readList(p.path, "rgb.txt", inspection);
  dataset.left = std::move(colour.files);
  dataset.stamps_ns = std::move(colour.stamps_ns);
  if (dataset.left.empty()) return Status::ok();
  if (p.depth) addDepth(p, dataset, inspection);
  findImageSize(dataset, inspection);
  addTruth(p, dataset, inspection);
  dataset.rig.calibrated = true;
  dataset.rig.pinhole = {p.fx, p.fy, p.cx, p.cy};
  checkPrincipalPoint("cx, cy", dataset.rig, inspection);
  return Status::ok();
}

}  // namespace tolman::image_folders
