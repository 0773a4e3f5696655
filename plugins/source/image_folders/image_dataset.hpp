// SPDX-License-Identifier: BSD-3-Clause
// A data set of image files, calibration, stamps (ns) and true poses (m), after its folders and
// text files were read. Shared by all layouts.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "camera_files.hpp"
#include "tolman/camera.hpp"
#include "tolman/context.hpp"

namespace tolman::image_folders {

/// All lists have one entry for each image of the left camera.
struct ImageDataset {
  std::string layout;  ///< for messages: "KITTI odometry"
  std::vector<std::filesystem::path> left;
  std::vector<std::filesystem::path> right;  ///< or empty; an empty path: without partner
  std::vector<std::int64_t> stamps_ns;
  std::vector<Eigen::Isometry3d> T_world_left;  ///< truth, of the left camera; or empty
  std::vector<std::filesystem::path> depth;     ///< of the left camera, 16 bits; or empty
  double depth_per_m = 0;                       ///< values of a depth image per metre
  CameraRig rig;
  RawRig raw;  ///< for unrectified images; otherwise without cameras

  /// The calibration that these images need.
  camera_files::WantedCameras wanted(int kitti_left = 0) const {
    return {right.empty() ? 1 : 2, rig.width, rig.height, kitti_left};
  }
};

/// Fills in the images in `folder` that have the names of the left ones, without extension. One
/// without partner, on either side, is an error in `findings`.
void findPartners(const std::filesystem::path& folder, ImageDataset& dataset,
                  FindingCollector& findings);

/// Sets the image size of the rig: that of the first image that can be read. Throws DataError.
void setImageSize(ImageDataset& dataset);

/// Stamps of a camera with `rate` images a second.
std::vector<std::int64_t> uniformStamps(std::size_t count, double rate);

/// Sets the stamps of all images, read from `file`. Another count than that of the images is an
/// error in `findings`, and what is beyond the shorter list is left out.
void setStamps(const std::filesystem::path& file, std::vector<std::int64_t> stamps_ns,
               ImageDataset& dataset, FindingCollector& findings);

/// For each time the index of the nearest of `others`, at most `apart_ns` away, otherwise -1. Both
/// lists must increase. For sensors that are exposed at different times.
std::vector<std::ptrdiff_t> nearestTimes(const std::vector<std::int64_t>& times,
                                         const std::vector<std::int64_t>& others,
                                         std::int64_t apart_ns);

/// Removes the frames whose entry in `keep` is false from all lists.
void keepFrames(const std::vector<bool>& keep, ImageDataset& dataset);

/// Leaves out frames without partner and those whose time does not rise, which becomes an error in
/// `findings`, as do times of another unit, which the median step shows.
void leaveOutUnusable(ImageDataset& dataset, FindingCollector& findings);

/// "KITTI odometry, 51 stereo pairs of 1226x370 px at 9.7 Hz, baseline 0.537 m, with truth";
/// `frames` of them are used.
std::string descriptionOf(const ImageDataset& dataset, std::int64_t frames);

}  // namespace tolman::image_folders
