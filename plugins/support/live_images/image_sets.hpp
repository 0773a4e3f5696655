// SPDX-License-Identifier: BSD-3-Clause
// Received images of one or several cameras, joined to sets by their stamps. Not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace tolman::live_images {

struct Arrived {
  std::int64_t stamp_ns = 0;
  std::vector<std::uint8_t> message;
};

/// One image of each camera; the first decides the time.
using ImageSet = std::vector<Arrived>;

class ImageSets {
 public:
  explicit ImageSets(std::size_t cameras = 1, std::int64_t tolerance_ns = 0)
      : cameras_(cameras), tolerance_ns_(tolerance_ns) {}

  void add(std::size_t camera, Arrived image);
  /// The oldest set that is complete. An image that is older than all images of another camera by
  /// more than the tolerance is dropped.
  std::optional<ImageSet> take();
  /// Number of dropped images: without a partner, or too many to store.
  std::size_t leftOut() const { return left_out_; }
  bool has(std::size_t camera) const { return !cameras_[camera].empty(); }

 private:
  void drop(std::deque<Arrived>& camera);

  std::vector<std::deque<Arrived>> cameras_;
  std::int64_t tolerance_ns_;
  std::size_t left_out_ = 0;
};

}  // namespace tolman::live_images
