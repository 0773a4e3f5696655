// SPDX-License-Identifier: BSD-3-Clause
// Source `kitti_raw`: a drive of KITTI's raw data, before or after rectification.
#pragma once

#include <string>
#include <tuple>

#include "folder_source.hpp"

namespace tolman::image_folders {

class KittiRawSource final : public FolderSource {
 public:
  struct Parameters : FolderParameters {
    std::string path;
    std::string calibration;
    bool mono = false;
    double rate = 0;

    static constexpr auto declaration() {
      return std::tuple_cat(
          parameters(parameter("path", &Parameters::path)
                         .path()
                         .required()
                         .doc("Folder of a drive, with image_00/data."),
                     parameter("calibration", &Parameters::calibration)
                         .path()
                         .doc("Empty: calib_cam_to_cam.txt in the folder, or in the one above."),
                     parameter("mono", &Parameters::mono).doc("Use the left camera only."),
                     parameter("rate", &Parameters::rate)
                         .range(0, 1000)
                         .unit("Hz")
                         .doc("Frame rate for a drive without image_00/timestamps.txt; 0 demands "
                              "the file.")),
          folderParameters<Parameters>());
    }
  };

 protected:
  Status load(const ParameterValues& values, FolderParameters& shared, ImageDataset& dataset,
              Inspection& inspection) override;
};

}  // namespace tolman::image_folders
