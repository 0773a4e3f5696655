// SPDX-License-Identifier: BSD-3-Clause
#include "app/kitti_folder.hpp"

#include <fmt/format.h>
#include <png.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <system_error>

#include "record/atomic_file.hpp"
#include "record/export.hpp"

namespace tolman::app {
namespace fs = std::filesystem;

namespace {

constexpr std::array kOurs = {"image_0",   "image_1",   "image_2",   "image_3",  "depth_0",
                              "times.txt", "calib.txt", "poses.txt", "loops.txt"};

/// Marks a folder as a rendering. It is written first, because --force replaces only marked
/// folders.
constexpr const char* kMark = ".tolman-rendering";
constexpr const char* kMarkText =
    "`tolman dataset render` wrote this folder; --force may replace it.\n";

std::string imageName(std::int64_t index) { return fmt::format("{:06}.png", index); }

std::string projectionText(const CameraRig& rig, double baseline_m) {
  const Pinhole& K = rig.pinhole;
  const std::array<double, 12> rows = {K.fx, 0, K.cx, -K.fx * baseline_m, 0, K.fy, K.cy, 0, 0,
                                       0,    1, 0};
  std::string text;
  for (const double value : rows) text += " " + record::numberText(value);
  return text;
}

/// `stride`: components from row to row.
Result<std::string> encode(png_uint_32 format, int width, int height, const void* pixels,
                           int stride) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = format;
  image.flags = PNG_IMAGE_FLAG_FAST;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels, stride, nullptr) == 0) {
    return Status::failed(std::string("the image cannot be encoded as PNG: ") + image.message);
  }
  bytes.resize(size);
  return bytes;
}

std::uint16_t depthPixel(float metres) {
  const double steps = std::round(256.0 * static_cast<double>(metres));
  return steps >= 1 && steps <= 65535 ? static_cast<std::uint16_t>(steps) : std::uint16_t{0};
}

}  // namespace

Result<std::string> encodePng(const Image& image) {
  const bool is_grey = image.format() == PixelFormat::Gray8;
  return encode(is_grey ? PNG_FORMAT_GRAY : PNG_FORMAT_BGR, image.width(), image.height(),
                image.data(), static_cast<int>(image.stride()));
}

Result<std::string> encodeDepthPng(const NamedArray& depth) {
  const bool plane = depth.shape.size() == 2 && depth.shape[0] > 0 && depth.shape[1] > 0;
  if (!plane || depth.values.size() != static_cast<std::size_t>(depth.shape[0]) *
                                           static_cast<std::size_t>(depth.shape[1])) {
    return Status::invalidInput("'" + depth.name + "' has not the shape {height, width}");
  }
  std::vector<std::uint16_t> pixels;
  pixels.reserve(depth.values.size());
  for (const float metres : depth.values) pixels.push_back(depthPixel(metres));
  return encode(PNG_FORMAT_LINEAR_Y, depth.shape[1], depth.shape[0], pixels.data(), depth.shape[1]);
}

std::string depthArray(const std::vector<ArrayInfo>& arrays) {
  const auto depth = std::ranges::find(arrays, ArrayKind::DepthImage, &ArrayInfo::kind);
  return depth == arrays.end() ? "" : depth->name;
}

std::string calibrationText(const CameraRig& rig) {
  std::string text;
  for (const char camera : {'0', '1', '2', '3'}) {
    const bool right = camera == '1' || camera == '3';
    text += std::string("P") + camera + ":" + projectionText(rig, right ? rig.baseline : 0) + "\n";
  }
  return text;
}

std::string timesText(const std::vector<std::int64_t>& stamps_ns) {
  std::string text;
  for (const std::int64_t stamp_ns : stamps_ns) text += record::secondsText(stamp_ns) + "\n";
  return text;
}

Result<KittiFolder> KittiFolder::create(const fs::path& folder, bool replace) {
  const auto refuse = [&](const std::string& why) {
    return Status::failed(folder.string() + ": " + why);
  };
  std::error_code error;
  fs::create_directories(folder, error);
  if (!fs::is_directory(folder)) {
    return refuse("is not a folder and cannot be made; choose another --out");
  }
  const bool is_marked = fs::is_regular_file(folder / kMark, error);
  const bool is_empty = std::distance(fs::directory_iterator(folder, error), {}) == is_marked;
  if (!is_empty && !replace) {
    return refuse(
        "is not empty; choose another --out, or give --force to replace an earlier "
        "rendering");
  }
  if (!is_empty && !is_marked) {
    return refuse("holds no rendering of Tolman (it has no " + std::string(kMark) +
                  "), so --force does not replace it; choose another --out");
  }
  for (const char* name : kOurs) fs::remove_all(folder / name, error);
  const Status marked = record::writeAtomically(folder / kMark, kMarkText);
  if (!marked.isOk()) return marked;
  return KittiFolder(folder);
}

Status KittiFolder::writeImage(const char* name, std::int64_t index,
                               const Result<std::string>& png) const {
  if (!png.isOk()) return png.status();
  std::error_code failure;
  fs::create_directory(folder_ / name, failure);
  // Without sync: ten thousand syncs take minutes, and `tolman dataset check` finds an image that a
  // power cut has damaged.
  return record::writeAtomically(folder_ / name / imageName(index), png.value(), record::Sync::No);
}

Status requireDepth(const Frame& frame, const std::string& depth) {
  const auto map = std::ranges::find(frame.sensors, depth, &NamedArray::name);
  if (depth.empty() || map != frame.sensors.end()) return Status::ok();
  return Status::invalidInput("frame " + std::to_string(frame.frame) +
                              ": the source gives no sensor array '" + depth +
                              "'; leave out --depth");
}

Status KittiFolder::writeFrame(std::int64_t index, const Frame& frame,
                               const std::string& depth) const {
  const bool colour = frame.left.format() == PixelFormat::Bgr8;
  Status status = writeImage(colour ? "image_2" : "image_0", index, encodePng(frame.left));
  if (status.isOk() && !frame.right.empty()) {
    status = writeImage(colour ? "image_3" : "image_1", index, encodePng(frame.right));
  }
  if (!status.isOk() || depth.empty()) return status;
  if (Status missing = requireDepth(frame, depth); !missing.isOk()) return missing;
  const auto map = std::ranges::find(frame.sensors, depth, &NamedArray::name);
  return writeImage("depth_0", index, encodeDepthPng(*map));
}

Status KittiFolder::writeTexts(const CameraRig& rig, const std::vector<std::int64_t>& stamps_ns,
                               const evaluation::Trajectory& truth,
                               const std::vector<evaluation::Revisit>& revisits) const {
  std::vector<record::OutputFile> files;
  if (!stamps_ns.empty() && truth.size() == stamps_ns.size()) {
    files.push_back({folder_ / "poses.txt", record::kittiText(truth)});
    files.push_back({folder_ / "loops.txt", evaluation::loopsText(revisits)});
  }
  if (rig.calibrated) files.push_back({folder_ / "calib.txt", calibrationText(rig)});
  files.push_back({folder_ / "times.txt", timesText(stamps_ns)});
  return record::writeOutputs(files);
}

}  // namespace tolman::app
