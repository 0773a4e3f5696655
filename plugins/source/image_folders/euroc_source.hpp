// SPDX-License-Identifier: BSD-3-Clause
// Source `euroc`: a sequence in the layout of the EuRoC MAV data set, also TUM-VI's.
#pragma once

#include <string>
#include <tuple>

#include "folder_source.hpp"

namespace tolman::image_folders {

class EurocSource final : public FolderSource {
 public:
  struct Parameters : FolderParameters {
    std::string path;
    std::string calibration;
    bool mono = false;

    static constexpr auto declaration() {
      return std::tuple_cat(
          parameters(parameter("path", &Parameters::path)
                         .path()
                         .required()
                         .doc("Folder with mav0, or with cam0 and cam1."),
                     parameter("calibration", &Parameters::calibration)
                         .path()
                         .doc("Calibration of all cameras, such as Kalibr's; empty: sensor.yaml of "
                              "each camera, else camchain.yaml."),
                     parameter("mono", &Parameters::mono).doc("Use the left camera only.")),
          folderParameters<Parameters>());
    }
  };

 protected:
  Status load(const ParameterValues& values, FolderParameters& shared, ImageDataset& dataset,
              Inspection& inspection) override;
};

}  // namespace tolman::image_folders
