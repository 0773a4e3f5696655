// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: calibrations of raw cameras, in all formats. Accepted cameras have finite numbers,
// positive focal lengths and orthonormal rotations.
#include "camera_files.hpp"

#include <cmath>

#include "input.hpp"

namespace {

bool isRotation(const Eigen::Matrix3d& R) {
  return (R.transpose() * R).isIdentity(1e-6) && R.determinant() > 0;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  for (const camera_files::WantedCameras wanted :
       {camera_files::WantedCameras{1, 640, 480, 0}, camera_files::WantedCameras{2, 0, 0, 2},
        camera_files::WantedCameras{2, 640, 480, 0}}) {
    const auto rig = camera_files::readCameras({file.path(), file.path()}, wanted);
    if (!rig.isOk()) {
      fuzz::require(!rig.status().message().empty(), "refused without a reason");
      continue;
    }
    fuzz::require(static_cast<int>(rig.value().cameras.size()) == wanted.count, "missing cameras");
    for (const RawCamera& camera : rig.value().cameras) {
      fuzz::require(camera.pinhole.fx > 0 && camera.pinhole.fy > 0, "a camera that is none");
      fuzz::require(camera.distortion.allFinite() && std::isfinite(camera.xi),
                    "a distortion that is not finite");
      fuzz::require(isRotation(camera.T_reference_camera.linear()), "a pose without rotation");
      fuzz::require(isRotation(camera.R_rectified_camera), "a prescribed rotation that is none");
    }
  }
  return 0;
}
