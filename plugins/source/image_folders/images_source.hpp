// SPDX-License-Identifier: BSD-3-Clause
// Source `images`: one or two folders of numbered images, calibrated or not.
#pragma once

#include <string>
#include <tuple>

#include "folder_source.hpp"
#include "given_pinhole.hpp"
#include "times_and_poses.hpp"

namespace tolman::image_folders {

class ImagesSource final : public FolderSource {
 public:
  struct Parameters : FolderParameters, source_parameters::GivenPinhole {
    std::string path;
    std::string left;
    std::string right;
    std::string calibration;
    std::string calibration_right;
    double rate = 10;
    std::string stamps;
    std::string stamps_column;
    TimeUnit stamps_unit = TimeUnit::Seconds;
    bool stamps_in_names = false;

    static constexpr auto declaration() {
      return std::tuple_cat(
          parameters(
              parameter("path", &Parameters::path)
                  .path()
                  .required()
                  .doc("Folder of the data set; the other names are relative to it."),
              parameter("left", &Parameters::left)
                  .doc("Folder of the left (or only) camera; empty: images, or path itself."),
              parameter("right", &Parameters::right)
                  .doc("Folder of the right camera; empty for one camera."),
              parameter("calibration", &Parameters::calibration)
                  .doc("Calibration: KITTI's P0, P1 for rectified images; for raw ones Kalibr, "
                       "OpenCV, ROS, EuRoC or KITTI raw. Empty: fx to baseline."),
              parameter("calibration_right", &Parameters::calibration_right)
                  .doc("Second file where calibration has one camera, or no poses (OpenCV's "
                       "extrinsics).")),
          source_parameters::pinholeParameters<Parameters>(),
          parameters(
              parameter("rate", &Parameters::rate)
                  .range(0.001, 1e6)
                  .unit("Hz")
                  .doc("Frame rate, where stamps names no file."),
              parameter("stamps", &Parameters::stamps)
                  .doc("File with the time of each image, one a line, or a table."),
              parameter("stamps_column", &Parameters::stamps_column)
                  .doc("Name of the table's column that holds the times."),
              parameter("stamps_unit", &Parameters::stamps_unit).doc("Unit of the times."),
              parameter("stamps_in_names", &Parameters::stamps_in_names)
                  .doc("The names of the left images are their times, by which they are sorted.")),
          folderParameters<Parameters>());
    }
  };

 protected:
  Status load(const ParameterValues& values, FolderParameters& shared, ImageDataset& dataset,
              Inspection& inspection) override;
};

}  // namespace tolman::image_folders
