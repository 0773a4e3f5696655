// SPDX-License-Identifier: BSD-3-Clause
// A data set of image files, calibration, stamps (ns) and true poses (m), after its folders and
// text files were read. Shared by the sources `kitti` and `images`.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "image_file.hpp"
#include "inspection.hpp"
#include "tolman/camera.hpp"

namespace tolman::image_folders {

/// Lists run in parallel, one entry an image of the left camera; unless reading had errors.
struct ImageDataset {
  std::string layout;  ///< for messages: "KITTI odometry"
  std::vector<std::filesystem::path> left;
  std::vector<std::filesystem::path> right;  ///< empty for a single camera
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_left;  ///< truth, of the left camera; or empty
  CameraRig rig;

  ImageSize size() const { return {rig.width, rig.height}; }
};

/// Fills left and, unless `right_folder` is empty, right, and the image size of the rig.
void readFolders(const std::filesystem::path& left_folder,
                 const std::filesystem::path& right_folder, ImageDataset& dataset,
                 Inspection& inspection);

/// Stamps of a camera with `rate` images a second.
std::vector<std::int64_t> uniformStamps(std::size_t count, double rate);

/// An error in `file` unless the principal point lies in the image.
void checkPrincipalPoint(const std::filesystem::path& file, const CameraRig& rig,
                         Inspection& inspection);

/// "KITTI odometry, 51 stereo pairs of 1226x370 px at 9.7 Hz, baseline 0.537 m, with truth";
/// `frames` of them are used.
std::string describe(const ImageDataset& dataset, std::int64_t frames);

/// An error finding for each image file that is damaged or of another size; nothing is decoded.
void checkImageFiles(const ImageDataset& dataset, std::vector<Finding>& findings);

}  // namespace tolman::image_folders
