// SPDX-License-Identifier: BSD-3-Clause
#include "image_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "camera_files.hpp"
#include "image_listing.hpp"
#include "image_warnings.hpp"
#include "text_file.hpp"
#include "used_bits.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;

namespace {

std::string pixels(ImageSize size) {
  return std::to_string(size.width) + "x" + std::to_string(size.height);
}

/// A failure whose message begins with the file.
void addError(const fs::path& file, const Status& failure, std::vector<Finding>& findings) {
  findings.push_back({Finding::Severity::Error, file.string(),
                      failure.message().substr(file.string().size() + 2)});
}

/// An error if a file that checkImage() has accepted holds no depths.
void checkDepth(const fs::path& file, ImageSize expected, std::vector<Finding>& findings) {
  const Result<ImageHeader> header = checkImageFile(file);
  if (!header.isOk() || header.value().size != expected) return;
  const Status depth = readDepthFile(file, expected).status();
  if (!depth.isOk()) addError(file, depth, findings);
}

void checkImage(const fs::path& file, ImageSize expected, ImageWarnings& warnings,
                std::vector<Finding>& findings) {
  const Result<ImageHeader> header = checkImageFile(file);
  if (!header.isOk()) {
    addError(file, header.status(), findings);
    return;
  }
  if (header.value().size != expected) {
    findings.push_back({Finding::Severity::Error, file.string(),
                        "has " + pixels(header.value().size) + " pixels, but the first image has " +
                            pixels(expected) + "; all must be of one size"});
  }
  if (auto warning = warnings.ofOrientation(header.value().orientation)) {
    findings.push_back({Finding::Severity::Warning, file.string(), std::move(*warning)});
  }
}

}  // namespace

/// Damaged images are skipped here; they are handled by on_corrupt.
void findImageSize(ImageDataset& dataset, Inspection& inspection) {
  Status first;
  for (const fs::path& file : dataset.left) {
    const Result<ImageHeader> header = checkImageFile(file);
    if (first.isOk()) first = header.status();
    if (!header.isOk()) continue;
    dataset.rig.width = header.value().size.width;
    dataset.rig.height = header.value().size.height;
    return;
  }
  if (dataset.left.empty()) return;  // listImages() has added an error
  // The remedy of a single image, on_corrupt: skip, is none here.
  const std::string message = first.message().substr(0, first.message().find("; copy or record"));
  inspection.error(dataset.left.front().parent_path(),
                   "none of its " + std::to_string(dataset.left.size()) +
                       " images can be read, as " + message + "; copy or record them again");
}

void readFolders(const fs::path& left_folder, const fs::path& right_folder,
                 std::optional<TimeUnit> times_in_names, ImageDataset& dataset,
                 Inspection& inspection) {
  if (times_in_names) {
    dataset.left = findImages(left_folder, inspection);
    dataset.stamps_ns = sortByTimes(dataset.left, *times_in_names, inspection);
  } else {
    dataset.left = listImages(left_folder, inspection);
  }
  if (!right_folder.empty()) dataset.right = listPartners(dataset.left, right_folder, inspection);
  findImageSize(dataset, inspection);
}

std::vector<std::int64_t> uniformStamps(std::size_t count, double rate) {
  std::vector<std::int64_t> stamps(count);
  for (std::size_t i = 0; i < count; ++i) {
    stamps[i] = std::llround(static_cast<double>(i) * 1e9 / rate);
  }
  return stamps;
}

void checkPrincipalPoint(const fs::path& file, const CameraRig& rig, Inspection& inspection) {
  const Pinhole& K = rig.pinhole;
  const bool is_inside = K.cx > 0 && K.cx < rig.width && K.cy > 0 && K.cy < rig.height;
  if (rig.width == 0 || is_inside) return;
  inspection.error(file, "principal point (" + fixed(K.cx, 1) + ", " + fixed(K.cy, 1) +
                             ") is outside of the " + pixels({rig.width, rig.height}) +
                             " image; give the calibration of these images");
}

