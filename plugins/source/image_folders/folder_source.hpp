// SPDX-License-Identifier: BSD-3-Clause
// Base of the sources that read image files: frames from an ImageDataset, which a derived class
// reads.
#pragma once

#include <concepts>
#include <tuple>
#include <vector>

#include "image_dataset.hpp"
#include "tolman/extras.hpp"
#include "tolman/frame_selection.hpp"
#include "tolman/roles.hpp"
#include "used_bits.hpp"

namespace tolman::image_folders {

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
