// SPDX-License-Identifier: BSD-3-Clause
#include "true_speeds.hpp"

#include <string>

#include "text_file.hpp"

namespace tolman::image_folders {
namespace {

constexpr double kFastest = 100;  // m/s; the default limit of `checks`, and that of motion_log
// At a high rate a small position error causes a large error of the speed, as in `checks`.
constexpr double kPositionError = 0.1;  // m

struct Step {
  double length = 0;  // m
  double seconds = 0;

  bool isTooFast() const { return length > kFastest * seconds + kPositionError; }
};

Step stepTo(const StampedPoses& truth, std::size_t i) {
  const auto& poses = truth.T_world_camera;
  return {(poses[i].translation() - poses[i - 1].translation()).norm(),
          static_cast<double>(truth.stamps_ns[i] - truth.stamps_ns[i - 1]) * 1e-9};
}

/// How many poses before pose `i` are the same, bit by bit; at least 1.
std::size_t equalBefore(const StampedPoses& truth, std::size_t i) {
  const auto& poses = truth.T_world_camera;
  std::size_t count = 1;
  while (count < i && poses[i - count - 1].matrix() == poses[i - 1].matrix()) ++count;
  return count;
}

}  // namespace

void checkTrueSpeeds(const std::filesystem::path& file, const StampedPoses& truth,
                     Inspection& inspection) {
  const std::size_t poses = truth.T_world_camera.size();
  if (truth.stamps_ns.size() != poses || truth.lines.size() != poses) return;
  std::size_t first = 0;
  std::size_t count = 0;
  for (std::size_t i = 1; i < poses; ++i) {
    if (!stepTo(truth, i).isTooFast()) continue;
    if (count++ == 0) first = i;
  }
  if (count == 0) return;
  const Step step = stepTo(truth, first);
  const std::size_t equal = equalBefore(truth, first);
  inspection.warning(
      file, truth.lines[first],
      "true pose is " + fixed(step.length, 1) + " m from the one before (" +
          fixed(step.length / step.seconds, 0) + " m/s" +
          (equal > 1 ? ", after " + std::to_string(equal) + " equal poses" : "") + "), and " +
          std::to_string(count) + " of " + std::to_string(poses - 1) +
          " steps are faster than 100 m/s; correct poses and times, or remove the file to run "
          "without truth, because errors are measured against these poses");
}

}  // namespace tolman::image_folders
