// SPDX-License-Identifier: BSD-3-Clause
// The optimum against a dense Gauss-Newton solver with numeric derivatives, written here.
#include "planar_optimiser.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

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
  options.huber_delta = 1e6;
  options.tolerance = 1e-14;
  const double open = std::hypot(problem.nodes.back().x, problem.nodes.back().y);
  const Result<bool> converged = optimise(options, problem.nodes, problem.links);
  REQUIRE(converged.isOk());
  CHECK(converged.value());
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
    options.huber_delta = huber_delta;
    REQUIRE(optimise(options, problem.nodes, problem.links).isOk());
    if (huber_delta < 10) CHECK(problem.links.back().weight < 0.05);
    return largestShift(problem.nodes, truth);
  };
  CHECK(damage(1) < 0.2);  // m; the lie is 11 m long
  CHECK(damage(1e9) > 10 * damage(1));
}

TEST_CASE("two solutions of one problem are the same bit by bit") {
  Problem a = squareLoop(40, 0.003, true);
  Problem b = a;
  REQUIRE(optimise({}, a.nodes, a.links).isOk());
  REQUIRE(optimise({}, b.nodes, b.links).isOk());
  CHECK(largestShift(a.nodes, b.nodes) == 0);
}

TEST_CASE("an unfinished search says so and goes on from where it stopped") {
  Problem whole = squareLoop(20, 0.001, true);
  Problem steps = whole;
  OptimiserOptions options;
  REQUIRE(optimise(options, whole.nodes, whole.links).isOk());
  options.iterations = 1;
  const Result<bool> first = optimise(options, steps.nodes, steps.links);
  REQUIRE(first.isOk());
  CHECK_FALSE(first.value());
  for (int k = 0; k < 60; ++k) REQUIRE(optimise(options, steps.nodes, steps.links).isOk());
  CHECK(largestShift(whole.nodes, steps.nodes) < 1e-4);
}

}  // namespace tolman::experience_map
