// SPDX-License-Identifier: BSD-3-Clause
// The linear system of the window: all residuals of given points, with the inverse depths
// eliminated (Engel et al., PAMI 2018, section 2.3).
#pragma once

#include <span>
#include <vector>

#include "chunk_system.hpp"
#include "tolman/camera.hpp"
#include "window.hpp"

namespace tolman::direct_sparse {

inline constexpr double kMinDamping = 1e-8;  // keeps the scaled system regular

struct SystemSettings {
  float lambda = 1.5F;  ///< weight of the static term; 1 to 2 is best in Stereo DSO; 0: none
};

/// Points begin ... end - 1 of the keyframe in slot `host`.
struct PointRange {
  int host = 0;
  int begin = 0;
  int end = 0;
};

/// Every point of the window.
std::vector<PointRange> allPoints(const Window& window);

/// H dx = -b over the variables of window.hpp, with its prior kept apart. Residuals are evaluated
/// in parallel, in chunks of fixed size, and summed in fixed order: the same bits for any number of
/// threads.
class LinearSystem {
 public:
  /// Evaluates the residuals of the points at the present state and sets their states.
  void build(const CameraRig& rig, const SystemSettings& settings, Window& window,
             const std::vector<PointRange>& points);

  const SystemMatrix& H() const { return H_; }
  const SystemVector& b() const { return b_; }
  double energy() const { return energy_; }
  int residuals() const { return residuals_; }
  /// Of the static residuals.
  const ScaleMoments<double>& moments() const { return moments_; }
  /// Back-substitution: adds to each inverse depth the change that belongs to `step`. Returns the
  /// mean relative change.
  double applyToDepths(Window& window, const SystemVector& step) const;
  /// Writes H_dd and residual counts to the points.
  void storeInformation(Window& window) const;
  /// Pattern energy above which a residual is an outlier, from the 70th percentile of the last
  /// residuals.
  float outlierThreshold() const;
  /// Couplings of point `i` (in the order of the ranges).
  const PointTerms& terms(std::size_t i) const { return terms_[i]; }

 private:
  struct Chunk {
    PointRange range;
    std::size_t first_term = 0;
  };
  void prepare(const CameraRig& rig, const Window& window, const std::vector<PointRange>& points);
  void evaluateChunk(const CameraRig& rig, const SystemSettings& settings, Window& window,
                     std::size_t index);
  void addTarget(const CameraRig& rig, Window& window, const Chunk& chunk, int target,
                 ChunkSystem& system, std::span<PointTerms> terms) const;
  void addRight(const SystemSettings& settings, Window& window, const Chunk& chunk,
                ChunkSystem& system, std::span<PointTerms> terms) const;
  /// Adds the residual of each point in the right image of the newest keyframe that sees it.
  void addSightings(const CameraRig& rig, const SystemSettings& settings, const Window& window,
                    const Chunk& chunk, ChunkSystem& system, std::span<PointTerms> terms) const;
  /// A point as the newest keyframe sees it that has a right image; without its pattern.
  struct SeenPoint {
    int target = -1;  ///< slot; -1: none sees it
    Sighting sighting;
    Point point;
  };
  /// Also asks for the memory of its pixels.
  SeenPoint findSighting(const CameraRig& rig, const Window& window, int host,
                         const Point& point) const;
  void sumUp(const Window& window);

  std::vector<Chunk> chunks_;
  std::vector<ChunkSystem> systems_;
  std::vector<PointTerms> terms_;
  std::vector<PairGeometry> pairs_;      ///< host * kSlots + target
  std::vector<StereoGeometry> stereos_;  ///< by host
  SystemMatrix H_ = SystemMatrix::Zero();
  SystemVector b_ = SystemVector::Zero();
  double energy_ = 0;
  int residuals_ = 0;
  ScaleMoments<double> moments_;
};

/// Whether the residuals determine the scale of the scene.
enum class Scale : std::uint8_t { Known, Free };

/// H, b plus the window's prior at the present change, solved; unused variables and those of the
/// oldest keyframe, which fixes the gauge, stay 0. The step does not change a free scale. While
/// the field is off, of its coefficients only the offset changes.
SystemVector solve(const Window& window, const SystemMatrix& H, const SystemVector& b,
                   Scale scale = Scale::Known);
/// What the coefficients of the field are by the solution in which all of them may change, px.
SmoothField fieldIfOn(const Window& window, const SystemMatrix& H, const SystemVector& b,
                      Scale scale = Scale::Known);

/// Unit vector: the change of all poses that scales the window about its oldest keyframe.
SystemVector scaleDirection(const Window& window);

/// Present differences of all variables from their first estimates.
SystemVector changes(const Window& window);

}  // namespace tolman::direct_sparse
