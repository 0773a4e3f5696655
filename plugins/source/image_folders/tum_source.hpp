// SPDX-License-Identifier: BSD-3-Clause
// Source `tum`: a sequence in the layout of the TUM RGB-D benchmark, with depth.
#pragma once

#include <string>
#include <tuple>

#include "folder_source.hpp"

namespace tolman::image_folders {

class TumSource final : public FolderSource {
 public:
  struct Parameters : FolderParameters {
    std::string path;
    bool depth = true;
    double depth_scale = 5000;
    double most_apart = 0.02;
    double fx = 525;
    double fy = 525;
    double cx = 319.5;
    double cy = 239.5;

    static constexpr auto declaration() {
      return std::tuple_cat(
          parameters(parameter("path", &Parameters::path)
                         .path()
                         .required()
                         .doc("Folder of the sequence, with rgb.txt and depth.txt."),
                     parameter("depth", &Parameters::depth)
                         .doc("Give depth as the sensor array depth.left, in m; 0: not measured."),
                     parameter("depth_scale", &Parameters::depth_scale)
                         .range(1, 1e6)
                         .unit("1/m")
                         .doc("Values of a depth image per metre."),
                     parameter("most_apart", &Parameters::most_apart)
                         .range(0, 1)
                         .unit("s")
                         .doc("Largest difference in time between an image and its depth or its "
                              "true pose."),
                     parameter("fx", &Parameters::fx)
                         .range(1, 1e6)
                         .unit("px")
                         .doc("Focal length, horizontal."),
                     parameter("fy", &Parameters::fy)
                         .range(1, 1e6)
                         .unit("px")
                         .doc("Focal length, vertical."),
                     parameter("cx", &Parameters::cx)
                         .range(0, 1e6)
                         .unit("px")
                         .doc("Principal point, horizontal."),
                     parameter("cy", &Parameters::cy)
                         .range(0, 1e6)
                         .unit("px")
                         .doc("Principal point, vertical.")),
          folderParameters<Parameters>());
    }
  };

 protected:
  Status load(const ParameterValues& values, FolderParameters& shared, ImageDataset& dataset,
              Inspection& inspection) override;
};

}  // namespace tolman::image_folders
