// SPDX-License-Identifier: BSD-3-Clause
// A short KITTI sequence for odometry tests: its calibration, its frames in any order, and the
// error of a trajectory against its truth.
#pragma once

#include <filesystem>
#include <vector>

#include "support/odometry_host.hpp"

namespace tolman::test {

/// Frames whose right image is dark, as if the camera were covered: positions in the order of a
/// run, the end excluded.
struct CoveredRight {
  std::size_t begin = 0;
  std::size_t end = 0;
};

class KittiClip {
 public:
  /// `type` is the file name extension of the images.
  explicit KittiClip(std::filesystem::path folder, const char* type = ".png");

  const CameraRig& rig() const { return rig_; }
  /// Image `index` of the clip, as frame `k` of a run at 10 Hz.
  Frame frame(std::size_t k, int index, bool covered_right = false) const;
  /// Root mean square distance (m) between poses[k] and the truth at order[k] after the best
  /// rotation and translation, and the best scale where asked for (Umeyama 1991, eq. 34 to 43).
  double ateRmse(const std::vector<Eigen::Isometry3d>& poses, const std::vector<int>& order,
                 bool scaled = false) const;

  /// Runs the images `order`; returns how many frames were lost.
  template <class Plugin>
  int run(OdometryHost<Plugin>& host, const std::vector<int>& order,
          CoveredRight covered = {}) const {
    int lost = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
      const bool dark = k >= covered.begin && k < covered.end;
      lost += host.track(frame(k, order[k], dark)).state == TrackingState::Lost ? 1 : 0;
    }
    host.finish();
    return lost;
  }

 private:
  Image image(const char* camera, int index) const;

  std::filesystem::path folder_;
  const char* type_;
  CameraRig rig_;
};

/// Indices from `from` up or down to `to`, which is excluded.
std::vector<int> indexRange(int from, int to);

}  // namespace tolman::test
