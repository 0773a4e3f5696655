// SPDX-License-Identifier: BSD-3-Clause
// One Gauss-Newton step against the same normal equations, dense and without any elimination.
#include "chain_system.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "pose_link.hpp"

namespace tolman::experience_map {
namespace {

template <class G>
struct RandomProblem {
  std::vector<typename G::Pose> nodes;
  std::vector<PoseLink<G>> links;
};

template <class G>
MatrixOf<G> randomCovariance(RandomStream& random) {
  MatrixOf<G> root;
  for (double& value : root.reshaped()) value = 0.1 * random.normal();
  return root * root.transpose() + 0.01 * MatrixOf<G>::Identity();
}

template <class G>
typename G::Pose randomPose(RandomStream& random, double size) {
  StepOf<G> step;
  for (double& value : step.reshaped()) value = random.normal();
  step.template head<G::kSize == 3 ? 2 : 3>() *= size;
  return moved(G::identity(), step);
}

template <class G>
PoseLink<G> randomLink(RandomStream& random, std::size_t from, std::size_t to) {
  return {.from = from,
          .to = to,
          .pose = randomPose<G>(random, 2),
          .covariance = randomCovariance<G>(random),
          .weight = random.uniform(0.2, 1)};
}

/// A chain with the given loops; all poses and measurements are random.
template <class G>
RandomProblem<G> randomProblem(std::uint64_t seed, std::size_t count,
                               const std::vector<std::pair<std::size_t, std::size_t>>& loops) {
  RandomStream random(seed);
  RandomProblem<G> problem;
  for (std::size_t k = 0; k < count; ++k) {
    problem.nodes.push_back(randomPose<G>(random, 10));
    if (k > 0) problem.links.push_back(randomLink<G>(random, k - 1, k));
  }
  for (const auto& [from, to] : loops) problem.links.push_back(randomLink<G>(random, from, to));
  return problem;
}

template <class G>
struct Dense {
  Eigen::MatrixXd H;  ///< without node 0, which is held
  Eigen::VectorXd g;

