// SPDX-License-Identifier: BSD-3-Clause
// Storeys of the same appearance above each other: with vertical modules they are different places,
// without them the same place.
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>

#include "harness.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

constexpr int kSteps = 120;    // of 1 m, once round a storey
constexpr double kStorey = 3;  // m
constexpr int kStoreys = 5;
constexpr int kRampSteps = 30;  // at the end of a round, from one storey to the next
const double kRadius = kSteps / (2 * std::numbers::pi);

struct Stop {
  int step = 0;   ///< on the ring
  int place = 0;  ///< what it looks like: ramps and the level differ, storeys do not
  double height = 0;
  double slope = 0;  ///< of the next step, m/m
};

/// `rounds` times up and down: a round on each storey, then the ramp at the end of the round.
/// `ways` of a road that leads in come first, along the ring at height 0.
std::vector<Stop> drive(int rounds, double storey) {
  std::vector<int> storeys;
  for (int i = 0; i < rounds; ++i) {
    for (int s = 0; s < kStoreys; ++s) storeys.push_back(s);
    for (int s = kStoreys - 2; s > 0; --s) storeys.push_back(s);
  }
  storeys.push_back(0);
  std::vector<Stop> stops;
  for (std::size_t i = 0; i < storeys.size(); ++i) {
    const int climb = i + 1 < storeys.size() ? storeys[i + 1] - storeys[i] : 0;
    for (int k = 0; k < kSteps; ++k) {
      const int ramp = std::max(0, k - (kSteps - kRampSteps));
      const double part = static_cast<double>(ramp) / kRampSteps;
      const double slope = k >= kSteps - kRampSteps ? climb * storey / kRampSteps : 0;
      stops.push_back({k,
                       k + kSteps * (slope < 0   ? 1
                                     : slope > 0 ? 2
                                                 : 0),
                       storey * (storeys[i] + climb * part), slope});
    }
  }
  return stops;
}

/// The camera looks along the way, also up and down the ramp.
Eigen::Isometry3d poseAt(const Stop& stop) {
  const double angle = 2 * std::numbers::pi * stop.step / kSteps;
  Eigen::Isometry3d T =
      fromPlanar({kRadius * std::sin(angle), kRadius * (1 - std::cos(angle)), angle});
  T.translation().y() = -stop.height;
  T.linear() =
      T.linear() *
      Eigen::AngleAxisd(std::atan(stop.slope), Eigen::Vector3d::UnitX()).toRotationMatrix();
  return T;
}

Eigen::Isometry3d noise(RandomStream& random, double metres, double radians) {
  Vector6d twist;
  for (int i = 0; i < 6; ++i) twist[i] = (i < 3 ? metres : radians) * random.normal();
  return expSe3(twist);
}

struct Outcome {
  int right = 0;
  int wrong = 0;              ///< loops that put the robot on another storey
  std::map<int, int> rounds;  ///< right loops of each round
};

/// The map of a drive: where its experiences really are.
class Judge {
 public:
  explicit Judge(const std::vector<Stop>& stops) : stops_(stops) {}

  void made(std::size_t stop) { experiences_.push_back(poseAt(stops_[stop])); }
  void closed(std::int64_t frame, std::int64_t experience, const Eigen::Isometry3d& T_experience) {
    const auto stop = static_cast<std::size_t>(frame);
    const Eigen::Isometry3d there =
        experiences_[static_cast<std::size_t>(experience)] * T_experience;
    const double off = (there.translation() - poseAt(stops_[stop]).translation()).norm();
    ++(off < 1.5 ? outcome.right : outcome.wrong);
    if (off < 1.5) ++outcome.rounds[static_cast<int>(frame) / kSteps];
  }

  Outcome outcome;

 private:
  const std::vector<Stop>& stops_;
  std::vector<Eigen::Isometry3d> experiences_;
};

