// SPDX-License-Identifier: BSD-3-Clause
// How two profiles differ: the shift that makes them most alike, and what is left then.
#pragma once

#include "profile.hpp"

namespace tolman::scanline {

struct ProfileMatch {
  /// How far the scene moved to the right from the earlier to the later profile, in samples,
  /// interpolated between whole ones.
  double moved_right = 0;
  double difference = 0;  ///< mean absolute difference at the best whole shift
  /// Half the width, in samples, of the range of shifts that are nearly as good.
  double uncertainty = 0;
  int compared = 0;  ///< samples that overlap at the best shift
};

/// Tries all shifts up to `largest_shift` to both sides; of equals the smaller shift counts. The
/// mean of each overlap is taken off first, so a change of exposure is no difference. Profiles of
/// one length; at least half of it must overlap, which limits the shift.
ProfileMatch matchProfiles(const Profile& earlier, const Profile& later, int largest_shift);

}  // namespace tolman::scanline
