// SPDX-License-Identifier: BSD-3-Clause
// Compares two profiles: the shift with the smallest mean absolute difference, and that difference
// (Milford and Wyeth 2008).
#pragma once

#include "profile.hpp"

namespace tolman::scanline {

struct ProfileMatch {
  /// Shift of the scene to the right from the earlier to the later profile, in samples,
  /// interpolated.
  double moved_right = 0;
  double difference = 0;  ///< mean absolute difference at the best whole shift
  /// Half the width, in samples, of the range of shifts that are nearly as good.
  double uncertainty = 0;
  int compared = 0;  ///< samples that overlap at the best shift
};

/// Tries all shifts up to `largest_shift` to both sides; of equal differences the smaller shift is
/// taken. The mean of each overlap is subtracted first, so a change of exposure has no effect. The
/// profiles have the same length; at least half of it must overlap, which limits the shift.
ProfileMatch matchProfiles(const Profile& earlier, const Profile& later, int largest_shift);

}  // namespace tolman::scanline
