// SPDX-License-Identifier: BSD-3-Clause
// Every parameter of the network has an effect on real KITTI motion: twice or half its default, or
// zero, changes decisions on at least two of five sequences.
#include <array>
#include <catch2/catch.hpp>
#include <map>
#include <optional>
#include <set>

#include "harness.hpp"
#include "recorded_drive.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;
using namespace tolman::bayesian_attractor::test;

namespace {

constexpr int kViewStep = 5;       // frames between compared views, as the recorded detector has it
constexpr int kInventedAge = 100;  // frames that an invented look-alike is old at least

struct Drive {
  std::string name;
  std::vector<PlanarPose> steps;
  std::map<int, Edge> candidates;  ///< the first of each frame
};

/// What is added to a recorded drive: with nothing added next to nothing matters.
struct Condition {
  double invented = 0;  ///< share of the other views that are look-alikes
  double noise = 0;     ///< m and 0.1 rad of each step
  bool measured = true;
  std::uint64_t seed = 1;
};
std::vector<Condition> conditions() {
  std::vector<Condition> all = {{}};
  for (const std::uint64_t seed : {1, 2, 3}) {
    all.push_back({.invented = 0.464, .seed = seed});
    all.push_back({.invented = 0.85, .seed = seed});
    all.push_back({.invented = 0.18, .noise = 0.077, .seed = seed});
    all.push_back({.invented = 0.18, .measured = false, .seed = seed});
  }
  return all;
}

std::vector<Drive> drives() {
  std::vector<Drive> found;
  for (const char* name : {"00", "02", "05", "06", "07"}) {
    const auto folder = tolman::test::dataOrSkip(std::string("kitti_motion/") + name);
    if (!folder) return {};
    Drive drive = {name, {{}}, {}};
    for (const Edge& edge : readEdges(*folder / "odometry.g2o")) drive.steps.push_back(edge.step);
    for (const Edge& edge : readEdges(*folder / "loop_candidates.g2o")) {
      drive.candidates.try_emplace(edge.from, edge);
    }
    found.push_back(std::move(drive));
  }
  return found;
}

/// The template of the view of each frame: a look-alike, a recorded candidate, or a new one.
PlaceObservation look(const Drive& drive, int frame, const Condition& condition,
                      RandomStream& random) {
  if (frame % kViewStep != 0) return nothing();
  const bool invents = random.uniform() < condition.invented;
  const std::uint64_t which = random.below(1U << 30U);
  const auto candidate = drive.candidates.find(frame);
  PlanarPose offset;
  int then = -1;
  if (candidate != drive.candidates.end()) {
    then = candidate->second.to / kViewStep;
    offset = between(candidate->second.step, {});
  } else if (invents && frame > kInventedAge) {
    then = static_cast<int>(which % static_cast<std::uint64_t>((frame - kInventedAge) / kViewStep));
  }
  if (then < 0) return novel(frame / kViewStep);
  if (!condition.measured) return familiar(then, offset.theta);
  return measured(then, offset);
}

/// All that the plugin has decided, as numbers.
std::vector<std::int64_t> decisions(const Drive& drive, const ParameterValues& values,
                                    const Condition& condition) {
  BayesianAttractor plugin;
  REQUIRE(configure(plugin, values).isOk());
  RandomStream random(condition.seed);
  std::vector<std::int64_t> all;
  for (int frame = 0; frame < static_cast<int>(drive.steps.size()); ++frame) {
    PlanarPose motion = drive.steps[static_cast<std::size_t>(frame)];
    motion.x += condition.noise * random.normal();
    motion.theta += 0.1 * condition.noise * random.normal();
    const Decision decision =
        step(plugin, motionOf(motion, frame), look(drive, frame, condition, random));
    if (decision.action == Action::Stay) continue;
    all.insert(all.end(), {frame, static_cast<std::int64_t>(decision.action), decision.experience});
  }
  return all;
}

/// Half, twice, a fiftieth, and zero or, where zero is out of range, the least integer that is not.
std::vector<ParameterValue> alternatives(const ParameterInfo& info) {
  if (const auto* whole = std::get_if<std::int64_t>(&info.default_value)) {
    return {*whole / 2, 2 * *whole, static_cast<std::int64_t>(info.min)};
  }
  if (std::holds_alternative<bool>(info.default_value)) return {false};
  // Lengths that follow from experience_spacing.
  const std::map<std::string_view, double> lengths = {{"period", 150},
                                                      {"view_sigma_position", 3},
                                                      {"loop_minimum_travel", 30},
                                                      {"loop_spacing", 5}};
  const auto length = lengths.find(info.name);
  const double usual =
      length != lengths.end() ? length->second : std::get<double>(info.default_value);
  std::vector<ParameterValue> values;
  for (const double factor : {0.5, 2.0, 0.0, 0.02}) {
    const double value = factor * usual;
    if (value >= info.min && value <= info.max) values.emplace_back(value);
  }
  return values;
}

}  // namespace

TEST_CASE("each parameter changes decisions on two real sequences at least", "[data]") {
  const std::vector<Drive> all = drives();
  if (all.empty()) return;
  const std::vector<Condition> added = conditions();
  std::map<std::pair<std::string, std::size_t>, std::vector<std::int64_t>> defaults;
  for (const Drive& drive : all) {
    for (std::size_t c = 0; c < added.size(); ++c) {
      defaults[{drive.name, c}] = decisions(drive, {}, added[c]);
    }
  }
  for (const ParameterInfo& info : schemaOf<AttractorParameters>()) {
    // These drives were recorded on a plane; storeys_test has what heights change.
    if (info.name == "height_period") continue;
    std::set<std::string> changed;
    for (const ParameterValue& value : alternatives(info)) {
      for (const Drive& drive : all) {
        for (std::size_t c = 0; c < added.size() && changed.size() < 2; ++c) {
          if (decisions(drive, {{info.name, value}}, added[c]) != defaults[{drive.name, c}]) {
            changed.insert(drive.name);
          }
        }
      }
    }
    INFO(info.name);
    CHECK(changed.size() >= 2);
  }
}

TEST_CASE("without injection no loop is closed", "[data]") {
  for (const Drive& drive : drives()) {
    INFO(drive.name);
    const auto all = decisions(drive, {{"injection", 0.0}, {"inhibition", 0.0}}, {});
    for (std::size_t i = 1; i < all.size(); i += 3) {
      CHECK(all[i] == static_cast<std::int64_t>(Action::CreateExperience));
    }
  }
}
