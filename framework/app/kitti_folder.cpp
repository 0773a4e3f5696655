// SPDX-License-Identifier: BSD-3-Clause
#include "app/kitti_folder.hpp"

#include <oneapi/tbb/parallel_invoke.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <string_view>
#include <system_error>

#include "app/png_encoder.hpp"
#include "record/atomic_file.hpp"
#include "record/pose_files.hpp"

namespace tolman::app {
namespace fs = std::filesystem;

namespace {

constexpr std::array kImageFolders = {"image_0", "image_1", "image_2", "image_3", "depth_0"};
constexpr std::array kTextFiles = {"times.txt", "calib.txt", "poses.txt", "loops.txt"};
constexpr const char* kPartial = ".partial";

/// "000042.png"
std::string imageName(std::int64_t index) {
  const std::string digits = std::to_string(index);
  return std::string(digits.size() < 6 ? 6 - digits.size() : 0, '0') + digits + ".png";
}

Status writeFailure(const fs::path& file) {
  const std::string reason = std::generic_category().message(errno);
  return Status::failed(file.string() + ": cannot be written (" + reason +
                        "); look for a full disk and missing permissions");
}

/// Under a temporary name first. Not synced to the disk: ten thousand syncs take minutes, and an
/// image that a power cut spoils is found by `tolman dataset check`.
Status writeWhole(const fs::path& file, const std::string& bytes) {
  const fs::path partial = file.parent_path() / ("." + file.filename().string() + kPartial);
  errno = 0;
  std::ofstream stream(partial, std::ios::binary);
  stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream.close();
  std::error_code failure;
  if (stream) {
    fs::rename(partial, file, failure);
    if (!failure) return Status::ok();
    errno = failure.value();
  }
  const Status status = writeFailure(file);
  fs::remove(partial, failure);
  return status;
}

/// What writeFrame() makes: digits and ".png", or a temporary file of that.
bool isOurs(const fs::path& file) {
  std::string name = file.filename().string();
  if (name.starts_with('.') && name.ends_with(kPartial)) {
    name = name.substr(1, name.size() - 1 - std::string_view(kPartial).size());
  }
  return name.size() >= 10 && name.ends_with(".png") &&
         name.find_first_not_of("0123456789") == name.size() - 4;
}

void removeEarlier(const fs::path& folder) {
  std::error_code ignored;
  for (const char* name : kTextFiles) fs::remove(folder / name, ignored);
  for (const char* name : kImageFolders) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder / name, ignored)) {
      if (isOurs(entry.path())) files.push_back(entry.path());
    }
    for (const fs::path& file : files) fs::remove(file, ignored);
    fs::remove(folder / name, ignored);  // unless there is more in it
  }
}

std::string projectionText(const CameraRig& rig, double baseline_m) {
  const Pinhole& K = rig.pinhole;
  const std::array<double, 12> rows = {K.fx, 0, K.cx, -K.fx * baseline_m, 0, K.fy, K.cy, 0, 0,
                                       0,    1, 0};
  std::string text;
  for (const double value : rows) text += " " + record::numberText(value);
  return text;
}

const NamedArray* depthOf(const Frame& frame) {
  const auto found = std::find_if(frame.sensors.begin(), frame.sensors.end(),
                                  [](const NamedArray& a) { return a.name == "depth.left"; });
  return found == frame.sensors.end() ? nullptr : &*found;
}

Status firstFailure(std::initializer_list<Status> all) {
  for (const Status& status : all) {
    if (!status.isOk()) return status;
  }
  return Status::ok();
}

}  // namespace

std::string calibrationText(const CameraRig& rig) {
  std::string text;
  for (const char camera : {'0', '1', '2', '3'}) {
    const bool right = camera == '1' || camera == '3';
    text += std::string("P") + camera + ":" + projectionText(rig, right ? rig.baseline : 0) + "\n";
  }
  return text;
}

std::string timesText(const std::vector<std::int64_t>& stamps_ns) {
  constexpr std::int64_t kSecond = 1'000'000'000;
  std::string text;
  for (const std::int64_t stamp : stamps_ns) {
    const std::string decimals = std::to_string(kSecond + std::abs(stamp % kSecond)).substr(1);
    text += (stamp < 0 ? "-" : "") + std::to_string(std::abs(stamp / kSecond)) + "." + decimals;
    text += "\n";
  }
  return text;
}

Result<KittiFolder> KittiFolder::create(const fs::path& folder, bool replace) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (!fs::is_directory(folder)) {
    return Status::failed(folder.string() +
                          ": is no folder and cannot be made one; choose another "
                          "--out");
  }
  if (!fs::is_empty(folder, failure) && !replace) {
    return Status::failed(folder.string() +
                          ": is not empty; choose another --out, or give --force to replace what "
                          "an earlier rendering left there");
  }
  if (replace) removeEarlier(folder);
  return KittiFolder(folder);
}

Status KittiFolder::writeImage(const char* name, std::int64_t index,
                               const Result<std::string>& png) const {
  if (!png.isOk()) return png.status();
  std::error_code failure;
  fs::create_directory(folder_ / name, failure);
  return writeWhole(folder_ / name / imageName(index), png.value());
}

Status KittiFolder::writeFrame(std::int64_t index, const Frame& frame, bool depth) const {
  const bool colour = frame.left.format() == PixelFormat::Bgr8;
  Status left;
  Status right;
  Status far;
  tbb::parallel_invoke(
      [&] { left = writeImage(colour ? "image_2" : "image_0", index, encodePng(frame.left)); },
      [&] {
        if (frame.right.empty()) return;
        right = writeImage(colour ? "image_3" : "image_1", index, encodePng(frame.right));
      },
      [&] {
        const NamedArray* map = depth ? depthOf(frame) : nullptr;
        if (map != nullptr) far = writeImage("depth_0", index, encodeDepthPng(*map));
      });
  return firstFailure({left, right, far});
}

Status KittiFolder::writeTexts(const CameraRig& rig, const DriveLog& log,
                               const std::vector<evaluation::Revisit>& revisits) const {
  if (log.hasTruth()) {
    std::vector<record::StampedPose> poses;
    for (const auto& pose : log.truth) {
      poses.push_back({pose.frame, pose.stamp_ns, pose.T_world_camera});
    }
    const Result<std::string> text = record::kittiText(poses);
    if (!text.isOk()) return text.status();
    const Status status =
        firstFailure({record::writeAtomically(folder_ / "poses.txt", text.value()),
                      record::writeAtomically(folder_ / "loops.txt", loopsText(revisits))});
    if (!status.isOk()) return status;
  }
  return firstFailure({record::writeAtomically(folder_ / "calib.txt", calibrationText(rig)),
                       record::writeAtomically(folder_ / "times.txt", timesText(log.stamps_ns))});
}

}  // namespace tolman::app
