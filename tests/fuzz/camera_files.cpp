// SPDX-License-Identifier: BSD-3-Clause
// Fuzz target: calibrations of raw cameras, in all formats. Accepted cameras have finite numbers,
// positive focal lengths and orthonormal rotations.
#include "camera_files.hpp"

#include <cmath>

#include "data_error.hpp"
#include "input.hpp"

namespace {

bool isRotation(const Eigen::Matrix3d& R) {
  return (R.transpose() * R).isIdentity(1e-6) && R.determinant() > 0;
}

void check(const tolman::RawRig& rig, const tolman::camera_files::WantedCameras& wanted) {
  using tolman::fuzz::require;
  require(static_cast<int>(rig.cameras.size()) == wanted.count, "missing cameras");
  for (const tolman::RawCamera& camera : rig.cameras) {
    require(camera.pinhole.fx > 0 && camera.pinhole.fy > 0, "a camera that is none");
    require(camera.distortion.allFinite() && std::isfinite(camera.xi),
            "a distortion that is not finite");
    require(isRotation(camera.T_reference_camera.linear()), "a pose without rotation");
    require(isRotation(camera.R_rectified_camera), "a prescribed rotation that is none");
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tolman;
  const fuzz::MemoryFile file({data, size});
  for (const camera_files::WantedCameras wanted :
       {camera_files::WantedCameras{1, 640, 480, 0}, camera_files::WantedCameras{2, 0, 0, 2},
        camera_files::WantedCameras{2, 640, 480, 0}}) {
    try {
      check(camera_files::readCameras({file.path(), file.path()}, wanted), wanted);
      const auto rectified = camera_files::readRectified(file.path(), wanted);
      fuzz::require(rectified.t_left_camera0.allFinite(), "an offset that is not finite");
      fuzz::require(rectified.rig.baseline >= 0 && rectified.rig.baseline <= 5,
                    "a baseline out of its limits");
    } catch (const source_parameters::DataError& error) {
      fuzz::require(!error.status().message().empty(), "refused without a reason");
    }
  }
  return 0;
}