  std::vector<StepOf<G>> step() const {
    const Eigen::VectorXd x = H.ldlt().solve(Eigen::VectorXd(-g));
    std::vector<StepOf<G>> step = {StepOf<G>::Zero()};
    for (Eigen::Index k = 0; k < g.size(); k += G::kSize) {
      step.emplace_back(x.segment<G::kSize>(k));
    }
    return step;
  }
};

template <class G>
Dense<G> dense(const RandomProblem<G>& problem, double damping) {
  constexpr int kSize = G::kSize;
  const auto size = static_cast<Eigen::Index>(kSize * problem.nodes.size());
  Eigen::MatrixXd H = Eigen::MatrixXd::Zero(size, size);
  Eigen::VectorXd g = Eigen::VectorXd::Zero(size);
  for (const PoseLink<G>& link : problem.links) {
    Eigen::MatrixXd J = Eigen::MatrixXd::Zero(kSize, size);
    const auto& from = problem.nodes[link.from];
    const auto& to = problem.nodes[link.to];
    const LinkDerivatives<G> by = derivativesOf(link, from, to);
    J.block<kSize, kSize>(0, static_cast<Eigen::Index>(kSize * link.from)) = by.by_from;
    J.block<kSize, kSize>(0, static_cast<Eigen::Index>(kSize * link.to)) = by.by_to;
    const MatrixOf<G> W = link.weight * link.covariance.inverse();
    H += J.transpose() * W * J;
    g += J.transpose() * W * residualOf(link, from, to);
  }
  H.diagonal() *= 1 + damping;
  const Eigen::Index rest = size - kSize;
  return {H.bottomRightCorner(rest, rest), g.tail(rest)};
}

template <class G>
std::vector<StepOf<G>> denseStep(const RandomProblem<G>& problem, double damping) {
  return dense(problem, damping).step();
}

template <class G>
void checkAgainstDense(const RandomProblem<G>& problem, double damping) {
  ChainSystem<G> system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<StepOf<G>> step;
  REQUIRE(system.solve(damping, step));
  const std::vector<StepOf<G>> expected = denseStep(problem, damping);
  REQUIRE(step.size() == expected.size());
  for (std::size_t k = 0; k < step.size(); ++k) {
    INFO("node " << k);
    CHECK((step[k] - expected[k]).norm() < 1e-6 * (1 + expected[k].norm()));
  }
}

/// The system that solve() has left, with a gradient of another kind, and its determinant.
template <class G>
void checkLeftSystem(const RandomProblem<G>& problem, double damping) {
  ChainSystem<G> system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<StepOf<G>> step;
  REQUIRE(system.solve(damping, step));
  Dense<G> whole = dense(problem, damping);
  CHECK(system.logDeterminant() ==
        Approx(whole.H.ldlt().vectorD().array().log().sum()).epsilon(1e-9));
  RandomStream random(77);
  std::vector<StepOf<G>> gradient(problem.nodes.size());
  for (std::size_t k = 0; k < gradient.size(); ++k) {
    for (double& value : gradient[k].reshaped()) value = random.normal();
    if (k == 0) continue;
    whole.g.template segment<G::kSize>(static_cast<Eigen::Index>(G::kSize * (k - 1))) = gradient[k];
  }
  REQUIRE(system.template solveFor<1>(gradient, step));
  const std::vector<StepOf<G>> expected = whole.step();
  for (std::size_t k = 0; k < step.size(); ++k) {
    CHECK((step[k] - expected[k]).norm() < 1e-6 * (1 + expected[k].norm()));
  }
}

}  // namespace

TEMPLATE_TEST_CASE("the step is that of the dense system", "", Plane, Space) {
  using Loops = std::vector<std::pair<std::size_t, std::size_t>>;
  SECTION("one long loop and a free tail") {
    checkAgainstDense(randomProblem<TestType>(1, 40, {{3, 30}}), 0);
  }
  SECTION("no loop at all") { checkAgainstDense(randomProblem<TestType>(2, 12, {}), 0); }
  SECTION("loops to the held start") {
    checkAgainstDense(randomProblem<TestType>(3, 20, {{0, 7}, {0, 19}}), 0);
  }
  SECTION("nested, crossing, and into both directions") {
    checkAgainstDense(randomProblem<TestType>(4, 60, Loops{{2, 50}, {45, 10}, {20, 30}, {59, 25}}),
                      0);
  }
  SECTION("two loops between the same nodes, and neighbours that are knots") {
    checkAgainstDense(randomProblem<TestType>(5, 20, Loops{{4, 15}, {15, 4}, {5, 14}, {3, 16}}), 0);
  }
  SECTION("a loop between neighbours") {
    checkAgainstDense(randomProblem<TestType>(6, 10, Loops{{4, 5}, {7, 6}, {1, 8}}), 0);
  }
  SECTION("damped") {
    checkAgainstDense(randomProblem<TestType>(7, 30, Loops{{2, 20}, {9, 29}}), 0.3);
  }
}

TEMPLATE_TEST_CASE("another gradient is solved for, and the determinant is the dense one", "",
                   Plane, Space) {
  using Loops = std::vector<std::pair<std::size_t, std::size_t>>;
  checkLeftSystem(randomProblem<TestType>(2, 12, {}), 0);
  checkLeftSystem(randomProblem<TestType>(3, 20, {{0, 7}, {0, 19}}), 0);
  checkLeftSystem(randomProblem<TestType>(4, 40, Loops{{2, 30}, {25, 10}, {15, 16}}), 0);
  checkLeftSystem(randomProblem<TestType>(7, 30, Loops{{2, 20}, {9, 29}}), 0.3);
}

TEMPLATE_TEST_CASE("a system that is built again in its memory gives the bytes of a new one", "",
                   Plane, Space) {
  using Loops = std::vector<std::pair<std::size_t, std::size_t>>;
  ChainSystem<TestType> used;
  for (const RandomProblem<TestType>& problem :
       {randomProblem<TestType>(4, 60, Loops{{2, 50}, {45, 10}, {20, 30}}),
        randomProblem<TestType>(2, 12, {}), randomProblem<TestType>(3, 70, Loops{{0, 7}, {9, 60}}),
        randomProblem<TestType>(5, 20, Loops{{4, 15}, {15, 4}})}) {
    ChainSystem<TestType> fresh(problem.nodes.size(), problem.links);
    used.build(problem.nodes.size(), problem.links);
    std::vector<StepOf<TestType>> expected;
    std::vector<StepOf<TestType>> step;
    fresh.linearise(problem.nodes, problem.links);
    used.linearise(problem.nodes, problem.links);
    REQUIRE(fresh.solve(0, expected));
    REQUIRE(used.solve(0, step));
    CHECK(step == expected);
    CHECK(used.logDeterminant() == fresh.logDeterminant());
  }
}

TEMPLATE_TEST_CASE("a bend is taken from the information along the residual, not from the pull", "",
                   Plane, Space) {
  using Step = StepOf<TestType>;
  RandomProblem<TestType> problem = randomProblem<TestType>(10, 20, {{1, 15}, {4, 18}});
  std::vector<double> curvatures(problem.links.size());
  RandomProblem<TestType> bent = problem;  // the same curvature by another covariance
  for (const std::size_t k : {19, 20}) {
    const PoseLink<TestType>& link = problem.links[k];
    const Step r = residualOf(link, problem.nodes[link.from], problem.nodes[link.to]);
    const MatrixOf<TestType> W = link.covariance.inverse();
    curvatures[k] = 0.3 / r.dot(W * r);
    bent.links[k].covariance = (W - curvatures[k] * W * r * r.transpose() * W).inverse();
  }
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  std::vector<Step> step;
  system.linearise(problem.nodes, problem.links, curvatures);
  REQUIRE(system.solve(0, step));
  Dense<TestType> expected = dense(bent, 0);
  expected.g = dense(problem, 0).g;
  const std::vector<Step> steps = expected.step();
  for (std::size_t k = 0; k < step.size(); ++k) {
    CHECK((step[k] - steps[k]).norm() < 1e-6 * (1 + steps[k].norm()));
  }
}

TEMPLATE_TEST_CASE("covariances may change, and six right-hand sides are solved at once", "",
                   Space) {
  RandomProblem<TestType> problem = randomProblem<TestType>(11, 30, {{1, 15}, {4, 28}});
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  for (PoseLink<TestType>& link : problem.links) link.covariance *= 0.25;
  problem.links[3].covariance.diagonal().array() += 0.1;
  system.takeCovariances(problem.links);
  system.linearise(problem.nodes, problem.links);
  REQUIRE(system.factorise(0));
  std::vector<Eigen::Matrix<double, 6, 6>> right(problem.nodes.size());
  RandomStream random(12);
  for (auto& part : right) {
    for (double& value : part.reshaped()) value = random.normal();
  }
  std::vector<Eigen::Matrix<double, 6, 6>> x;
  REQUIRE(system.template solveFor<6>(right, x));
  Dense<TestType> whole = dense(problem, 0);
  for (int column = 0; column < 6; ++column) {
    for (std::size_t k = 1; k < right.size(); ++k) {
      whole.g.template segment<6>(static_cast<Eigen::Index>(6 * (k - 1))) = right[k].col(column);
    }
    const std::vector<Vector6d> expected = whole.step();
    for (std::size_t k = 0; k < x.size(); ++k) {
      CHECK((x[k].col(column) - expected[k]).norm() < 1e-6 * (1 + expected[k].norm()));
    }
  }
}

TEMPLATE_TEST_CASE("one system serves many linearisations", "", Plane, Space) {
  RandomProblem<TestType> problem = randomProblem<TestType>(8, 25, {{1, 20}});
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  std::vector<StepOf<TestType>> step;
  for (int round = 0; round < 3; ++round) {
    problem.nodes[12] = moved(problem.nodes[12], StepOf<TestType>::Unit(0));
    problem.links.back().weight *= 0.5;
    system.linearise(problem.nodes, problem.links);
    REQUIRE(system.solve(0, step));
    CHECK((step[20] - denseStep(problem, 0)[20]).norm() < 1e-6 * (1 + step[20].norm()));
  }
}

TEMPLATE_TEST_CASE("a node that no link holds makes the system singular, and it says so", "", Plane,
                   Space) {
  RandomProblem<TestType> problem = randomProblem<TestType>(9, 10, {{2, 8}});
  std::erase_if(problem.links, [](const PoseLink<TestType>& link) { return link.to == 5; });
  ChainSystem<TestType> system(problem.nodes.size(), problem.links);
  system.linearise(problem.nodes, problem.links);
  std::vector<StepOf<TestType>> step;
  std::erase_if(problem.links, [](const PoseLink<TestType>& link) { return link.to == 9; });
  ChainSystem<TestType> loose(problem.nodes.size(), problem.links);
  loose.linearise(problem.nodes, problem.links);
  CHECK_FALSE(loose.solve(0, step));
}

}  // namespace tolman::experience_map
