// SPDX-License-Identifier: BSD-3-Clause
// Whether a rig has a field of disparity errors beyond an offset. Estimating one where there is
// none costs accuracy, because its noise acts on the scale.
#pragma once

namespace tolman::direct_sparse {

class FieldDecision {
 public:
  void reset() { *this = FieldDecision(); }
  /// `rms`: px, root mean square over the image of the field at a keyframe, without its offset, as
  /// it is (`is_on`) or would be if it were on. Returns whether it shall be on from the next
  /// keyframe on.
  ///
  /// A standard deviation of the window is no help: it is ten times too small. In exact towns the
  /// estimates had up to 0.08 px, on KITTI 06 and raw 0001 from the third keyframe on 0.19 px or
  /// more. 0.1 px is also the limit for rows.
  bool decide(bool is_on, double rms) {
    constexpr double kOn = 0.1;    // px
    constexpr double kOff = 0.05;  // px; chosen, not tuned
    constexpr int kKeyframes = 3;  // in a row; chosen, not tuned
    contradictions_ = (is_on ? rms < kOff : rms > kOn) ? contradictions_ + 1 : 0;
    if (contradictions_ < kKeyframes) return is_on;
    contradictions_ = 0;
    return !is_on;
  }

 private:
  int contradictions_ = 0;
};

}  // namespace tolman::direct_sparse