std::vector<std::ptrdiff_t> nearestTimes(const std::vector<std::int64_t>& times,
                                         const std::vector<std::int64_t>& others,
                                         std::int64_t apart_ns) {
  std::vector<std::ptrdiff_t> nearest;
  for (const std::int64_t time : times) {
    auto best = std::lower_bound(others.begin(), others.end(), time);
    if (best != others.begin() && (best == others.end() || time - best[-1] < *best - time)) --best;
    const bool found = best != others.end() && std::abs(*best - time) <= apart_ns;
    nearest.push_back(found ? best - others.begin() : -1);
  }
  return nearest;
}

void keepFrames(const std::vector<bool>& keep, ImageDataset& dataset) {
  const auto filter = [&](auto& list) {
    if (list.size() != keep.size()) return;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < keep.size(); ++i) {
      if (keep[i]) list[kept++] = list[i];
    }
    list.resize(kept);
  };
  filter(dataset.left);
  filter(dataset.right);
  filter(dataset.stamps_ns);
  filter(dataset.T_world_left);
  filter(dataset.depth);
}

void readRawCameras(const std::vector<fs::path>& files, int kitti_left, ImageDataset& dataset,
                    Inspection& inspection) {
  if (dataset.left.empty()) return;  // an error was added before
  const Result<RawRig> rig = camera_files::readCameras(
      files, {dataset.right.empty() ? 1 : 2, dataset.rig.width, dataset.rig.height, kitti_left});
  if (!rig.isOk()) {
    inspection.error(rig.status().message());
  } else {
    dataset.raw = rig.value();
  }
}

std::string descriptionOf(const ImageDataset& dataset, std::int64_t frames) {
  const bool stereo = dataset.rig.isStereo() || !dataset.right.empty();
  std::string text = dataset.layout + ", " + std::to_string(frames);
  if (frames != static_cast<std::int64_t>(dataset.left.size())) {
    text += " from " + std::to_string(dataset.left.size());
  }
  text += (stereo ? " stereo pairs of " : " images of one camera of ") + pixels(dataset.size());
  const std::vector<std::int64_t>& stamps = dataset.stamps_ns;
  if (stamps.size() > 1 && stamps.back() > stamps.front()) {
    const double seconds = static_cast<double>(stamps.back() - stamps.front()) * 1e-9;
    const double rate = static_cast<double>(stamps.size() - 1) / seconds;
    text += " px at " + fixed(rate, rate < 1 ? 4 : 1) + " Hz";
  }
  if (dataset.rig.isStereo()) text += ", baseline " + fixed(dataset.rig.baseline, 4) + " m";
  const bool raw = !dataset.raw.cameras.empty();
  if (!dataset.depth.empty()) text += ", with depth";
  if (!dataset.rig.calibrated) text += raw ? ", not rectified" : ", uncalibrated";
  return text + (dataset.T_world_left.empty() ? ", no truth" : ", with truth");
}

void checkImageFiles(const ImageDataset& dataset, std::vector<Finding>& findings) {
  for (const auto* files : {&dataset.left, &dataset.right, &dataset.depth}) {
    ImageWarnings warnings;
    for (const fs::path& file : *files) checkImage(file, dataset.size(), warnings, findings);
  }
  if (!dataset.depth.empty()) checkDepth(dataset.depth.front(), dataset.size(), findings);
}

void checkUsedBits(const ImageDataset& dataset, int bits, std::vector<Finding>& findings) {
  constexpr std::size_t kEach = source_parameters::UsedBits::kJudged;
  source_parameters::UsedBits used(bits);
  const std::size_t images = dataset.left.size();
  std::optional<std::string> warning;
  for (std::size_t i = 0; i < images && !warning; ++i) {
    if (i >= kEach && i + kEach < images) continue;  // the first and the last ones
    ImageNotes notes;
    notes.values.widths.emplace();
    const fs::path& file = dataset.left[i];
    if (!readImageFile(file, false, dataset.size(), bits, &notes).isOk()) continue;
    if (notes.values.largest < 0) return;
    used.add(*notes.values.widths);
    warning = used.warning(i + 1 == images, static_cast<std::int64_t>(i));
  }
  if (!warning) warning = used.warning(true, static_cast<std::int64_t>(images) - 1);
  if (!warning) return;
  findings.push_back({Finding::Severity::Warning, dataset.left.front().parent_path().string(),
                      std::move(*warning)});
}

}  // namespace tolman::image_folders
