// SPDX-License-Identifier: BSD-3-Clause
// The layouts of folders that can be read, and their parameters. read() fills the data set: it adds
// what is wrong with single files to the findings, and throws DataError where nothing can be used.
#pragma once

#include <string>
#include <tuple>

#include "given_pinhole.hpp"
#include "image_dataset.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {

/// Source `kitti`: one sequence of the KITTI odometry benchmark.
struct KittiParameters : FolderParameters {
  std::string path;
  std::string poses;
  bool mono = false;
  double rate = 0;

  static constexpr auto declaration() {
    using P = KittiParameters;
    return std::tuple_cat(
        parameters(parameter("path", &P::path)
                       .path()
                       .required()
                       .doc("Folder of one sequence, with image_0, calib.txt and times.txt."),
                   parameter("poses", &P::poses)
                       .path()
                       .doc("True poses; empty: poses.txt of the sequence, or ../../poses/NN.txt."),
                   parameter("mono", &P::mono).doc("Use the left camera only."),
                   parameter("rate", &P::rate)
                       .range(0, 1000)
                       .unit("Hz")
                       .doc("Frame rate for a sequence without times.txt; 0 demands the file.")),
        folderParameters<P>());
  }
};

/// Source `kitti_raw`: a drive of KITTI's raw data, before or after rectification.
struct KittiRawParameters : FolderParameters {
  std::string path;
  bool mono = false;
  double rate = 0;

  static constexpr auto declaration() {
    using P = KittiRawParameters;
    return std::tuple_cat(
        parameters(parameter("path", &P::path)
                       .path()
                       .required()
                       .doc("Folder of a drive, with image_00/data; calib_cam_to_cam.txt is there "
                            "or in the folder above."),
                   parameter("mono", &P::mono).doc("Use the left camera only."),
                   parameter("rate", &P::rate)
                       .range(0, 1000)
                       .unit("Hz")
                       .doc("Frame rate for a drive without image_00/timestamps.txt; 0 demands "
                            "the file.")),
        folderParameters<P>());
  }
};

/// Source `euroc`: a sequence of the EuRoC MAV data set, or TUM-VI's.
struct EurocParameters : FolderParameters {
  std::string path;
  std::string calibration;
  bool mono = false;

  static constexpr auto declaration() {
    using P = EurocParameters;
    return std::tuple_cat(
        parameters(parameter("path", &P::path)
                       .path()
                       .required()
                       .doc("Folder with mav0, or with cam0 and cam1."),
                   parameter("calibration", &P::calibration)
                       .path()
                       .doc("Calibration of all cameras, such as Kalibr's; empty: sensor.yaml of "
                            "each camera, else camchain.yaml."),
                   parameter("mono", &P::mono).doc("Use the left camera only.")),
        folderParameters<P>());
  }
};

/// Source `tum`: a sequence of the TUM RGB-D benchmark, with depth where there is depth.txt.
struct TumParameters : FolderParameters, source_parameters::GivenPinhole {
  TumParameters() { pinhole = {525, 525, 319.5, 239.5}; }  // recommended by the benchmark

  std::string path;
  double depth_scale = 5000;

  static constexpr auto declaration() {
    using P = TumParameters;
    return std::tuple_cat(
        parameters(
            parameter("path", &P::path)
                .path()
                .required()
                .doc("Folder of the sequence, with rgb.txt; depth.txt and groundtruth.txt are "
                     "used where they are there."),
            parameter("depth_scale", &P::depth_scale)
                .range(1, 1e6)
                .unit("1/m")
                .doc("Values of a depth image per metre.")),
        source_parameters::pinholeParameter<P>(
            "[fx, fy, cx, cy], or [f] about the middle of the image; of images with distortion "
            "followed by k1, k2, p1, p2, k3 (OpenCV), as published for fr1 and fr2; empty for an "
            "uncalibrated camera.",
            -1e6),
        folderParameters<P>());
  }
};

/// Source `images`: one or two folders of images, calibrated or not.
struct ImagesParameters : FolderParameters, source_parameters::GivenPinhole {
  std::string path;
  std::string left;
  std::string right;
  std::string list;
  std::string calibration;
  std::string calibration_right;
  double rate = 10;
  std::string stamps;
  std::string stamps_column;
  TimeUnit stamps_unit = TimeUnit::Seconds;
  bool stamps_in_names = false;
  std::string response;

  static constexpr auto declaration() {
    using P = ImagesParameters;
    return std::tuple_cat(
        parameters(
            parameter("path", &P::path)
                .path()
                .required()
                .doc("Folder of the data set; the other names are relative to it."),
            parameter("left", &P::left)
                .doc("Folder of the left (or only) camera; empty: images, or path itself."),
            parameter("right", &P::right)
                .doc("Folder of the right camera, with the names of the left images; empty for "
                     "one camera."),
            parameter("list", &P::list)
                .doc("File that names the left images in their order, one a line; empty: by the "
                     "numbers in their names."),
            parameter("calibration", &P::calibration)
                .doc("Calibration: KITTI's P0, P1 for rectified images; for raw ones Kalibr, "
                     "OpenCV, ROS, EuRoC, KITTI raw or TUM's camera.txt. Empty: pinhole and "
                     "baseline."),
            parameter("calibration_right", &P::calibration_right)
                .doc("Second file where calibration has one camera, or no poses (OpenCV's "
                     "extrinsics).")),
        source_parameters::pinholeParameter<P>(), source_parameters::baselineParameter<P>(),
        parameters(
            parameter("rate", &P::rate)
                .range(0.001, 1e6)
                .unit("Hz")
                .doc("Frame rate, where stamps names no file."),
            parameter("stamps", &P::stamps)
                .doc("File with the time of each image, one a line, or a table."),
            parameter("stamps_column", &P::stamps_column)
                .doc("Name of the table's column that holds the times."),
            parameter("stamps_unit", &P::stamps_unit).doc("Unit of the times."),
            parameter("stamps_in_names", &P::stamps_in_names)
                .doc("The names of the left images are their times, by which they are sorted."),
            parameter("response", &P::response)
                .doc("Inverse response of a single camera, as pcalib.txt of TUM's monocular sets; "
                     "vignette.png beside it is used too.")),
        folderParameters<P>());
  }
};

void read(const KittiParameters& p, ImageDataset& dataset, FindingCollector& findings);
void read(const KittiRawParameters& p, ImageDataset& dataset, FindingCollector& findings);
void read(const EurocParameters& p, ImageDataset& dataset, FindingCollector& findings);
void read(const TumParameters& p, ImageDataset& dataset, FindingCollector& findings);
void read(const ImagesParameters& p, ImageDataset& dataset, FindingCollector& findings);

template <class P>
class LayoutSource final : public FolderSource {
 public:
  using Parameters = P;

 protected:
  Status load(const Context& context, FolderParameters& shared, ImageDataset& dataset) override {
    const Result<P> bound = bindParameters<P>(context.parameters);
    if (!bound.isOk()) return bound.status();
    shared = bound.value();
    read(bound.value(), dataset, context.findings);
    return Status::ok();
  }
};

}  // namespace tolman::image_folders
