// SPDX-License-Identifier: BSD-3-Clause
// The input as times of images and as true poses.
#include "times_and_poses.hpp"

#include "data_error.hpp"
#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  const auto tryRead = [](const auto& read) {
    try {
      read();
    } catch (const source_parameters::DataError& error) {
      fuzz::require(!error.status().message().empty(), "refused without a reason");
    }
  };
  for (const char* column : {"", "time"}) {
    tryRead([&] {
      for (const std::int64_t ns :
           image_folders::readTimes(file.path(), column, image_folders::TimeUnit::Seconds)
               .stamps_ns) {
        fuzz::require(ns >= 0, "a time before 0");
      }
    });
  }
  tryRead([&] { (void)image_folders::readDates(file.path()); });
  const auto check = [](const Eigen::Isometry3d& pose) {
    fuzz::require(pose.matrix().allFinite(), "a pose that is not finite");
    const Eigen::Matrix3d R = pose.linear();
    fuzz::require((R.transpose() * R).isIdentity(1e-6), "a pose without a rotation");
  };
  tryRead([&] {
    for (const auto& pose : image_folders::readKittiPoses(file.path())) check(pose);
  });
  return 0;
}
