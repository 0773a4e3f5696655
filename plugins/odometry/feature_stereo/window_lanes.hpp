// SPDX-License-Identifier: BSD-3-Clause
// The least squares problem of a window, four landmarks at once. Landmarks are eliminated (Schur
// complement), so that the system has only the poses and the disparity offset.
#pragma once

#include <cstdint>
#include <vector>

#include "projection.hpp"
#include "window.hpp"

namespace tolman::feature_stereo {

/// The unknowns of the problem, besides the landmarks.
struct WindowState {
  std::vector<Eigen::Isometry3d> poses;  ///< T_world_camera, oldest first; the first is fixed
  double offset = 0;                     ///< px, of all disparities
};

/// Normal equations of all poses except the first (six rows each), then of the offset.
struct WindowSystem {
  Eigen::MatrixXd information;
  Eigen::VectorXd gradient;
};

class WindowLanes {
 public:
  /// `landmarks` of the window, each seen by at least one of its keyframes.
  WindowLanes(const CameraRig& rig, const PixelNoise& noise, const Window& window,
              const std::vector<Landmark*>& landmarks);

  /// Sum of Huber's loss over all observations, with the present landmarks.
  double cost(const WindowState& state);
  /// Also computes the system. `damping`: relative increase of the diagonal of landmarks.
  double linearise(const WindowState& state, double damping, WindowSystem& system);
  /// Moves the landmarks by back-substitution of `step`, a step of poses and offset that solves the
  /// system of the last linearise().
  void move(const Eigen::VectorXd& step);
  /// Undoes move().
  void moveBack();

  /// Coordinates of a landmark, in the order they were given.
  Eigen::Vector3d coordinatesOf(std::size_t landmark) const;
  /// The observations of a landmark that fit.
  struct Fit {
    std::uint32_t keyframes = 0;  ///< one bit for each keyframe whose observation fits
    Eigen::Matrix3d information = Eigen::Matrix3d::Zero();  ///< of these, on its coordinates
  };
  /// Of each landmark, the observations whose squared error, in variances, is at most `gate`.
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
    Four3 gradient;     ///< with respect to the points, likewise
    Four3 by_offset;    ///< coupling of the points and the offset, likewise
    std::size_t first = 0;
    std::size_t end = 0;
    std::size_t start = 0;  ///< index of its first observation
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
