// SPDX-License-Identifier: BSD-3-Clause
#include "image_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>

#include "base/text_file.hpp"
#include "coded_image.hpp"
#include "data_error.hpp"
#include "image_file.hpp"

namespace tolman::image_folders {
namespace fs = std::filesystem;
using text_encoding::fixed;

namespace {

void addContradiction(FindingCollector& findings, const fs::path& where, std::string message,
                      std::string remedy) {
  findings.add({Finding::Severity::Error, where.string(), std::move(message), std::move(remedy),
                Finding::Kind::Contradiction});
}

/// Of at least two times, ns. Half of the steps are shorter.
std::int64_t medianStep(const std::vector<std::int64_t>& times) {
  std::vector<std::int64_t> steps(times.size() - 1);
  std::transform(times.begin() + 1, times.end(), times.begin(), steps.begin(), std::minus<>());
  const auto median = steps.begin() + std::ssize(steps) / 2;
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

/// No odometry can follow images that are 10 s apart, and few cameras take 10000 a second: such
/// times are milliseconds read as seconds, or microseconds read as nanoseconds.
void checkUnit(const ImageDataset& dataset, FindingCollector& findings) {
  constexpr std::int64_t kShortest_ns = 100'000;
  constexpr std::int64_t kLongest_ns = 10'000'000'000;
  if (dataset.stamps_ns.size() < 2) return;
  const std::int64_t step = medianStep(dataset.stamps_ns);
  if (step >= kShortest_ns && step <= kLongest_ns) return;
  addContradiction(findings, dataset.left.front().parent_path(),
                   "has images " + text_encoding::rounded(static_cast<double>(step) * 1e-9) +
                       " s apart (median), so the times are of another unit",
                   "convert them, or set stamps_unit (of `images`)");
}

}  // namespace

void findPartners(const fs::path& folder, ImageDataset& dataset, FindingCollector& findings) {
  std::map<std::string, fs::path> by_name;
  for (const fs::path& file : findImages(folder)) by_name.emplace(file.stem().string(), file);
  const auto report = [&](const fs::path& lonely) {
    addContradiction(findings, lonely, "has no partner of the same name from the other camera",
                     "restore the partner, or remove this one");
  };
  for (const fs::path& file : dataset.left) {
    const auto found = by_name.find(file.stem().string());
    dataset.right.push_back(found == by_name.end() ? fs::path() : found->second);
    if (found == by_name.end()) {
      report(file);
    } else {
      by_name.erase(found);
    }
  }
  for (const auto& [name, file] : by_name) report(file);
}

void setImageSize(ImageDataset& dataset) {
  Status first;
  for (const fs::path& file : dataset.left) {
    const auto bytes = readBytes(file);
    source_parameters::UsedBits bits;
    const Result<Image> image = bytes.isOk() ? coded_images::decodeImage(bytes.value(), false, bits)
                                             : Result<Image>(bytes.status());
    if (image.isOk()) {
      dataset.rig.width = image.value().width();
      dataset.rig.height = image.value().height();
      return;
    }
    if (first.isOk()) first = Status::invalidInput(file.string() + ": " + image.status().message());
  }
  throw source_parameters::DataError(Status::invalidInput(first.message() + ", and so are all " +
                                                          std::to_string(dataset.left.size()) +
                                                          " images; copy or record them again"));
}

std::vector<std::int64_t> uniformStamps(std::size_t count, double rate) {
  std::vector<std::int64_t> stamps(count);
  for (std::size_t i = 0; i < count; ++i) {
    stamps[i] = std::llround(static_cast<double>(i) * 1e9 / rate);
  }
  return stamps;
}

void setStamps(const fs::path& file, std::vector<std::int64_t> stamps_ns, ImageDataset& dataset,
               FindingCollector& findings) {
  const std::size_t images = dataset.left.size();
  const std::size_t common = std::min(images, stamps_ns.size());
  if (stamps_ns.size() != images) {
    addContradiction(findings, file,
                     "has " + std::to_string(stamps_ns.size()) + " times, but there are " +
                         std::to_string(images) + " images",
                     "restore the file, or the images");
  }
  stamps_ns.resize(common);
  dataset.left.resize(common);
  if (!dataset.right.empty()) dataset.right.resize(common);
  dataset.stamps_ns = std::move(stamps_ns);
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

void leaveOutUnusable(ImageDataset& dataset, FindingCollector& findings) {
  checkUnit(dataset, findings);
  std::vector<bool> keep;
  std::int64_t last = -1;
  for (std::size_t i = 0; i < dataset.left.size(); ++i) {
    const bool rises = dataset.stamps_ns[i] > last;
    if (rises) last = dataset.stamps_ns[i];
    keep.push_back(rises && (dataset.right.empty() || !dataset.right[i].empty()));
    if (rises) continue;
    addContradiction(findings, dataset.left[i], "has a time no later than the image before",
                     "sort the data, or correct the times");
  }
  keepFrames(keep, dataset);
}

std::string descriptionOf(const ImageDataset& dataset, std::int64_t frames) {
  std::string text = dataset.layout + ", " + std::to_string(frames);
  if (frames != static_cast<std::int64_t>(dataset.left.size())) {
    text += " from " + std::to_string(dataset.left.size());
  }
  text += dataset.right.empty() ? " images of one camera of " : " stereo pairs of ";
  text += std::to_string(dataset.rig.width) + "x" + std::to_string(dataset.rig.height) + " px";
  const std::vector<std::int64_t>& stamps = dataset.stamps_ns;
  if (stamps.size() > 1 && stamps.back() > stamps.front()) {
    const double seconds = static_cast<double>(stamps.back() - stamps.front()) * 1e-9;
    const double rate = static_cast<double>(stamps.size() - 1) / seconds;
    text += " at " + fixed(rate, rate < 1 ? 4 : 1) + " Hz";
  }
  if (dataset.rig.isStereo()) text += ", baseline " + fixed(dataset.rig.baseline, 4) + " m";
  if (!dataset.depth.empty()) text += ", with depth";
  if (!dataset.rig.calibrated) {
    text += dataset.raw.cameras.empty() ? ", uncalibrated" : ", not rectified";
  }
  return text + (dataset.T_world_left.empty() ? ", no truth" : ", with truth");
}

}  // namespace tolman::image_folders
