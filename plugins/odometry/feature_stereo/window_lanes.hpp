// SPDX-License-Identifier: BSD-3-Clause
// The least squares problem of a window, four landmarks at once. Landmarks are eliminated (Schur
// complement), so that the system has only the poses and the disparity offset.
#pragma once

#include <cstdint>
#include <vector>

#include "projection_lanes.hpp"
#include "window.hpp"

namespace tolman::feature_stereo {

/// What the problem is solved for, besides the landmarks.
struct WindowState {
  std::vector<Eigen::Isometry3d> poses;  ///< T_world_camera, oldest first; the first is held
  double offset = 0;                     ///< of the disparities
};

/// Normal equations of the poses but the first, six numbers each, and of the offset.
struct WindowSystem {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

class WindowLanes {
 public:
  /// `landmarks` of the window, each seen by at least one of its keyframes.
  WindowLanes(const CameraRig& rig, const PixelNoise& noise, const Window& window,
              const std::vector<Landmark*>& landmarks);

  /// Sum of robust squares (Huber) with the landmarks as they are.
  double cost(const WindowState& state);
  /// The same, and the system. `damping`: relative increase of the diagonal of landmarks.
  double linearise(const WindowState& state, double damping, WindowSystem& system);
  /// Moves the landmarks by the step that belongs to this one of poses and offset, of the system of
  /// the last linearise().
  void move(const Eigen::VectorXd& step);
  /// Undoes move().
  void moveBack();

  /// Coordinates of a landmark, in the order they were given.
  Eigen::Vector3d coordinatesOf(std::size_t landmark) const;
  /// Which keyframes' observations of a landmark fit: one bit for each, 0 where there is none. And
  /// the information on its coordinates of those that do.
  struct Fit {
    std::uint32_t keyframes = 0;
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();
  };
  /// `gate`: squared error in standard deviations.
  std::vector<Fit> fits(const WindowState& state, double gate);

  /// Four observations by one keyframe.
  struct Observations {
    Four3 pixel = {};               ///< relative to the principal point; with the offset
    Four3 weights = {};             ///< 1 / sigma; 0 without an observation
    std::array<Four3, 6> coupling;  ///< of the pose (rows) and the points, since linearise()
  };
  /// Four landmarks, seen by keyframes from `first` to before `end`.
  struct Group {
    LaneReference reference;
    Four3 coordinates = {};
    Four3 before = {};  ///< coordinates before move()
    Four6 inverse;      ///< of the information on the points, since linearise()
    Four3 gradient;
    Four3 by_offset;
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t start = 0;  ///< of its observations
  };
  /// Sums over all groups. Pairs of poses are those of the upper triangle, row by row.
  struct alignas(32) Sums {
    Four offset_information = {};
    Four offset_gradient = {};
    std::vector<Fours<36>> pairs;
    std::vector<Four6> gradients;
    std::vector<Four6> by_offset;
  };

 private:
  void fill(const PixelNoise& noise, const Window& window, const std::vector<Landmark*>& landmarks);

  LaneCamera camera_;
  std::size_t poses_;
  std::vector<Group> groups_;
  std::vector<Observations> observations_;
  std::vector<std::size_t> places_;  ///< of landmarks: four times the group, plus the lane
  Sums sums_;
};

}  // namespace tolman::feature_stereo
