// SPDX-License-Identifier: BSD-3-Clause
// The paper's residual, its derivatives, and the wrap of angles.
#include "planar_link.hpp"

#include <array>
#include <catch2/catch.hpp>
#include <tolman/context.hpp>

namespace tolman::experience_map {
namespace {

using Node = std::array<double, 3>;
using RowMatrix3d = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

Node randomNode(RandomStream& random) {
  return {random.uniform(-50, 50), random.uniform(-50, 50), random.uniform(-3.1, 3.1)};
}

Eigen::Vector3d residual(const PlanarLinkCost& cost, const Node& i, const Node& j) {
  const std::array<const double*, 2> nodes = {i.data(), j.data()};
  Eigen::Vector3d r;
  REQUIRE(cost.Evaluate(nodes.data(), r.data(), nullptr));
  return r;
}

Eigen::Matrix3d someCovariance(RandomStream& random) {
  Eigen::Matrix3d root;
  for (double& value : root.reshaped()) value = random.normal();
  return root * root.transpose() + 0.01 * Eigen::Matrix3d::Identity();
}

}  // namespace

TEST_CASE("the residual has the length of the paper's formula") {
  RandomStream random(1);
  for (int k = 0; k < 50; ++k) {
    const Node i = randomNode(random);
    const Node j = randomNode(random);
    const double d = random.uniform(0, 20);
    const double heading = random.uniform(-3, 3);
    const double facing = random.uniform(-3, 3);
    const Eigen::Vector3d paper(j[0] - i[0] - d * std::cos(i[2] + heading),
                                j[1] - i[1] - d * std::sin(i[2] + heading),
                                wrapAngle(j[2] - i[2] - facing));
    const PlanarLinkCost cost({d * std::cos(heading), d * std::sin(heading), facing},
                              Eigen::Matrix3d::Identity());
    const Eigen::Vector3d ours = residual(cost, i, j);
    CHECK(ours.head<2>().norm() == Approx(paper.head<2>().norm()));
    CHECK(ours.z() == Approx(paper.z()).margin(1e-12));
    // and is the paper's vector turned into the axes of e_i
    const Eigen::Vector2d turned = Eigen::Rotation2Dd(i[2]) * ours.head<2>();
    CHECK((turned - paper.head<2>()).norm() < 1e-11);
  }
}

TEST_CASE("the derivatives agree with central differences") {
  RandomStream random(2);
  for (int k = 0; k < 20; ++k) {
    const Node i = randomNode(random);
    const Node j = randomNode(random);
    const PlanarLinkCost cost({3, -1, 0.4}, whiteningOf(someCovariance(random)));
    const std::array<const double*, 2> nodes = {i.data(), j.data()};
    std::array<RowMatrix3d, 2> analytic;
    std::array<double*, 2> jacobians = {analytic[0].data(), analytic[1].data()};
    Eigen::Vector3d r;
    REQUIRE(cost.Evaluate(nodes.data(), r.data(), jacobians.data()));
    for (std::size_t node = 0; node < 2; ++node) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        constexpr double kStep = 1e-6;
        std::array<Node, 2> up = {i, j};
        std::array<Node, 2> down = {i, j};
        up[node][axis] += kStep;
        down[node][axis] -= kStep;
        const Eigen::Vector3d numeric =
            (residual(cost, up[0], up[1]) - residual(cost, down[0], down[1])) / (2 * kStep);
        const Eigen::Vector3d column = analytic[node].col(static_cast<Eigen::Index>(axis));
        CHECK((numeric - column).norm() < 1e-6 * (1 + column.norm()));
      }
    }
  }
}

TEST_CASE("a turn across pi is a small turn") {
  const PlanarLinkCost cost({1, 0, 0.2}, Eigen::Matrix3d::Identity());
  const Node i = {0, 0, 3.1};
  const Node j = {std::cos(3.1), std::sin(3.1), wrapAngle(3.3)};
  CHECK(j[2] < 0);
  CHECK(residual(cost, i, j).norm() < 1e-12);
}

TEST_CASE("the manifold keeps angles in [-pi, pi) and minus undoes plus") {
  const PlanarManifold manifold;
  RandomStream random(3);
  for (int k = 0; k < 50; ++k) {
    const Node x = randomNode(random);
    const Node delta = {random.normal(), random.normal(), random.uniform(-3, 3)};
    Node moved;
    Node back;
    REQUIRE(manifold.Plus(x.data(), delta.data(), moved.data()));
    REQUIRE(manifold.Minus(moved.data(), x.data(), back.data()));
    CHECK(moved[2] >= -std::numbers::pi);
    CHECK(moved[2] < std::numbers::pi);
    for (std::size_t axis = 0; axis < 3; ++axis) CHECK(back[axis] == Approx(delta[axis]));
  }
}

TEST_CASE("whitening makes the covariance the identity, and survives a singular one") {
  RandomStream random(4);
  const Eigen::Matrix3d covariance = someCovariance(random);
  const Eigen::Matrix3d W = whiteningOf(covariance);
  CHECK((W * covariance * W - Eigen::Matrix3d::Identity()).norm() < 1e-10);
  CHECK(whiteningOf(Eigen::Matrix3d::Zero()).allFinite());
}

}  // namespace tolman::experience_map
