// SPDX-License-Identifier: BSD-3-Clause
// The optimum against a dense Gauss-Newton solver with numeric derivatives, written here.
#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "optimise_links.hpp"

namespace tolman::experience_map {
namespace {

Eigen::Matrix3d covarianceOf(double sigma_x, double sigma_y, double sigma_theta) {
  return Eigen::Vector3d(sigma_x * sigma_x, sigma_y * sigma_y, sigma_theta * sigma_theta)
      .asDiagonal();
}

PlanarLink linkOf(std::size_t from, std::size_t to, const PlanarPose& pose,
                  const Eigen::Matrix3d& covariance) {
  return {.from = from, .to = to, .pose = pose, .covariance = covariance};
}

struct Problem {
  std::vector<PlanarPose> nodes;
  std::vector<PlanarLink> links;
};

/// A square of 4 * `side` steps of 1 m, whose odometry turns too far; `closed` by one loop link.
Problem squareLoop(std::size_t side, double drift, bool closed) {
  Problem problem;
  problem.nodes.emplace_back();
  const std::size_t count = 4 * side;
  for (std::size_t k = 0; k < count; ++k) {
    const double corner = (k + 1) % side == 0 ? std::numbers::pi / 2 : 0;
    const PlanarPose step = {1, 0, corner + drift};
    problem.links.push_back(linkOf(k, k + 1, step, covarianceOf(0.05, 0.02, 0.01)));
    problem.nodes.push_back(compose(problem.nodes.back(), step));
  }
  if (closed) problem.links.push_back(linkOf(0, count, {}, covarianceOf(0.1, 0.1, 0.02)));
  return problem;
}

Eigen::VectorXd stacked(const Problem& problem, const std::vector<PlanarPose>& nodes) {
  Eigen::VectorXd r(3 * problem.links.size());
  for (std::size_t k = 0; k < problem.links.size(); ++k) {
    const PlanarLink& link = problem.links[k];
    const PlanarPose seen = between(nodes[link.from], nodes[link.to]);
    const Eigen::Vector3d error(seen.x - link.pose.x, seen.y - link.pose.y,
                                wrapAngle(seen.theta - link.pose.theta));
    const Eigen::Matrix3d L = link.covariance.llt().matrixL();
    r.segment<3>(static_cast<Eigen::Index>(3 * k)) = L.triangularView<Eigen::Lower>().solve(error);
  }
  return r;
}

void nudge(std::vector<PlanarPose>& nodes, Eigen::Index parameter, double amount) {
  PlanarPose& node = nodes[static_cast<std::size_t>(parameter / 3) + 1];  // node 0 is held
  (parameter % 3 == 0 ? node.x : parameter % 3 == 1 ? node.y : node.theta) += amount;
}

std::vector<PlanarPose> denseGaussNewton(const Problem& problem) {
  std::vector<PlanarPose> nodes = problem.nodes;
  const auto size = static_cast<Eigen::Index>(3 * (nodes.size() - 1));
  for (int iteration = 0; iteration < 20; ++iteration) {
    const Eigen::VectorXd r = stacked(problem, nodes);
    Eigen::MatrixXd J(r.size(), size);
    for (Eigen::Index p = 0; p < size; ++p) {
      std::vector<PlanarPose> up = nodes;
      std::vector<PlanarPose> down = nodes;
      nudge(up, p, 1e-6);
      nudge(down, p, -1e-6);
      J.col(p) = (stacked(problem, up) - stacked(problem, down)) / 2e-6;
    }
    const Eigen::VectorXd delta = (J.transpose() * J).ldlt().solve(-J.transpose() * r);
    for (Eigen::Index p = 0; p < size; ++p) nudge(nodes, p, delta[p]);
  }
  return nodes;
}

double largestShift(const std::vector<PlanarPose>& a, const std::vector<PlanarPose>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max({largest, std::hypot(a[k].x - b[k].x, a[k].y - b[k].y),
                        std::abs(wrapAngle(a[k].theta - b[k].theta))});
  }
  return largest;
}

}  // namespace

TEST_CASE("a drifting square closes as dense Gauss-Newton closes it") {
  Problem problem = squareLoop(8, 0.004, true);
  const std::vector<PlanarPose> expected = denseGaussNewton(problem);
  OptimiserOptions options;
  options.delta = 1e6;
  options.tolerance = 1e-14;
  const double open = std::hypot(problem.nodes.back().x, problem.nodes.back().y);
  const Result<OptimiserOutcome> outcome = optimise(options, problem.nodes, problem.links);
  REQUIRE(outcome.isOk());
  CHECK(outcome.value().converged);
  CHECK(largestShift(problem.nodes, expected) < 1e-6);
  CHECK(open > 0.5);
  CHECK(std::hypot(problem.nodes.back().x, problem.nodes.back().y) < 0.2 * open);
  CHECK(problem.nodes.front().x == 0);
  CHECK(problem.links.back().weight == 1);
}

