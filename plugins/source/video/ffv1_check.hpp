// SPDX-License-Identifier: BSD-3-Clause
// Check sums of FFV1 pictures (RFC 9043, section 4.9), at which the decoder conceals damage.
#pragma once

#include <cstdint>
#include <span>

namespace tolman::video {

/// Whether each slice of a picture matches its check sum; false also if it has none.
bool hasSoundSlices(std::span<const std::uint8_t> picture);

/// Compares the check sums of one video, which its coder writes for all pictures or for none.
class Ffv1Check {
 public:
  /// Whether `picture`, or one before the first that matches, is damaged.
  bool isDamaged(std::span<const std::uint8_t> picture);

 private:
  bool has_sums_ = false;  ///< a picture matched
  bool unclear_ = false;   ///< a picture did not match before one did
};

}  // namespace tolman::video
