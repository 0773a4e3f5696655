// SPDX-License-Identifier: BSD-3-Clause
#include "image_dataset.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <utility>

#include "base/text_file.hpp"
#include "coded_image.hpp"
#include "data_error.hpp"
#include "depth_array.hpp"
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

void setStamps(const fs::path& file, ImageTimes times, ImageDataset& dataset,
               FindingCollector& findings) {
  auto& [stamps_ns, exposure_ms] = times;
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
  if (!exposure_ms.empty()) exposure_ms.resize(common);
  dataset.stamps_ns = std::move(stamps_ns);
  dataset.exposure_ms = std::move(exposure_ms);
  dataset.stamps_file = file;
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
  filter(dataset.exposure_ms);
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
    const std::string origin =
        dataset.stamps_file.empty()
            ? ""
            : ": time " + std::to_string(i + 1) + " of " + dataset.stamps_file.string();
    addContradiction(findings, dataset.left[i],
                     "has a time no later than the image before" + origin,
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
  return text + (dataset.T_world_left.empty() ? "" : ", with truth");
}

namespace {

constexpr const char* kDepth = "depth.left";
constexpr const char* kExposure = "exposure.left";

std::string pixelsText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height) + " pixels";
}

}  // namespace

Status FolderSource::configure(const Context& context) {
  dataset_ = {};
  sequence_ = {};
  is_orientation_reported_ = false;
  findings_ = &context.findings;
  next_frame_ = 0;
  try {
    ready_ = prepare(context);
  } catch (const source_parameters::DataError& error) {
    ready_ = error.status();
  }
  return ready_;
}

Status FolderSource::prepare(const Context& context) {
  Status status = load(context, parameters_, dataset_);
  if (!status.isOk()) return status;
  used_bits_ = source_parameters::UsedBits(parameters_.bits);
  leaveOutUnusable(dataset_, *findings_);
  Result<FrameSequence> sequence = FrameSequence::make(parameters_, dataset_.stamps_ns);
  if (sequence.isOk()) sequence_ = std::move(sequence).value();
  return sequence.status();
}

Status FolderSource::rawRig(RawRig& rig) {
  if (!ready_.isOk()) return ready_;
  rig = dataset_.raw;
  return Status::ok();
}

Status FolderSource::describe(std::vector<ArrayInfo>& arrays) const {
  if (!dataset_.exposure_ms.empty()) {
    ArrayInfo& exposure = arrays.emplace_back();
    exposure.name = kExposure;
    exposure.unit = "ms";
    exposure.doc = "exposure time of the image";
    exposure.axes.resize(1);
  }
  if (dataset_.depth.empty()) return Status::ok();
  arrays.push_back(source_parameters::depthArray(
      kDepth, "measured depth of the image along the optical axis; 0 where it was not measured"));
  return Status::ok();
}

Status FolderSource::reset() {
  next_frame_ = 0;
  return ready_;
}

Status FolderSource::info(SourceInfo& info) {
  if (!ready_.isOk()) return ready_;
  info.description = descriptionOf(dataset_, sequence_.size());
  info.rig = dataset_.rig;
  info.frames = sequence_.size();
  info.has_truth = !dataset_.T_world_left.empty();
  return Status::ok();
}

Status FolderSource::next(Frame& frame) {
  if (!ready_.isOk()) return ready_;
  if (next_frame_ >= sequence_.size()) return Status::endOfStream();
  frame.frame = next_frame_++;  // also after a failure, so that a caller can skip the frame
  frame.stamp_ns = sequence_.stampNs(frame.frame);
  frame.source_index = sequence_.sourceIndex(frame.frame);
  const auto index = static_cast<std::size_t>(frame.source_index);
  if (!dataset_.T_world_left.empty()) {
    // The world is the left camera at frame 0 of this run, not of the data set.
    const auto origin = static_cast<std::size_t>(sequence_.sourceIndex(0));
    frame.has_truth = true;
    frame.T_world_camera_truth =
        dataset_.T_world_left[origin].inverse() * dataset_.T_world_left[index];
  }
  return readFrame(index, frame);
}

