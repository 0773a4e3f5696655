// SPDX-License-Identifier: BSD-3-Clause
// A data set of image files, calibration, stamps (ns) and true poses (m), after its folders and
// text files were read. Shared by all layouts.
#pragma once

#include <Eigen/Geometry>
#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>
#include <tuple>
#include <vector>

#include "camera_files.hpp"
#include "photometric.hpp"
#include "times_and_poses.hpp"
#include "tolman/camera.hpp"
#include "tolman/context.hpp"
#include "tolman/extras.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"

namespace tolman::image_folders {

/// All lists have one entry for each image of the left camera.
struct ImageDataset {
  std::string layout;  ///< for messages: "KITTI odometry"
  std::vector<std::filesystem::path> left;
  std::vector<std::filesystem::path> right;  ///< or empty; an empty path: without partner
  std::vector<std::int64_t> stamps_ns;
  std::filesystem::path stamps_file;            ///< with one time for each image; or empty
  std::vector<Eigen::Isometry3d> T_world_left;  ///< truth, of the left camera; or empty
  std::vector<std::filesystem::path> depth;     ///< of the left camera, 16 bits; or empty
  double depth_per_m = 0;                       ///< values of a depth image per metre
  std::vector<float> exposure_ms;               ///< of the left camera; or empty
  PhotometricCalibration photometric;           ///< of the left camera
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

/// Sets stamps and exposures of all images, read from `file`. Another count than that of the images
/// is an error in `findings`, and what is beyond the shorter list is left out.
void setStamps(const std::filesystem::path& file, ImageTimes times, ImageDataset& dataset,
               FindingCollector& findings);

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

// Base of the sources that read image files: frames from an ImageDataset, which a derived class
// reads.

/// Parameters of all layouts.
struct FolderParameters : FrameSelection {
  bool colour = false;
  int bits = 16;
};

template <std::derived_from<FolderParameters> P>
constexpr auto folderParameters() {
  return std::tuple_cat(
      parameters(
          parameter<P, bool>("colour", &P::colour)
              .doc("Provide colour images; otherwise colour files are converted to grey."),
          parameter<P, int>("bits", &P::bits)
              .range(8, 16)
              .doc("Bits of images of 16 bits that the camera uses, from the lowest; the 8 highest "
                   "of them are taken.")),
      selectionParameters<P>());
}

class FolderSource : public Source, public RawRigSource, public ArrayDescriptions {
 public:
  Status configure(const Context& context) final;
  Status reset() final;
  Status info(SourceInfo& info) final;
  Status next(Frame& frame) final;
  Status rawRig(RawRig& rig) final;
  Status describe(std::vector<ArrayInfo>& arrays) const final;

 protected:
  /// Binds the parameters, copies the shared ones to `shared`, and reads the data set. Throws
  /// DataError.
  virtual Status load(const Context& context, FolderParameters& shared, ImageDataset& dataset) = 0;

 private:
  Status prepare(const Context& context);
  Status readFrame(std::size_t index, Frame& frame);
  Result<Image> readImage(const std::filesystem::path& file);
  Status readDepth(const std::filesystem::path& file, NamedArray& depth) const;

  FolderParameters parameters_;
  ImageDataset dataset_;
  FrameSequence sequence_;
  source_parameters::UsedBits used_bits_;
  bool is_orientation_reported_ = false;
  FindingCollector* findings_ = nullptr;
  Status ready_ = Status::failed("configure() was not called");
  std::int64_t next_frame_ = 0;
};

}  // namespace tolman::image_folders
