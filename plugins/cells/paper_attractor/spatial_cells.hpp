// SPDX-License-Identifier: BSD-3-Clause
// Ring and torus together: path integration, calibration by views, and the decision that a place is
// familiar.
#pragma once

#include "grid_torus.hpp"
#include "head_direction_ring.hpp"

namespace tolman::paper_attractor {

/// A firing pattern of the two networks: what a local view cell is linked to.
struct CellPose {
  double heading = 0;                    ///< rad in [0, 2 pi)
  Phase<2> position = Phase<2>::Zero();  ///< cells in [0, period)
};

/// Chosen, not tuned; the defaults are those of the parameters.
struct DecisionSettings {
  double heading = 0.1;   ///< rad
  double position = 0.2;  ///< cells
};

class SpatialCells {
 public:
  SpatialCells(const HeadDirectionRing& ring, const GridTorus& torus,
               const DecisionSettings& settings)
      : ring_(ring), torus_(torus), settings_(settings) {}

  /// Path integration of one planar motion (m, rad).
  void integrate(const PlanarPose& motion);
  /// One familiar view: energy for the calibration cells at `pose`.
  void inject(const CellPose& pose, double strength);
  /// One cycle of inhibition and estimation.
  void settle();
  void weakenIntegrators(double factor);

  /// The estimate is near the calibration on ring and torus.
  bool familiar() const;
  /// Moves the integrator cells to the estimate and resets the calibration cells.
  void adoptEstimate();
  void restartCalibrations();

  CellPose estimate() const;
  /// `pose` followed by a planar step (m, rad) in its own axes.
  CellPose displaced(const CellPose& pose, const PlanarPose& step) const;
  double calibrationShare() const;

  const HeadDirectionRing& ring() const { return ring_; }
  const GridTorus& torus() const { return torus_; }

 private:
  HeadDirectionRing ring_;
  GridTorus torus_;
  DecisionSettings settings_;
};

}  // namespace tolman::paper_attractor
