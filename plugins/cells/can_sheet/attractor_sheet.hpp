// SPDX-License-Identifier: BSD-3-Clause
// One grid module, unit by unit: a sheet of neurons on the twisted torus whose activity is one bump
// (Guanella, Kiper, Verschure, "A model of grid cells based on a twisted torus topology", 2007).
// The weights depend on the distance of two units on the torus, displaced by the velocity.
#pragma once

#include <span>
#include <vector>

#include "twisted_torus.hpp"

namespace tolman::can_sheet {

/// The paper's constants. `intensity` and `inhibition` hold for its 90 units; with N units both are
/// multiplied by 90 / N.
struct SheetSettings {
  int units = 40;              ///< along each axis
  double intensity = 0.3;      ///< I: strength of the Gaussian
  double width = 0.24;         ///< sigma, in periods
  double inhibition = 0.05;    ///< T: subtracted from all weights
  double stabilisation = 0.8;  ///< tau: share of the normalised activity
};

class AttractorSheet {
 public:
  /// At rest, with the bump at phase 0.
  explicit AttractorSheet(const SheetSettings& settings);

  /// One step of the paper's equations 2 to 5; the bump moves by the difference of phases.
  void step(const Phase& motion);
  /// Adds a bump at a place. `share`: its total activity divided by that of the sheet.
  void inject(const Phase& place, double share);

  /// The centre of the activity: the population vector along both axes, and along the axis between
  /// them.
  Phase phase() const;
  /// Activity, row by row of the second axis: unit (u, v) is at v * units + u.
  std::span<const float> activity() const { return activity_; }
  int units() const { return settings_.units; }

  /// False, without effect, unless there are as many values as units, none negative and not all 0.
  bool restore(std::span<const float> activity);

 private:
  /// Computes the weights from one unit to all units, displaced by `motion`.
  void setWeights(const Phase& motion);
  void addInputs();
  void setBump(const Phase& place);
  double total() const;

  SheetSettings settings_;
  std::vector<float> activity_;
  std::vector<float> input_;
  /// One row for each difference along v. Each row is stored twice, one after the other, so that
  /// the weights from any unit to a whole row are contiguous.
  std::vector<float> weights_;
};

}  // namespace tolman::can_sheet