/// The appearance of a place does not depend on the storey. Its first view makes the template.
PlaceObservation look(const Stop& stop, std::map<int, Eigen::Isometry3d>& templates,
                      RandomStream& random) {
  Eigen::Isometry3d here = poseAt(stop);
  here.translation().y() = 0;
  const auto [known, is_new] = templates.emplace(stop.place, here);
  if (is_new) return novel(stop.place);
  PlaceObservation seen = measured(stop.place);
  seen.T_template_current = known->second.inverse() * here * noise(random, 0.1, 0.01);
  return seen;
}

/// `mount`: rotation of the camera on the vehicle.
Outcome decide(const std::vector<Stop>& stops, const ParameterValues& parameters,
               std::uint64_t seed, const Eigen::Isometry3d& mount = Eigen::Isometry3d::Identity()) {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, parameters).isOk());
  RandomStream random(seed);
  std::map<int, Eigen::Isometry3d> templates;
  Judge judge(stops);
  for (std::size_t k = 0; k < stops.size(); ++k) {
    Motion motion = motionOf({}, static_cast<std::int64_t>(k));
    motion.T_previous_current = mount.inverse() * poseAt(stops[k > 0 ? k - 1 : 0]).inverse() *
                                poseAt(stops[k]) * mount * noise(random, 0.01, 3e-4);
    motion.covariance.diagonal() << 1e-4, 1e-4, 1e-4, 9e-8, 9e-8, 9e-8;
    PlaceObservation seen = look(stops[k], templates, random);
    seen.T_template_current = mount.inverse() * seen.T_template_current * mount;
    const Decision decision = step(plugin, motion, seen);
    if (decision.action == Action::CreateExperience) judge.made(k);
    for (const EarlierLoop& loop : decision.earlier) {
      judge.closed(loop.frame, loop.experience, mount * loop.T_experience_camera * mount.inverse());
    }
    if (decision.action == Action::CloseLoop) {
      judge.closed(decision.frame, decision.experience,
                   mount * decision.T_experience_current * mount.inverse());
    }
  }
  return judge.outcome;
}

const ParameterValues kSpace = {{"height_period", 20.0}};

/// With signs of the storey: the first 20 m of a round look different on each.
std::vector<Stop> withSigns(std::vector<Stop> stops) {
  for (Stop& stop : stops) {
    if (stop.slope != 0 || stop.step >= 20) continue;
    stop.place += 1000 * (1 + static_cast<int>(std::lround(stop.height / kStorey)));
  }
  return stops;
}

enum class Break { Kidnapped, NewSession };

/// A drive, then another one that starts at an unknown pose.
Outcome decideBroken(const std::vector<Stop>& before, const std::vector<Stop>& after, Break how,
                     std::uint64_t seed) {
  std::vector<Stop> stops = before;
  stops.insert(stops.end(), after.begin(), after.end());
  BayesianAttractor first;
  BayesianAttractor second;
  REQUIRE(configure(first, kSpace).isOk());
  REQUIRE(configure(second, kSpace).isOk());
  BayesianAttractor* plugin = &first;
  RandomStream random(seed);
  std::map<int, Eigen::Isometry3d> templates;
  Judge judge(stops);
  Outcome at_break;
  for (std::size_t k = 0; k < stops.size(); ++k) {
    Motion motion = motionOf({}, static_cast<std::int64_t>(k));
    motion.covariance.diagonal() << 1e-4, 1e-4, 1e-4, 9e-8, 9e-8, 9e-8;
    const bool is_break = k == before.size();
    motion.T_previous_current = poseAt(stops[k > 0 && !is_break ? k - 1 : k]).inverse() *
                                poseAt(stops[k]) * noise(random, 0.01, 3e-4);
    if (is_break) {
      motion.state = TrackingState::Initialising;
      at_break = judge.outcome;
      if (how == Break::NewSession) {
        std::stringstream stream;
        REQUIRE(first.save(stream).isOk());
        REQUIRE(second.load(stream).isOk());
        plugin = &second;
      }
    }
    const Decision decision = step(*plugin, motion, look(stops[k], templates, random));
    if (decision.action == Action::CreateExperience) judge.made(k);
    for (const EarlierLoop& loop : decision.earlier) {
      judge.closed(loop.frame, loop.experience, loop.T_experience_camera);
    }
    if (decision.action == Action::CloseLoop) {
      judge.closed(decision.frame, decision.experience, decision.T_experience_current);
    }
  }
  CHECK(at_break.wrong == 0);
  judge.outcome.right -= at_break.right;
  return judge.outcome;
}

}  // namespace

