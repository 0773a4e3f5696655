// SPDX-License-Identifier: BSD-3-Clause
// The loop decision on a small planted case, calculated by hand.
#include <catch2/catch.hpp>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

const ParameterValues kPlanted = {{"first_views_ignored", std::int64_t{0}},
                                  {"newest_ignored", std::int64_t{2}},
                                  {"initial_calibration", 0.0}};

/// Frames 0 ... 19: novel templates 0 ... 19, 5 m apart along x. Each makes an experience.
void driveOut(BayesianAttractor& plugin) {
  for (int i = 0; i < 20; ++i) {
    const Decision made = step(plugin, motionOf({i == 0 ? 0.0 : 5.0, 0, 0}, i), novel(i));
    CHECK(made.action == Action::CreateExperience);
    CHECK(made.experience == i);
  }
}

/// From x = 95 m back to x = 0, say odometry and truth; but odometry has drifted by (-8, 6) m.
void carryBack(BayesianAttractor& plugin) {
  step(plugin, motionOf({-95 - 8, 6, 0}, 20), nothing());
}

}  // namespace

TEST_CASE("the planted loop: three views decide, and by how much") {
  // The robot stands at template 0 (0, 0) but believes to be at (-8, 6) m = (-0.8, 0.6) cells:
  // 1 cell off. Views 0, 1, 2 at 0, 5, 10 m inject phases (0,0), (.5,0), (1,0), each consistent
  // with the calibration that has moved along by 0.5 cell (gate 0.3). Shares: .18, .37, .575 > 0.5,
  // and the estimate is (1 - .575) * 1 = 0.425 cell from the calibration: less than 1. Decision at
  // view 2.
  BayesianAttractor plugin;
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
  BayesianAttractor plugin;
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
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  for (int i = 20; i < 120; ++i) {
    const PlaceObservation seen = i % 4 == 0 ? familiar((i * 7) % 15) : novel(i);
    CHECK(step(plugin, motionOf({5, 0, 0.01}, i), seen).action != Action::CloseLoop);
  }
}

TEST_CASE("standing before one view habituates: no decision however long") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  carryBack(plugin);
  for (int i = 21; i < 100; ++i) {
    CHECK(step(plugin, motionOf({0, 0, 0}, i), familiar(0)).action != Action::CloseLoop);
  }
}

TEST_CASE("one view with a measured pose decides alone, and the pose is the experience's") {
  // Injected 4 E: (3) w_inte = 1 - 0.2 * 4 = 0.2, w_cali = 4 - 0.2 = 3.8; share 0.95.
  BayesianAttractor plugin;
  ParameterValues parameters = kPlanted;
  parameters["path_evidence"] = false;
  REQUIRE(configure(plugin, parameters).isOk());
  driveOut(plugin);
  // Template 20 is made 0.6 m beyond experience 19: too near for one of its own.
  const Decision stay = step(plugin, motionOf({0.6, 0, 0.1}, 20), novel(20));
  CHECK(stay.action == Action::Stay);
  CHECK(stay.relative_yaw == Approx(0.1));
  for (int i = 21; i < 30; ++i) step(plugin, motionOf({5, 0, 0}, i), novel(i));
  PlaceObservation seen = familiar(20);
  seen.has_relative_pose = true;
  seen.T_template_current = fromPlanar({2, 0, -0.3});
  seen.covariance = 0.01 * Matrix6d::Identity();
  const Decision decision = step(plugin, motionOf({-30, 10, 0}, 30), seen);
  CHECK(decision.action == Action::CloseLoop);
  CHECK(decision.experience == 19);
  CHECK(decision.confidence == Approx(0.95).margin(0.001));
  REQUIRE(decision.has_relative_pose);
  const PlanarPose expected = compose({0.6, 0, 0.1}, {2, 0, -0.3});
  const PlanarPose pose = toPlanar(decision.T_experience_current);
  CHECK(pose.x == Approx(expected.x));
  CHECK(pose.y == Approx(expected.y));
  CHECK(pose.theta == Approx(-0.2));
  CHECK(decision.relative_yaw == Approx(-0.2));
  CHECK(decision.covariance == seen.covariance);
}

TEST_CASE(
    "a decisive view decides alone, a merely plausible one waits, an impossible one is not seen") {
  // Odometry claims to be right within 1 % (a parameter); the view is measured within 1 m.
  struct Case {
    double off;  // m, how far odometry contradicts the view
    double injected;
    Action action;
  };
  for (const Case& c : {Case{1.0, 4.0, Action::CloseLoop}, Case{3.5, 0.4, Action::Stay},
                        Case{30.0, 0.0, Action::CreateExperience}}) {
    BayesianAttractor plugin;
    REQUIRE(configure(plugin, kPlanted).isOk());
    driveOut(plugin);
    PlaceObservation seen = familiar(0);
    seen.has_relative_pose = true;
    Motion back = motionOf({-95 - c.off, 0, 0}, 20);
    back.covariance.diagonal().setConstant(1e-4);
    const Decision decision = step(plugin, back, seen);
    INFO(c.off << " m off");
    CHECK(arrayOf(plugin, "grid.injected")[2] == Approx(c.injected));
    CHECK((decision.action == Action::CloseLoop) == (c.action == Action::CloseLoop));
  }
}

TEST_CASE("novel views between the familiar ones slow the decision only if they inhibit") {
  const auto viewsNeeded = [](const char* inhibition) {
    BayesianAttractor plugin;
    ParameterValues parameters = kPlanted;
    parameters["inhibition"] = std::string(inhibition);
    REQUIRE(configure(plugin, parameters).isOk());
    driveOut(plugin);
    carryBack(plugin);
    for (int views = 0; views < 15; ++views) {
      const int frame = 21 + 2 * views;
      const Motion motion = motionOf({views == 0 ? 0.0 : 5.0, 0, 0}, frame);
      if (step(plugin, motion, familiar(views)).action == Action::CloseLoop) return views + 1;
      step(plugin, motionOf({0, 0, 0}, frame + 1), novel(100 + views));
    }
    return 100;
  };
  CHECK(viewsNeeded("familiar_views") == 3);
  CHECK(viewsNeeded("every_view") > 6);
}

TEST_CASE("look-alikes that path integration rules out do not disturb the true ones between them") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  carryBack(plugin);
  int frame = 21;
  Action action = Action::Stay;
  for (int view = 0; view < 3; ++view) {
    action = step(plugin, motionOf({view == 0 ? 0.0 : 5.0, 0, 0}, frame++), familiar(view)).action;
    if (view == 2) break;
    for (int lie = 0; lie < 4; ++lie) {  // templates 60 m and more away
      step(plugin, motionOf({0, 0, 0}, frame++), familiar(12 + lie));
      CHECK(arrayOf(plugin, "grid.injected")[2] == 0);
    }
  }
  CHECK(action == Action::CloseLoop);
}

TEST_CASE("a long second lap gives loop links with spacing, all to old experiences") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, kPlanted).isOk());
  driveOut(plugin);
  carryBack(plugin);
  int loops = 0;
  for (int i = 0; i < 15; ++i) {
    const Decision decision =
        step(plugin, motionOf({i == 0 ? 0.0 : 5.0, 0, 0}, 21 + i), familiar(i));
    if (decision.action != Action::CloseLoop) continue;
    CHECK(decision.experience == i);
    ++loops;
  }
  CHECK(loops == 5);  // every third view
}
