// SPDX-License-Identifier: BSD-3-Clause
#include "engine/source_notes.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tolman::run {

std::optional<std::string> SourceNotes::add(const Frame& frame) {
  constexpr std::int64_t kDay_ns = 86'400'000'000'000;
  constexpr int kTold = 3;
  true_poses_ += frame.has_truth ? 1 : 0;
  const std::int64_t step = frame.stamp_ns - last_ns_;
  last_ns_ = frame.stamp_ns;
  if (frames_++ == 0) return std::nullopt;
  const bool is_jump = step >= kDay_ns && (steps_ns_.empty() || step / 1000 >= usualStep());
  steps_ns_.push_back(step);
  if (!is_jump) return std::nullopt;
  if (++jumps_ > kTold) return std::nullopt;
  return fmt::format(
      "the stamp is {:.0f} s after that of the frame before; stamps are in ns, and velocities are "
      "divided by that time{}",
      1e-9 * static_cast<double>(step),
      jumps_ == kTold ? "; further such steps are counted at the end" : "");
}

std::int64_t SourceNotes::usualStep() const {
  std::vector<std::int64_t> steps = steps_ns_;
  const auto median = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), median, steps.end());
  return *median;
}

std::vector<std::string> SourceNotes::atEnd(bool told_truth) const {
  constexpr double kImpossible_s = 10;  // as in data folders: no odometry follows such images
  std::vector<std::string> notes;
  if (jumps_ > 1) notes.push_back(fmt::format("{} stamps are days after the one before", jumps_));
  if (told_truth && frames_ > 0 && true_poses_ == 0) {
    notes.push_back(fmt::format(
        "told that frames come with true poses, and none of {} did; errors are not measured",
        frames_));
  }
  if (true_poses_ > 0 && 2 * true_poses_ < frames_) {
    notes.push_back(fmt::format("only {} of {} frames have true poses; errors are of these alone",
                                true_poses_, frames_));
  }
  if (steps_ns_.empty()) return notes;
  const double usual_s = 1e-9 * static_cast<double>(usualStep());
  if (usual_s > kImpossible_s) {
    notes.push_back(
        fmt::format("frames are {:.4g} s apart (median); stamps are in ns: are they in another "
                    "unit?",
                    usual_s));
  }
  return notes;
}

}  // namespace tolman::run
