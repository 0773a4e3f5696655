// SPDX-License-Identifier: BSD-3-Clause
// Ring and tori together: path integration, calibration by views behind the consistency gate, and
// the decision that a place is familiar.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "grid_torus.hpp"
#include "head_direction_ring.hpp"

namespace tolman::bayesian_attractor {

/// A firing pattern of the two networks: what a local view cell is linked to.
struct CellPose {
  double heading = 0;                    ///< rad in [0, 2 pi)
  Phase<2> position = Phase<2>::Zero();  ///< cells in [0, period)
  std::vector<Phase<2>> further = {};    ///< the same in each further module
};

struct DecisionSettings {
  bool consistency_gate = true;
  double gate_heading = 0.1;       ///< rad
  double gate_position = 0.3;      ///< cells
  double decision_heading = 0.2;   ///< rad
  double decision_position = 1.0;  ///< cells
  double decision_share = 0.5;     ///< of the calibration in the energy
  int patience = 10;               ///< views that a calibration outlives without support
};

class SpatialCells {
 public:
  /// `further`: grid modules of other periods, in which places one period apart differ.
  SpatialCells(const HeadDirectionRing& ring, const GridTorus& torus,
               const DecisionSettings& settings, std::vector<GridTorus> further = {})
      : ring_(ring), torus_(torus), further_(std::move(further)), settings_(settings) {}

  /// Path integration of one planar motion (m, rad).
  void integrate(const PlanarPose& motion);
  /// One familiar view: energy for the calibration cells at `pose`. Behind the gate: a view that
  /// contradicts the present calibration does not average with it but starts a new one, as distant
  /// bumps of a real attractor compete.
  void inject(const CellPose& pose, double strength);
  /// One cycle of inhibition and estimation.
  void settle();
  void weakenIntegrators(double factor);

  /// Both networks hold the calibration to be true: it has won more than its share, and the
  /// estimate is near it.
  bool familiar() const;
  /// The familiar place becomes the integrators' place.
  void adoptEstimate();
  /// What the calibration held to be true was elsewhere.
  void forgetCalibration();
  /// A view without injection: an unsupported calibration ends after `patience` of them.
  void noteUnsupportedView();

  CellPose estimate() const;
  /// `pose` followed by a planar step (m, rad) in its own frame.
  CellPose displaced(const CellPose& pose, const PlanarPose& step) const;
  double calibrationShare() const;

  const HeadDirectionRing& ring() const { return ring_; }
  const GridTorus& torus() const { return torus_; }
  HeadDirectionRing& ring() { return ring_; }
  GridTorus& torus() { return torus_; }
  const std::vector<GridTorus>& further() const { return further_; }
  std::vector<GridTorus>& further() { return further_; }
  /// Views that made the present calibration, and views since the last of them.
  struct Support {
    std::int64_t views = 0;
    std::int64_t unsupported = 0;
  };
  const Support& support() const { return support_; }
  void restore(const Support& support) { support_ = support; }

 private:
  void restartCalibrations();
  bool contradictsCalibration(const CellPose& pose) const;

  HeadDirectionRing ring_;
  GridTorus torus_;
  std::vector<GridTorus> further_;
  DecisionSettings settings_;
  Support support_;
};

}  // namespace tolman::bayesian_attractor