TEST_CASE("a chain without loops is left exactly where it is") {
  Problem problem = squareLoop(50, 0.01, false);
  const std::vector<PlanarPose> before = problem.nodes;
  REQUIRE(optimise({}, problem.nodes, problem.links).isOk());
  CHECK(largestShift(problem.nodes, before) < 1e-12);
}

TEST_CASE("Huber's loss stops one false link where plain least squares gives way to it") {
  const std::vector<PlanarPose> truth = squareLoop(8, 0, true).nodes;
  const auto damage = [&](double huber_delta) {
    Problem problem = squareLoop(8, 0, true);
    for (PlanarLink& link : problem.links) link.robust = false;
    for (std::size_t k = 0; k + 4 < 32; k += 4) {  // true ones ...
      problem.links.push_back(
          linkOf(k, k + 4, between(truth[k], truth[k + 4]), covarianceOf(0.1, 0.1, 0.02)));
    }
    problem.links.push_back(linkOf(4, 20, {}, covarianceOf(0.1, 0.1, 0.02)));  // ... and a lie
    OptimiserOptions options;
    options.delta = huber_delta;
    REQUIRE(optimise(options, problem.nodes, problem.links).isOk());
    if (huber_delta < 10) CHECK(problem.links.back().weight < 0.05);
    return largestShift(problem.nodes, truth);
  };
  CHECK(damage(1) < 0.2);  // m; the lie is 11 m long
  CHECK(damage(1e9) > 10 * damage(1));
}

namespace {

/// A square driven twice with drift: true loops all along the second lap, and `false_loops` between
/// nodes that have nothing to do with each other.
struct TwoLaps {
  Problem problem;
  std::vector<PlanarPose> truth;
  std::size_t loops = 0;  ///< true ones; they come before the false ones
};

TwoLaps twoLaps(std::size_t false_loops) {
  constexpr std::size_t kSide = 20;
  constexpr std::size_t kLap = 4 * kSide;
  TwoLaps made;
  made.truth = {{}};
  made.problem.nodes = {{}};
  for (std::size_t k = 0; k < 2 * kLap; ++k) {
    const double corner = (k + 1) % kSide == 0 ? std::numbers::pi / 2 : 0;
    const PlanarPose seen = {1.01, 0, corner + 0.001};
    made.truth.push_back(compose(made.truth.back(), {1, 0, corner}));
    made.problem.nodes.push_back(compose(made.problem.nodes.back(), seen));
    PlanarLink step = linkOf(k, k + 1, seen, covarianceOf(0.02, 0.02, 0.002));
    step.robust = false;
    made.problem.links.push_back(step);
  }
  for (std::size_t k = 5; k < kLap; k += 5, ++made.loops) {
    made.problem.links.push_back(linkOf(k, k + kLap, {}, covarianceOf(0.1, 0.1, 0.02)));
  }
  RandomStream random(11);
  for (std::size_t k = 0; k < false_loops; ++k) {
    const std::size_t from = random.below(kLap - 20);
    const std::size_t to = from + 20 + random.below(kLap);
    made.problem.links.push_back(linkOf(from, to, {}, covarianceOf(0.1, 0.1, 0.02)));
  }
  return made;
}

OptimiserOptions redescending() {
  OptimiserOptions options;
  options.loss = Loss::GemanMcclure;
  options.delta = 4;
  return options;
}

}  // namespace

TEST_CASE("with the redescending loss false loops are rejected and no true loop is") {
  const std::size_t false_loops = GENERATE(0U, 3U, 8U, 15U, 30U);  // of 15 true ones
  TwoLaps laps = twoLaps(false_loops);
  const std::vector<PlanarPose> reckoned = laps.problem.nodes;
  const std::vector<PlanarPose> lonely = [] {
    TwoLaps honest = twoLaps(0);
    REQUIRE(optimise(redescending(), honest.problem.nodes, honest.problem.links).isOk());
    return honest.problem.nodes;
  }();
  REQUIRE(
      optimiseMultiStart(redescending(), reckoned, laps.problem.nodes, laps.problem.links).isOk());
  const std::size_t first = laps.truth.size() - 1;
  INFO(false_loops << " false loops");
  for (std::size_t k = 0; k < laps.loops + false_loops; ++k) {
    const PlanarLink& link = laps.problem.links[first + k];
    const PlanarPose really = between(laps.truth[link.from], laps.truth[link.to]);
    if (std::hypot(really.x, really.y) < 3) continue;  // a lie that happens to be near the truth
    CHECK(link.weight < 0.1);
  }
  for (std::size_t k = 0; k < laps.loops; ++k) CHECK(laps.problem.links[first + k].weight > 0.5);
  CHECK(largestShift(laps.problem.nodes, lonely) < 0.2);
}

