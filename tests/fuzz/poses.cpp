// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: poses.txt of a data set. Accepted poses are rigid and finite.
#include "input.hpp"
#include "times_and_poses.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  image_folders::Inspection inspection;
  const auto poses = image_folders::readKittiPoses(file.path(), inspection);
  for (const Eigen::Isometry3d& pose : poses) {
    fuzz::require(pose.matrix().allFinite(), "a pose that is not finite");
    const Eigen::Matrix3d R = pose.linear();
    fuzz::require((R.transpose() * R).isIdentity(1e-6), "a pose without a rotation");
  }
  return 0;
}
