// SPDX-License-Identifier: BSD-3-Clause
// Received images, joined to pairs by their stamps. Not thread-safe.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <vector>

namespace tolman::ros1 {

struct Arrived {
  std::int64_t stamp_ns = 0;
  std::vector<std::uint8_t> message;
};

struct ArrivedPair {
  Arrived left;
  Arrived right;  ///< empty with one camera
};

class PairQueue {
 public:
  explicit PairQueue(bool pairs = false, std::int64_t tolerance_ns = 0)
      : pairs_(pairs), tolerance_ns_(tolerance_ns) {}

  void addLeft(Arrived image) { add(left_, std::move(image)); }
  void addRight(Arrived image) { add(right_, std::move(image)); }
  /// The oldest image or pair, if it is complete. An image that is older than all images of the
  /// other camera by more than the tolerance is dropped.
  std::optional<ArrivedPair> take();
  /// Number of dropped images: without a partner, or too many to store.
  std::size_t leftOut() const { return left_out_; }
  bool hasLeft() const { return !left_.empty(); }
  bool hasRight() const { return !right_.empty(); }

 private:
  void add(std::deque<Arrived>& queue, Arrived image);

  bool pairs_;
  std::int64_t tolerance_ns_;
  std::deque<Arrived> left_;
  std::deque<Arrived> right_;
  std::size_t left_out_ = 0;
};

}  // namespace tolman::ros1
