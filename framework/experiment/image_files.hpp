// SPDX-License-Identifier: BSD-3-Clause
// The image files that a source reads, and their decoding without the source: the reference that
// `tolman bench odometry` measures against.
//
// A source does not report its files, so they are found by their pixels: of the folders below the
// source's path parameters, the one is chosen whose file number Frame::source_index decodes to the
// image of that frame.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "tolman/parameters.hpp"
#include "tolman/records.hpp"
#include "tolman/status.hpp"

namespace tolman::bench {

class ImageFiles {
 public:
  /// Files of the images in `frame`, two folder levels deep at most. Unsupported when there are
  /// none: the source generates its images, or reads another format.
  static Result<ImageFiles> find(const Schema& schema, const ParameterValues& values,
                                 const Frame& frame);

  /// Decodes the images of one frame by cv::imread.
  Status decode(std::int64_t source_index) const;

 private:
  using Decoder = bool(const char* file, bool colour, Image& image);
  using Files = std::vector<std::filesystem::path>;  // in the natural order of their names

  Files filesOf(const Image& image, std::int64_t source_index,
                const std::vector<Files>& folders) const;

  Decoder* decoder_ = nullptr;
  bool colour_ = false;
  Files left_;
  Files right_;  ///< empty for a single camera
};

}  // namespace tolman::bench
