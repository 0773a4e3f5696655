// SPDX-License-Identifier: BSD-3-Clause
// Positions as phases: range and ambiguity of the code.
#include "grid_code.hpp"

#include <catch2/catch.hpp>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

Eigen::Vector2d decodedAfter(const GridCode& code, const Eigen::Vector2d& way) {
  Phases phases = code.origin();
  code.move(phases, way);
  return code.displacement(code.origin(), phases);
}

}  // namespace

TEST_CASE("four modules decode positions over kilometres") {
  const GridCode code(150, 4, 0.005);
  RandomStream random(3);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d way(random.uniform(-3000, 3000), random.uniform(-3000, 3000));
    INFO(way.transpose());
    CHECK((decodedAfter(code, way) - way).norm() < 1e-6);
  }
}

TEST_CASE("with one module places one period apart are alike, with two they are not") {
  const Eigen::Vector2d way(150, -300);
  CHECK(decodedAfter(GridCode(150, 1, 0.005), way).norm() < 1e-9);
  CHECK((decodedAfter(GridCode(150, 2, 0.005), way) - way).norm() < 1e-6);
}

TEST_CASE("a module with blurred phases tells less: two blurred modules confuse distant places") {
  // 7 periods of 150 m are 1050 m, 5 of 213 m are 1065 m: 15 m apart.
  const Eigen::Vector2d way(1050, 0);
  CHECK(decodedAfter(GridCode(150, 2, 0.005), way).x() == Approx(1050));
  CHECK(std::abs(decodedAfter(GridCode(150, 2, 0.03), way).x()) < 20);
  CHECK(decodedAfter(GridCode(150, 4, 0.03), way).x() == Approx(1050));
}

TEST_CASE("the modules' precisions add") {
  const GridCode one(100, 1, 0.01);
  const GridCode two(100, 2, 0.01);
  CHECK(one.sigma() == Approx(1));
  CHECK(1 / (two.sigma() * two.sigma()) == Approx(1 + 1 / (1.42 * 1.42)));
}

TEST_CASE("a closed path of any length returns to its first phase") {
  const GridCode code(20, 3, 0.005);
  Phases phases = code.origin();
  for (int side = 0; side < 4; ++side) {
    const Eigen::Vector2d step = Eigen::Rotation2Dd(side * M_PI / 2) * Eigen::Vector2d(0.7, 0.1);
    for (int i = 0; i < 1000; ++i) code.move(phases, step);
  }
  CHECK(code.displacement(code.origin(), phases).norm() < 1e-9);
  CHECK((phases.array() >= 0).all());
}
