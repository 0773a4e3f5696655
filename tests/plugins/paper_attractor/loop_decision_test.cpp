// SPDX-License-Identifier: BSD-3-Clause
// The loop decision in a small constructed case, calculated by hand.
#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::paper_attractor;
using namespace tolman::paper_attractor::test;

namespace {

const ParameterValues kPlanted = {{"first_views_ignored", std::int64_t{0}},
                                  {"newest_ignored", std::int64_t{2}},
                                  {"initial_calibration", 0.0},
                                  {"decision_heading", 0.2},
                                  {"decision_position", 0.5}};

/// Frames 0 ... 19: novel templates 0 ... 19, 5 m apart along x. Each makes an experience.
void driveOut(PaperAttractor& plugin) {
  for (int i = 0; i < 20; ++i) {
    const Decision made = step(plugin, motionOf({i == 0 ? 0.0 : 5.0, 0, 0}, i), novel(i));
    CHECK(made.action == Action::CreateExperience);
    CHECK(made.experience == i);
  }
}

/// From x = 95 m back to x = 0, by odometry and truth; but odometry has drifted by (-8, 6) m.
void carryBack(PaperAttractor& plugin) { step(plugin, motionOf({-95 - 8, 6, 0}, 20), nothing()); }

}  // namespace

TEST_CASE("a loop is closed at the third familiar view; shares by hand") {
  // The robot stands at template 0 (0, 0) but its estimate is (-8, 6) m = (-0.8, 0.6) cells:
  // 1 cell off. Views 0, 1, 2 at 0, 5, 10 m inject phases (0,0), (.5,0), (1,0), each consistent
  // with the calibration that has moved along by 0.5 cell (gate 0.3). Shares: .18, .37, .575 > 0.5,
  // and the estimate is (1 - .575) * 1 = 0.425 cell from the calibration: less than 0.5. Decision
  // at view 2.
  PaperAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  carryBack(plugin);
  CHECK(step(plugin, motionOf({0, 0, 0}, 21), familiar(0)).action != Action::CloseLoop);
  CHECK(arrayOf(plugin, "grid.injected") == std::vector<float>{0, 0, 0.4F});
  CHECK(arrayOf(plugin, "grid.calibration")[2] == Approx(0.179).margin(0.001));
  // Estimate after one view: 0.821 of (-0.8, 0.6), x wrapped into [0, 15).
  CHECK(arrayOf(plugin, "grid.estimate")[0] == Approx(15 - 0.657).margin(0.001));
  CHECK(arrayOf(plugin, "grid.estimate")[1] == Approx(0.493).margin(0.001));

  CHECK(step(plugin, motionOf({5, 0, 0}, 22), familiar(1)).action != Action::CloseLoop);
  const Decision decision = step(plugin, motionOf({5, 0, 0}, 23), familiar(2, 0.05));
  CHECK(decision.action == Action::CloseLoop);
  CHECK(decision.experience == 2);
  CHECK(decision.template_id == 2);
  CHECK(decision.confidence == Approx(0.575).margin(0.001));
  CHECK(decision.relative_yaw == Approx(0.05));
  CHECK_FALSE(decision.has_relative_pose);
  // The integrator takes the estimate: (1, 0) + 0.425 * (-0.8, 0.6).
  CHECK(arrayOf(plugin, "grid.integrator")[0] == Approx(1 - 0.340).margin(0.001));
  CHECK(arrayOf(plugin, "grid.integrator")[1] == Approx(0.255).margin(0.001));
}

TEST_CASE("the paper's asymmetric form takes four views: .17 .32 .47 .59") {
  PaperAttractor plugin;
  ParameterValues parameters = kPlanted;
  parameters["inhibition_of_integrator"] = 0.0;
  REQUIRE(configure(plugin, parameters).isOk());
  driveOut(plugin);
  carryBack(plugin);
  int views = 0;
  for (Action action = Action::Stay; action != Action::CloseLoop && views < 12; ++views) {
    action =
        step(plugin, motionOf({views == 0 ? 0.0 : 5.0, 0, 0}, 21 + views), familiar(views)).action;
  }
  CHECK(views == 4);
}

TEST_CASE("one familiar view among novel ones closes nothing") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  for (int i = 20; i < 120; ++i) {
    const PlaceObservation seen = i % 4 == 0 ? familiar((i * 7) % 15) : novel(i);
    CHECK(step(plugin, motionOf({5, 0, 0.01}, i), seen).action != Action::CloseLoop);
  }
}

TEST_CASE("standing before one view habituates: no decision however long") {
  PaperAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  carryBack(plugin);
  for (int i = 21; i < 100; ++i) {
    CHECK(step(plugin, motionOf({0, 0, 0}, i), familiar(0)).action != Action::CloseLoop);
  }
}
