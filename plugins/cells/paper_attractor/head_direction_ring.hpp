// SPDX-License-Identifier: BSD-3-Clause
// Head direction cells: the attractor network on a ring of 2 pi.
#pragma once

#include <numbers>

#include "attractor_network.hpp"

namespace tolman::paper_attractor {

class HeadDirectionRing : public AttractorNetwork<1> {
 public:
  /// The period of `settings` is replaced by 2 pi.
  explicit HeadDirectionRing(NetworkSettings settings) : AttractorNetwork<1>(onRing(settings)) {}

  /// Path integration of a turn (rad, positive to the left).
  void turn(double yaw) { integrate(Phase<1>(yaw)); }
  /// Heading of the integrator cells, rad in [0, 2 pi).
  double integratedHeading() const { return integrator().mean(0); }

 private:
  static NetworkSettings onRing(NetworkSettings settings) {
    settings.period = 2 * std::numbers::pi;
    return settings;
  }
};

}  // namespace tolman::paper_attractor
