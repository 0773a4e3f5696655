// SPDX-License-Identifier: BSD-3-Clause
// Pictures of a video file in any order, without seeking: after a seek a decoder may give other
// pictures than when it decodes all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "capture.hpp"

namespace tolman::video {

/// In forward order each picture is decoded once. A step back decodes the file again from its start
/// and keeps as many pictures before the wanted one as fit into `most_bytes`.
class FrameReader {
 public:
  explicit FrameReader(OpenCapture open, std::size_t most_bytes = std::size_t{256} << 20U)
      : open_(std::move(open)), most_bytes_(most_bytes) {}

  /// Decodes the whole file for the times of all pictures. `defect`: Capture::defectOfEnd().
  Status readTimes(std::vector<Picture>& pictures, std::string& defect);
  /// Picture `index`, which must exist.
  Status read(std::int64_t index, Picture& picture);

 private:
  Status rewind();
  std::int64_t blockSize() const;

  OpenCapture open_;
  std::size_t most_bytes_;
  std::unique_ptr<Capture> capture_;
  std::int64_t position_ = 0;  ///< index of the next picture of capture_
  std::int64_t block_begin_ = 0;
  std::vector<Picture> block_;
};

}  // namespace tolman::video
