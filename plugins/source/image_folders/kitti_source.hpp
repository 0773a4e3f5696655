// SPDX-License-Identifier: BSD-3-Clause
// Source `kitti`: one sequence in the layout of the KITTI odometry benchmark.
#pragma once

#include <string>
#include <tuple>

#include "folder_source.hpp"

namespace tolman::image_folders {

class KittiSource final : public FolderSource {
 public:
  struct Parameters : FolderParameters {
    std::string path;
    std::string poses;
    bool mono = false;
    double rate = 0;

    static constexpr auto declaration() {
      return std::tuple_cat(
          parameters(
              parameter("path", &Parameters::path)
                  .path()
                  .required()
                  .doc("Folder of one sequence, with image_0, calib.txt and times.txt."),
              parameter("poses", &Parameters::poses)
                  .path()
                  .doc("True poses; empty: poses.txt of the sequence, or ../../poses/NN.txt."),
              parameter("mono", &Parameters::mono).doc("Use the left camera only."),
              parameter("rate", &Parameters::rate)
                  .range(0, 1000)
                  .unit("Hz")
                  .doc("Frame rate for a sequence without times.txt; 0 demands the file.")),
          folderParameters<Parameters>());
    }
  };

 protected:
  Status load(const ParameterValues& values, FolderParameters& shared, ImageDataset& dataset,
              Inspection& inspection) override;
};

}  // namespace tolman::image_folders
