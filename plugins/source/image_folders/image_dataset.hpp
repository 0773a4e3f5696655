// SPDX-License-Identifier: BSD-3-Clause
// A data set of image files, calibration, stamps (ns) and true poses (m), after its folders and
// text files were read. Shared by all sources of image files.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image_file.hpp"
#include "inspection.hpp"
#include "times_and_poses.hpp"
#include "tolman/camera.hpp"

namespace tolman::image_folders {

/// Unless reading had errors, all lists have one entry for each image of the left camera.
struct ImageDataset {
  std::string layout;  ///< for messages: "KITTI odometry"
  std::vector<std::filesystem::path> left;
  std::vector<std::filesystem::path> right;  ///< empty for a single camera
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_left;  ///< truth, of the left camera; or empty
  std::vector<std::filesystem::path> depth;     ///< of the left camera, 16 bits; or empty
  double depth_per_m = 0;                       ///< values of a depth image per metre
  CameraRig rig;
  RawRig raw;  ///< for unrectified images; otherwise without cameras

  ImageSize size() const { return {rig.width, rig.height}; }
};

/// Fills left and, unless `right_folder` is empty, right, and the image size of the rig. The names
/// of the left images are in the order of listImages(), or, with `times_in_names`, times in this
/// unit, which are filled in; images of the right camera go with those of the same name.
void readFolders(const std::filesystem::path& left_folder,
                 const std::filesystem::path& right_folder, std::optional<TimeUnit> times_in_names,
                 ImageDataset& dataset, Inspection& inspection);

/// Fills the image size of the rig: that of the first image whose header is sound.
void findImageSize(ImageDataset& dataset, Inspection& inspection);

/// Stamps of a camera with `rate` images a second.
std::vector<std::int64_t> uniformStamps(std::size_t count, double rate);

/// Adds an error in `file` unless the principal point is in the image.
void checkPrincipalPoint(const std::filesystem::path& file, const CameraRig& rig,
                         Inspection& inspection);

/// For each time the index of the nearest of `others`, at most `apart_ns` away, otherwise -1. Both
/// lists must increase. For sensors that are exposed at different times.
std::vector<std::ptrdiff_t> nearestTimes(const std::vector<std::int64_t>& times,
                                         const std::vector<std::int64_t>& others,
                                         std::int64_t apart_ns);

/// Removes the frames whose entry in `keep` is false from all lists.
void keepFrames(const std::vector<bool>& keep, ImageDataset& dataset);

/// Reads raw cameras for the images that were found. A failure is added as an error.
void readRawCameras(const std::vector<std::filesystem::path>& files, int kitti_left,
                    ImageDataset& dataset, Inspection& inspection);

/// "KITTI odometry, 51 stereo pairs of 1226x370 px at 9.7 Hz, baseline 0.537 m, with truth";
/// `frames` of them are used.
std::string descriptionOf(const ImageDataset& dataset, std::int64_t frames);

/// An error finding for each image or depth file that is damaged or of another size, and a warning
/// of turned images, see ImageWarnings; only the first depth file is decoded.
void checkImageFiles(const ImageDataset& dataset, std::vector<Finding>& findings);

/// Decodes the first left images if they have 16 bits, and warns if they use fewer than `bits`.
void checkUsedBits(const ImageDataset& dataset, int bits, std::vector<Finding>& findings);

}  // namespace tolman::image_folders