TEST_CASE(
    "with twice as many false loops as true ones the redescending loss finds the map, Huber's does "
    "not") {
  TwoLaps laps = twoLaps(30);
  TwoLaps judged = laps;
  const std::vector<PlanarPose> reckoned = laps.problem.nodes;
  REQUIRE(optimise({}, laps.problem.nodes, laps.problem.links).isOk());
  REQUIRE(optimiseMultiStart(redescending(), reckoned, judged.problem.nodes, judged.problem.links)
              .isOk());
  CHECK(largestShift(laps.problem.nodes, laps.truth) >
        1.5 * largestShift(judged.problem.nodes, laps.truth));
}

TEST_CASE("false loops alone leave dead reckoning unchanged") {
  TwoLaps laps = twoLaps(30);
  const std::size_t first = laps.truth.size() - 1;
  auto& links = laps.problem.links;
  links.erase(links.begin() + static_cast<std::ptrdiff_t>(first),
              links.begin() + static_cast<std::ptrdiff_t>(first + laps.loops));
  const std::vector<PlanarPose> reckoned = laps.problem.nodes;
  REQUIRE(optimiseMultiStart(redescending(), reckoned, laps.problem.nodes, links).isOk());
  CHECK(largestShift(laps.problem.nodes, reckoned) < 0.5);
}

TEST_CASE("iterations stop early if, and only if, they cannot reach energy_bound") {
  const auto search = [](double energy_bound) {
    TwoLaps laps = twoLaps(30);
    OptimiserOptions options;  // Huber's loss takes some dozens of iterations
    options.energy_bound = energy_bound;
    return optimise(options, laps.problem.nodes, laps.problem.links).value();
  };
  const OptimiserOutcome alone = search(std::numeric_limits<double>::infinity());
  REQUIRE(alone.converged);
  CHECK(search(1.1 * alone.energy).energy == alone.energy);
  const OptimiserOutcome beaten = search(0.1 * alone.energy);
  CHECK_FALSE(beaten.converged);
  CHECK(beaten.energy >= alone.energy);
}

TEST_CASE("a new loop has full weight at first, however far odometry has drifted") {
  // 30 m off is 300 standard deviations of the loop: at its face value it would have no weight.
  Problem problem = squareLoop(50, 0.004, true);
  for (PlanarLink& link : problem.links) link.robust = link.to != link.from + 1;
  const double open = std::hypot(problem.nodes.back().x, problem.nodes.back().y);
  REQUIRE(optimise(redescending(), problem.nodes, problem.links).isOk());
  CHECK(open > 20);
  CHECK(std::hypot(problem.nodes.back().x, problem.nodes.back().y) < 0.5);
  CHECK(problem.links.back().weight > 0.5);
}

TEST_CASE("two solutions of one problem are the same bit by bit") {
  Problem a = squareLoop(40, 0.003, true);
  Problem b = a;
  REQUIRE(optimise({}, a.nodes, a.links).isOk());
  REQUIRE(optimise({}, b.nodes, b.links).isOk());
  CHECK(largestShift(a.nodes, b.nodes) == 0);
}

TEST_CASE("an unfinished optimisation reports it and continues from where it stopped") {
  Problem whole = squareLoop(20, 0.001, true);
  Problem steps = whole;
  OptimiserOptions options;
  REQUIRE(optimise(options, whole.nodes, whole.links).isOk());
  options.iterations = 1;
  const Result<OptimiserOutcome> first = optimise(options, steps.nodes, steps.links);
  REQUIRE(first.isOk());
  CHECK_FALSE(first.value().converged);
  for (int k = 0; k < 60; ++k) REQUIRE(optimise(options, steps.nodes, steps.links).isOk());
  CHECK(largestShift(whole.nodes, steps.nodes) < 1e-4);
}

}  // namespace tolman::experience_map
