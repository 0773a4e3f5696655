// SPDX-License-Identifier: BSD-3-Clause
// The source role over an ImageDataset. A layout derives from it and says how the data are read.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "image_dataset.hpp"
#include "inspection.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"

namespace tolman::image_folders {

enum class OnCorrupt : std::uint8_t {
  Stop,  ///< next() fails
  Skip,  ///< a frame without images, with `defect`
};
inline constexpr std::array<std::string_view, 2> kOnCorruptNames = {"stop", "skip"};
constexpr std::span<const std::string_view> enumNames(OnCorrupt) { return kOnCorruptNames; }

/// Parameters of both layouts.
struct FolderParameters : FrameSelection {
  bool colour = false;
  OnCorrupt on_corrupt = OnCorrupt::Stop;
  bool yardstick = false;
};

template <std::derived_from<FolderParameters> P>
constexpr auto folderParameters() {
  return std::tuple_cat(
      parameters(parameter<P, bool>("colour", &P::colour)
                     .doc("Give colour images; otherwise colour files are read as grey."),
                 parameter<P, OnCorrupt>("on_corrupt", &P::on_corrupt)
                     .doc("Damaged image files: stop the run, or skip to a frame without image."),
                 parameter<P, bool>("yardstick", &P::yardstick)
                     .doc("Decode with plain cv::imread, nothing checked: what `tolman bench "
                          "odometry` compares with.")),
      selectionParameters<P>());
}

class FolderSource : public Source {
 public:
  Status configure(const Context& context) final;
  Status reset() final;
  Status info(SourceInfo& info) final;
  Status next(Frame& frame) final;
  /// Reads every image file once: seconds for thousands of images.
  Status inspect(std::vector<Finding>& findings) final;

 protected:
  /// Binds parameters, hands out those of every layout, and reads as much as it can.
  virtual Status load(const ParameterValues& values, FolderParameters& shared,
                      ImageDataset& dataset, Inspection& inspection) = 0;

 private:
  Status readImages(std::size_t index, Frame& frame) const;
  Result<Image> readImage(const std::filesystem::path& file) const;

  FolderParameters parameters_;
  ImageDataset dataset_;
  Inspection inspection_;
  Status ready_ = Status::failed("configure() was not called");
  FrameSequence sequence_;
  std::int64_t next_frame_ = 0;
};

}  // namespace tolman::image_folders
