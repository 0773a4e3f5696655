// SPDX-License-Identifier: BSD-3-Clause
// Base of the sources that read image files: frames from an ImageDataset, which a derived class
// reads.
#pragma once

#include <array>
#include <concepts>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include "image_dataset.hpp"
#include "image_warnings.hpp"
#include "inspection.hpp"
#include "on_corrupt.hpp"
#include "tolman/extras.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"

namespace tolman::image_folders {

using source_parameters::OnCorrupt;

/// Parameters of all layouts.
struct FolderParameters : FrameSelection {
  bool colour = false;
  int bits = 16;
  OnCorrupt on_corrupt = OnCorrupt::Stop;
};

template <std::derived_from<FolderParameters> P>
constexpr auto folderParameters() {
  return std::tuple_cat(
      parameters(
          parameter<P, bool>("colour", &P::colour)
              .doc("Provide colour images; otherwise colour files are converted to grey."),
          parameter<P, int>("bits", &P::bits)
              .range(8, 16)
              .doc("Bits that images of 16 bits use, from the lowest; the 8 highest of them are "
                   "taken."),
          parameter<P, OnCorrupt>("on_corrupt", &P::on_corrupt)
              .doc("Damaged image files: stop the run, or skip: give a frame without images.")),
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
  /// Reads every image file once: seconds for thousands of images.
  Status inspect(std::vector<Finding>& findings);

 protected:
  /// Binds the parameters, copies the shared ones to `shared`, and reads the data set as far as
  /// possible.
  virtual Status load(const ParameterValues& values, FolderParameters& shared,
                      ImageDataset& dataset, Inspection& inspection) = 0;

 private:
  Status readImages(std::size_t index, Frame& frame);
  Result<Image> readImage(const std::filesystem::path& file, ImageWarnings& warnings);
  NamedArray noDepth() const;
  Status readDepth(std::size_t index, Frame& frame) const;

  FolderParameters parameters_;
  ImageDataset dataset_;
  Inspection inspection_;
  Status ready_ = Status::failed("configure() was not called");
  FrameSequence sequence_;
  ImageWarnings left_warnings_;
  ImageWarnings right_warnings_;
  source_parameters::UsedBits used_bits_;
  Logger* log_ = nullptr;  ///< of configure()
  std::int64_t next_frame_ = 0;
};

}  // namespace tolman::image_folders