TEST_CASE("five storeys that look alike, up and down twice: no loop between them, each closed") {
  const std::vector<Stop> stops = drive(2, kStorey);
  const double tilt = GENERATE(0.0, 40.0) * std::numbers::pi / 180;  // down and to the side
  Vector6d mounted = Vector6d::Zero();
  mounted.tail<3>() = Eigen::Vector3d(-tilt, 0, tilt / 4);
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Outcome outcome = decide(stops, kSpace, seed, expSe3(mounted));
    CAPTURE(tilt, seed, outcome.right, outcome.wrong);
    CHECK(outcome.wrong == 0);
    for (int round = kStoreys; round < static_cast<int>(stops.size()) / kSteps; ++round) {
      CAPTURE(round);
      CHECK(outcome.rounds.contains(round));
    }
  }
}

TEST_CASE("without vertical modules storeys that look alike are one place") {
  const Outcome outcome = decide(drive(2, kStorey), {}, 1);
  CHECK(outcome.wrong > 100);
}

TEST_CASE("on the level vertical modules change no loop") {
  const std::vector<Stop> stops = drive(1, 0);
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    const Outcome space = decide(stops, kSpace, seed);
    const Outcome plane = decide(stops, {}, seed);
    CHECK(space.wrong == 0);
    CHECK(plane.wrong == 0);
    CHECK(space.rounds.size() == plane.rounds.size());
    CHECK(std::abs(space.right - plane.right) <= 2);
  }
}

TEST_CASE("a view is linked to one pattern a storey, and saved with all of them") {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, kSpace).isOk());
  Motion lift = motionOf({});
  for (int storey = 0; storey < 3; ++storey) {
    step(plugin, lift, storey == 0 ? novel(0) : measured(0));
    lift.T_previous_current.translation() = Eigen::Vector3d(0, -kStorey, 0);
  }
  const auto& links = plugin.state().links.at(0);
  REQUIRE(links.size() == 3);
  const ConjunctiveCode& code = plugin.state().network.code();
  CHECK(code.climb(links[0].learned.pattern, links[2].learned.pattern) ==
        Approx(2 * kStorey).margin(1e-6));
  CHECK(arrayOf(plugin, "height.decoded")[0] == Approx(2 * kStorey).margin(1e-4));
  std::stringstream stream;
  REQUIRE(plugin.save(stream).isOk());
  BayesianAttractor loaded;
  REQUIRE(configure(loaded, kSpace).isOk());
  REQUIRE(loaded.load(stream).isOk());
  CHECK(loaded.state().links.at(0).size() == 3);
  CHECK(arrayOf(loaded, "height.activity") == arrayOf(plugin, "height.activity"));
}

TEST_CASE(
    "a session or a carried robot that goes on upon another storey is put there by its sign") {
  const std::vector<Stop> before = withSigns(drive(1, kStorey));
  const Break how = GENERATE(Break::Kidnapped, Break::NewSession);
  for (const int storey : {1, 3, 4}) {
    // From half a round before the sign of that storey, down to the street.
    const std::vector<Stop> after(before.end() - kSteps * (storey + 1), before.end());
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      const Outcome outcome = decideBroken(before, after, how, seed);
      CAPTURE(storey, seed, outcome.right, outcome.wrong);
      CHECK(outcome.wrong == 0);
      CHECK(outcome.right > 10);
    }
  }
}

TEST_CASE("ambiguous storeys are not decided until a view of only one of them is seen") {
  const std::vector<Stop> before = drive(1, kStorey);
  for (const int storey : {1, 3, 4}) {
    const std::vector<Stop> after(before.end() - kSteps * (storey + 1), before.end());
    const Outcome outcome = decideBroken(before, after, Break::Kidnapped, 1);
    CAPTURE(storey, outcome.right, outcome.wrong);
    CHECK(outcome.right > 0);  // the street, at the end
    CHECK(outcome.wrong == 0);
  }
}
