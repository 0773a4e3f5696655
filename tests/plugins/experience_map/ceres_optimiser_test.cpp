// SPDX-License-Identifier: BSD-3-Clause
// Both solvers find the same minimum with the same weights, for any graph. The energy, computed
// here, is not lower anywhere near it.
#include "ceres_optimiser.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

#include "planar_link.hpp"
#include "spatial_link.hpp"

namespace tolman::experience_map {
namespace {

struct Graph {
  std::vector<PlanarPose> nodes;
  std::vector<PlanarLink> links;
};

Eigen::Matrix3d randomCovariance(RandomStream& random, double metres, double radians) {
  Eigen::Matrix3d A;
  for (Eigen::Index i = 0; i < 9; ++i) A(i / 3, i % 3) = random.uniform(-1, 1);
  const Eigen::Vector3d scale(metres, metres, radians);
  const Eigen::Matrix3d L = scale.asDiagonal() * (A + 2 * Eigen::Matrix3d::Identity());
  return L * L.transpose();
}

/// A wandering chain with noisy odometry and loops that are nearly right; `false_loops` of them are
/// not.
Graph randomGraph(std::uint64_t seed, std::size_t count, std::size_t loops,
                  std::size_t false_loops) {
  RandomStream random(seed);
  Graph graph;
  std::vector<PlanarPose> truth = {{}};
  graph.nodes = {{}};
  for (std::size_t i = 1; i < count; ++i) {
    const PlanarPose step = {random.uniform(0.5, 1.5), random.uniform(-0.1, 0.1),
                             random.uniform(-0.4, 0.5)};
    truth.push_back(compose(truth.back(), step));
    PlanarLink link;
    link.from = i - 1;
    link.to = i;
    link.robust = false;
    link.covariance = randomCovariance(random, 0.03, 0.01);
    link.pose = {step.x + 0.02 * random.normal(), step.y + 0.02 * random.normal(),
                 step.theta + 0.01 * random.normal()};
    graph.nodes.push_back(compose(graph.nodes.back(), link.pose));
    graph.links.push_back(link);
  }
  for (std::size_t k = 0; k < loops + false_loops; ++k) {
    PlanarLink link;
    link.from = random.below(count / 2);
    link.to = count / 2 + random.below(count / 2);
    link.covariance = randomCovariance(random, 0.1, 0.03);
    link.pose = between(truth[link.from], truth[link.to]);
    if (k >= loops) link.pose.x += 4;
    graph.links.push_back(link);
  }
  return graph;
}

/// The energy as the paper writes it, without any of the solvers' functions.
double energyOf(const OptimiserOptions& options, const Graph& graph) {
  double sum = 0;
  for (const PlanarLink& link : graph.links) {
    const PlanarPose seen = between(graph.nodes[link.from], graph.nodes[link.to]);
    const Eigen::Vector3d error(seen.x - link.pose.x, seen.y - link.pose.y,
                                wrapAngle(seen.theta - link.pose.theta));
    const double s = error.dot(link.covariance.ldlt().solve(error));
    const double d = options.delta;
    if (!link.robust) {
      sum += s;
    } else if (options.loss == Loss::Huber) {
      sum += s <= d * d ? s : 2 * d * std::sqrt(s) - d * d;
    } else {
      sum += d * d * s / (d * d + s);
    }
  }
  return sum;
}

double largestShift(const Graph& a, const Graph& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.nodes.size(); ++k) {
    largest =
        std::max({largest, std::hypot(a.nodes[k].x - b.nodes[k].x, a.nodes[k].y - b.nodes[k].y),
                  std::abs(wrapAngle(a.nodes[k].theta - b.nodes[k].theta))});
  }
  return largest;
}

OptimiserOptions optionsOf(Loss loss, double delta) {
  OptimiserOptions options;
  options.loss = loss;
  options.delta = delta;
  options.iterations = 300;
  options.tolerance = 1e-15;
  return options;
}

}  // namespace

TEST_CASE("elimination and Ceres end at one minimum of Huber's energy") {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const OptimiserOptions options = optionsOf(Loss::Huber, 1.5);
    Graph eliminated = randomGraph(seed, 40, 6, seed % 3);
    Graph by_ceres = eliminated;
    const auto a = optimise(options, eliminated.nodes, eliminated.links);
    const auto b = optimiseWithCeres(options, by_ceres.nodes, by_ceres.links);
    REQUIRE(a.isOk());
    REQUIRE(b.isOk());
    CAPTURE(seed);
    CHECK(largestShift(eliminated, by_ceres) < 1e-4);
    CHECK(a.value().energy == Approx(b.value().energy).epsilon(1e-6));
    CHECK(a.value().energy == Approx(energyOf(options, eliminated)).epsilon(1e-6));
    for (std::size_t k = 0; k < eliminated.links.size(); ++k) {
      REQUIRE(eliminated.links[k].weight == Approx(by_ceres.links[k].weight).margin(1e-3));
    }
  }
}

