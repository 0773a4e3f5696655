// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: calib.txt. Accepted cameras have finite numbers and a baseline in its limits.
#include "calibration.hpp"

#include <cmath>

#include "input.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  for (const int left : {0, 2}) {
    for (const bool stereo : {false, true}) {
      image_folders::Inspection inspection;
      const auto calibration =
          image_folders::readKittiCalibration(file.path(), left, stereo, inspection);
      fuzz::require(calibration.has_value() || inspection.hasErrors(), "refused without an error");
      if (!calibration || inspection.hasErrors()) continue;
      const Pinhole& K = calibration->pinhole;
      fuzz::require(std::isfinite(K.fx) && std::isfinite(K.fy) && std::isfinite(K.cx) &&
                        std::isfinite(K.cy) && K.fx > 0 && K.fy > 0,
                    "a camera that is none");
      fuzz::require(calibration->t_left_camera0.allFinite(), "an offset that is not finite");
      fuzz::require(calibration->baseline >= 0 && calibration->baseline <= 5,
                    "a baseline out of its limits");
    }
  }
  return 0;
}