/// Of a damaged image both images of the pair are left out: one alone would look like a single
/// camera.
Status FolderSource::readFrame(std::size_t index, Frame& frame) {
  const auto leaveOut = [&](const std::filesystem::path& file, const Status& status) {
    const std::string defect = file.string() + ": " + status.message();
    if (status.code() != StatusCode::InvalidInput) return Status(status.code(), defect);
    findings_->add({Finding::Severity::Error, file.string(), status.message(),
                    "copy or record it again", Finding::Kind::Damaged});
    frame.left = frame.right = {};
    frame.defect = defect;
    return Status::ok();
  };
  frame.sensors.clear();
  if (!dataset_.exposure_ms.empty()) {
    frame.sensors.push_back({kExposure, {1}, {dataset_.exposure_ms[index]}});
  }
  if (!dataset_.depth.empty()) {
    const auto pixels = static_cast<std::size_t>(dataset_.rig.width) *
                        static_cast<std::size_t>(dataset_.rig.height);
    frame.sensors.push_back(
        {kDepth, {dataset_.rig.height, dataset_.rig.width}, std::vector<float>(pixels)});
    const Status status = readDepth(dataset_.depth[index], frame.sensors.back());
    if (!status.isOk()) return leaveOut(dataset_.depth[index], status);
  }
  Result<Image> left = readImage(dataset_.left[index]);
  if (!left.isOk()) return leaveOut(dataset_.left[index], left.status());
  frame.left = std::move(left).value();
  if (dataset_.photometric.isNeeded()) frame.left = dataset_.photometric.apply(frame.left);
  if (dataset_.right.empty()) return Status::ok();
  Result<Image> right = readImage(dataset_.right[index]);
  if (!right.isOk()) return leaveOut(dataset_.right[index], right.status());
  frame.right = std::move(right).value();
  return Status::ok();
}

Result<Image> FolderSource::readImage(const std::filesystem::path& file) {
  const Result<std::vector<std::uint8_t>> bytes = readBytes(file);
  if (!bytes.isOk()) return bytes.status();
  Result<Image> image = coded_images::decodeImage(bytes.value(), parameters_.colour, used_bits_);
  if (!image.isOk()) return image;
  const int width = image.value().width();
  const int height = image.value().height();
  if (width != dataset_.rig.width || height != dataset_.rig.height) {
    return Status::invalidInput("has " + pixelsText(width, height) + ", but the first image has " +
                                pixelsText(dataset_.rig.width, dataset_.rig.height));
  }
  if (auto finding = used_bits_.endImage(file.string())) findings_->add(*std::move(finding));
  if (!is_orientation_reported_ && coded_images::orientationOf(bytes.value()) != 1) {
    is_orientation_reported_ = true;
    findings_->add({Finding::Severity::Warning, file.string(),
                    "is stored turned or mirrored (EXIF orientation), and the pixels are used as "
                    "stored",
                    "if the calibration is of upright images, turn the files, such as with "
                    "`exiftran -ai` or `jpegtran`"});
  }
  return image;
}

Status FolderSource::readDepth(const std::filesystem::path& file, NamedArray& depth) const {
  const Result<coded_images::DepthValues> read = readDepthFile(file);
  if (!read.isOk()) return read.status();
  const auto& [width, height, values] = read.value();
  if (width != dataset_.rig.width || height != dataset_.rig.height) {
    return Status::invalidInput("has " + pixelsText(width, height) + ", but the images have " +
                                pixelsText(dataset_.rig.width, dataset_.rig.height));
  }
  const double per_m = dataset_.depth_per_m;
  std::ranges::transform(values, depth.values.begin(),
                         [&](std::uint16_t value) { return static_cast<float>(value / per_m); });
  return Status::ok();
}

}  // namespace tolman::image_folders