TEST_CASE("nowhere around the solution is the energy lower, under either loss") {
  RandomStream random(9);
  for (const Loss loss : {Loss::Huber, Loss::GemanMcclure}) {
    for (const Solver solver : {Solver::Elimination, Solver::Ceres}) {
      OptimiserOptions options = optionsOf(loss, 2);
      options.solver = solver;
      Graph graph = randomGraph(5, 30, 5, 1);
      REQUIRE(optimise(options, graph.nodes, graph.links).isOk());
      const double least = energyOf(options, graph);
      for (int i = 0; i < 300; ++i) {
        Graph other = graph;
        const double size = std::pow(10.0, random.uniform(-5, -2));
        for (std::size_t k = 1; k < other.nodes.size(); ++k) {
          if (i % 2 == 0 && k != 1 + random.below(other.nodes.size() - 1)) continue;
          other.nodes[k].x += size * random.normal();
          other.nodes[k].y += size * random.normal();
          other.nodes[k].theta += size * random.normal();
        }
        CAPTURE(static_cast<int>(loss), static_cast<int>(solver), i, size);
        REQUIRE(energyOf(options, other) >= least - 1e-6 * (1 + least));
      }
    }
  }
}

TEST_CASE("weights are what the losses leave a residual: 1, delta / r, and (c^2 / (c^2 + r^2))^2") {
  for (const Loss loss : {Loss::Huber, Loss::GemanMcclure}) {
    const OptimiserOptions options = optionsOf(loss, 1.2);
    Graph graph = randomGraph(3, 40, 6, 3);
    REQUIRE(optimiseWithCeres(options, graph.nodes, graph.links).isOk());
    for (const PlanarLink& link : graph.links) {
      const Eigen::Vector3d error = residualOf(link, graph.nodes[link.from], graph.nodes[link.to]);
      const double r = std::sqrt(error.dot(link.covariance.ldlt().solve(error)));
      const double c = options.delta;
      const double expected = !link.robust          ? 1
                              : loss == Loss::Huber ? std::min(1.0, c / r)
                                                    : std::pow(c * c / (c * c + r * r), 2);
      REQUIRE(link.weight == Approx(expected).margin(1e-5));
    }
  }
}

TEST_CASE("the first node is held, and a graph without loops is the odometry") {
  Graph graph = randomGraph(8, 25, 0, 0);
  const Graph before = graph;
  const auto outcome = optimiseWithCeres({}, graph.nodes, graph.links);
  REQUIRE(outcome.isOk());
  CHECK(largestShift(graph, before) < 1e-9);
  CHECK(outcome.value().energy < 1e-9);
  graph = randomGraph(8, 25, 6, 0);
  const PlanarPose first = {3, -4, 0.7};
  for (PlanarPose& node : graph.nodes) node = compose(first, node);
  REQUIRE(optimiseWithCeres({}, graph.nodes, graph.links).isOk());
  CHECK(graph.nodes.front().x == 3);
  CHECK(graph.nodes.front().y == -4);
  CHECK(graph.nodes.front().theta == 0.7);
}

TEST_CASE("in space the two solvers end at one minimum, too") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    RandomStream random(seed);
    const auto noise = [&](double metres, double radians) {
      Vector6d twist;
      for (int k = 0; k < 6; ++k) twist[k] = (k < 3 ? metres : radians) * random.normal();
      return expSe3(twist);
    };
    std::vector<Eigen::Isometry3d> truth = {Eigen::Isometry3d::Identity()};
    std::vector<Eigen::Isometry3d> nodes = truth;
    std::vector<SpatialLink> links;
    for (std::size_t i = 1; i < 30; ++i) {
      const Eigen::Isometry3d step = expSe3((Vector6d() << 0, -0.1, 1, 0.02, -0.25, 0).finished());
      truth.push_back(truth.back() * step);
      SpatialLink& link = links.emplace_back();
      link = {.from = i - 1, .to = i, .pose = step * noise(0.03, 0.01), .robust = false};
      link.covariance = Matrix6d::Identity() * 1e-3;
      nodes.push_back(nodes.back() * link.pose);
    }
    for (std::size_t k = 0; k < 6; ++k) {
      SpatialLink& link = links.emplace_back();
      link = {.from = 2 * k, .to = 15 + 2 * k};
      link.pose = truth[link.from].inverse() * truth[link.to] * noise(0.05, 0.02);
      if (k == seed % 6) link.pose.translation().y() += 3;  // the storey above
      link.covariance = Matrix6d::Identity() * 4e-3;
    }
    const OptimiserOptions options = optionsOf(Loss::Huber, 1.5);
    auto by_ceres = nodes;
    auto links_of_ceres = links;
    const auto a = optimise(options, nodes, links);
    const auto b = optimiseWithCeres(options, by_ceres, links_of_ceres);
    REQUIRE(a.isOk());
    REQUIRE(b.isOk());
    CHECK(a.value().energy == Approx(b.value().energy).epsilon(1e-6));
    for (std::size_t k = 0; k < nodes.size(); ++k) {
      CHECK((nodes[k].matrix() - by_ceres[k].matrix()).norm() < 1e-4);
    }
    CHECK(nodes.front().matrix() == Eigen::Matrix4d::Identity());
  }
}

}  // namespace tolman::experience_map
