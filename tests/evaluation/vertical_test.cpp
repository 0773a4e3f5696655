// SPDX-License-Identifier: BSD-3-Clause
// Paths for which the rotation of the aligned estimate about the path is undetermined, and others,
// with errors in closed form.
#include <catch2/catch.hpp>
#include <functional>
#include <numbers>

#include "evaluation/association.hpp"
#include "evaluation/metrics.hpp"
#include "evaluation/paths.hpp"
#include "evaluation/score.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::evaluation;

namespace {

constexpr std::int64_t kPoses = 64;

/// Signs with mean 0 that are uncorrelated with each other and with the distance driven.
double firstSign(std::int64_t i) { return i % 4 == 0 || i % 4 == 3 ? 1 : -1; }
double secondSign(std::int64_t i) { return i % 8 < 4 ? firstSign(i) : -firstSign(i); }

double metres(std::int64_t i) { return static_cast<double>(i); }

using Positions = std::function<Eigen::Vector3d(std::int64_t)>;

Trajectory pathOf(const Positions& position) {
  Trajectory path = test::straightPath(kPoses);
  for (auto& pose : path) pose.T_world_camera.translation() = position(pose.frame);
  return path;
}

/// To the six decimals of a file.
Eigen::Vector3d rounded(const Eigen::Vector3d& p) {
  return {std::round(p.x() * 1e6) / 1e6, std::round(p.y() * 1e6) / 1e6,
          std::round(p.z() * 1e6) / 1e6};
}

Scores scoresOf(const Positions& truth, const Positions& estimate, Alignment alignment) {
  return *score(pathOf(truth), pathOf(estimate), alignment).scores;
}

}  // namespace

TEST_CASE("along a straight road the parts of the error are not told apart") {
  const Eigen::Vector3d along = Eigen::Vector3d(0.6, 0.02, 0.8).normalized();
  const Positions truth = [&](std::int64_t i) { return rounded(static_cast<double>(i) * along); };
  const Positions estimate = [&](std::int64_t i) {
    return rounded(truth(i) + Eigen::Vector3d(0, 0.3 * firstSign(i), 0));
  };
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3}) {
    const Scores scores = scoresOf(truth, estimate, alignment);
    CHECK(scores.ate_m.rmse == Approx(0.3).epsilon(1e-3));
    CHECK(scores.horizontal_m.count == 0);
    CHECK(scores.vertical_m.count == 0);
    CHECK_THAT(scores.no_horizontal, Catch::Contains("how the estimate is turned about it"));
    CHECK(scores.no_vertical == scores.no_horizontal);
  }
  const Scores unaligned = scoresOf(truth, estimate, Alignment::None);
  CHECK(unaligned.vertical_m.rmse == Approx(0.3).epsilon(1e-3));
  CHECK(unaligned.horizontal_m.rmse < 1e-5);
  CHECK(unaligned.no_vertical.empty());
}

TEST_CASE("JSON has nulls and the reason for parts that are not told apart") {
  const Positions truth = [](std::int64_t i) { return Eigen::Vector3d(0, 0, metres(i)); };
  const Positions estimate = [&](std::int64_t i) {
    return Eigen::Vector3d(truth(i) + Eigen::Vector3d(0.1 * firstSign(i), 0, 0));
  };
  const auto json = toJson(score(pathOf(truth), pathOf(estimate), Alignment::Se3));
  CHECK(json["ate"]["rmse_m"].get<double>() == Approx(0.1).epsilon(1e-3));
  CHECK(json["ate"]["reason"].is_null());
  for (const char* part : {"ate_horizontal", "ate_vertical"}) {
    CHECK(json[part]["rmse_m"].is_null());
    CHECK(json[part]["reason"].is_string());
  }
}

TEST_CASE("a bend decides the turn") {
  const Positions truth = [](std::int64_t i) {
    const double angle = 0.05 * static_cast<double>(i);
    return Eigen::Vector3d(20 * std::cos(angle), 0, 20 * std::sin(angle));
  };
  const Positions estimate = [&](std::int64_t i) {
    return Eigen::Vector3d(truth(i) + Eigen::Vector3d(0, 0.3 * firstSign(i), 0));
  };
  const Scores scores = scoresOf(truth, estimate, Alignment::Se3);
  CHECK(scores.vertical_m.rmse == Approx(0.3).epsilon(0.01));
  CHECK(scores.horizontal_m.rmse < 0.03);
  CHECK(scores.no_vertical.empty());
}

// A truth that swings by `a` to the sides and an error of `b` in height: after a quarter turn the
// squared error is 2 a^2 + b^2 instead of b^2, so 5 % are reached at a / b = sqrt(0.1025 / 2).
TEST_CASE("the bound is where a quarter turn changes the error by 5 %") {
  const double bound = std::sqrt(0.1025 / 2);
  for (const double factor : {0.98, 1.02}) {
    const double b = 0.5;
    const double a = factor * bound * b;
    const Positions truth = [&](std::int64_t i) {
      return Eigen::Vector3d(a * firstSign(i), 0, metres(i));
    };
    const Positions estimate = [&](std::int64_t i) {
      return Eigen::Vector3d(truth(i) + Eigen::Vector3d(0, b * secondSign(i), 0));
    };
    const Scores scores = scoresOf(truth, estimate, Alignment::Se3);
    CHECK(scores.ate_m.rmse == Approx(b));
    CHECK(scores.no_vertical.empty() == (factor > 1));
    if (factor > 1) CHECK(scores.vertical_m.rmse == Approx(b));
  }
}

TEST_CASE("where turns about the path move no error, its parts are known") {
  const auto known = [](const Positions& truth, const Eigen::Vector3d& error) {
    const Positions estimate = [&](std::int64_t i) {
      return Eigen::Vector3d(truth(i) + firstSign(i) * error);
    };
    const Scores scores = scoresOf(truth, estimate, Alignment::Se3);
    CHECK(scores.no_horizontal.empty());
    return std::pair(scores.horizontal_m.rmse, scores.vertical_m.rmse);
  };
  const Positions level = [](std::int64_t i) { return Eigen::Vector3d(0, 0, metres(i)); };
  const Positions upwards = [](std::int64_t i) { return Eigen::Vector3d(0, -metres(i), 0); };
  const auto along = known(level, {0, 0, 0.2});
  CHECK(along.first == Approx(0.2).epsilon(1e-3));
  CHECK(along.second < 1e-9);
  const auto across = known(upwards, {0.2, 0, 0});
  CHECK(across.first == Approx(0.2).epsilon(1e-3));
  CHECK(across.second < 1e-2);
  const auto perfect = known(level, {0, 0, 0});
  CHECK(perfect.first < 1e-9);
  CHECK(perfect.second < 1e-9);
}

TEST_CASE("standing still leaves every turn open") {
  const Positions still = [](std::int64_t) { return Eigen::Vector3d::Zero().eval(); };
  const Positions estimate = [](std::int64_t i) {
    return Eigen::Vector3d(0, 0.1 * firstSign(i), 0);
  };
  CHECK_FALSE(scoresOf(still, estimate, Alignment::Se3).no_vertical.empty());
}

// The truth swings by 5 cm to the side, and the estimate by 50 cm in height at the same time: the
// positions agree best after a turn of 84 degrees about the path, which a quarter turn more would
// make worse by 12 %. The orientations are the true ones.
TEST_CASE("a turn that the estimate's own orientations contradict does not divide the error") {
  const Positions truth = [](std::int64_t i) {
    return Eigen::Vector3d(0.05 * firstSign(i), 0, metres(i));
  };
  const Positions estimate = [&](std::int64_t i) {
    return Eigen::Vector3d(truth(i) + Eigen::Vector3d(0, 0.5 * firstSign(i), 0));
  };
  for (const Alignment alignment : {Alignment::Se3, Alignment::Sim3}) {
    const Scores scores = scoresOf(truth, estimate, alignment);
    CHECK(scores.ate_m.rmse == Approx(std::hypot(0.05, 0.5) - 0.05).epsilon(0.01));
    CHECK(scores.horizontal_m.count == 0);
    CHECK(scores.vertical_m.count == 0);
    CHECK_THAT(scores.no_vertical, Catch::Contains("orientations contradict its positions"));
  }
  const Scores unaligned = scoresOf(truth, estimate, Alignment::None);
  CHECK(unaligned.vertical_m.rmse == Approx(0.5));
  CHECK(unaligned.horizontal_m.rmse < 1e-9);
}

TEST_CASE("orientations that differ by less than 10 degrees confirm the turn") {
  for (const double degrees : {9.5, 10.5}) {
    const double height = std::tan(degrees * std::numbers::pi / 180);
    const Positions truth = [](std::int64_t i) {
      return Eigen::Vector3d(0.5 * firstSign(i), 0, metres(i));
    };
    const Positions estimate = [&](std::int64_t i) {
      return Eigen::Vector3d(truth(i) + Eigen::Vector3d(0, 0.5 * height * firstSign(i), 0));
    };
    const Scores scores = scoresOf(truth, estimate, Alignment::Se3);
    CHECK(scores.no_vertical.empty() == (degrees < 10));
  }
}

TEST_CASE("positions that determine the turn refute wrong orientations") {
  const Positions truth = [](std::int64_t i) {
    const double angle = 0.05 * static_cast<double>(i);
    return Eigen::Vector3d(20 * std::cos(angle), 0, 20 * std::sin(angle));
  };
  Trajectory estimate = pathOf(truth);
  for (auto& pose : estimate) {
    pose.T_world_camera.translation().y() += 0.3 * firstSign(pose.frame);
    pose.T_world_camera.rotate(Eigen::AngleAxisd(1.5, Eigen::Vector3d::UnitZ()));
  }
  const Scores scores = *score(pathOf(truth), estimate, Alignment::Se3).scores;
  CHECK(scores.vertical_m.rmse == Approx(0.3).epsilon(0.01));
}

// As odometry drifts: random walks in height and to the side, along nearly straight roads.
TEST_CASE("no random drift along a straight road exchanges the parts of the error") {
  RandomStream random(7);
  int divided = 0;
  for (int road = 0; road < 200; ++road) {
    const double swing = std::pow(10, -3 + 2.5 * random.uniform());
    const double drift = std::pow(10, -2.5 + 1.5 * random.uniform());
    Trajectory truth = test::straightPath(kPoses);
    Trajectory estimate = truth;
    Eigen::Vector3d side = Eigen::Vector3d::Zero(), error = Eigen::Vector3d::Zero();
    for (std::size_t i = 1; i < truth.size(); ++i) {
      side += swing * Eigen::Vector3d(random.normal(), random.normal(), 0);
      error += drift * Eigen::Vector3d(0.1 * random.normal(), random.normal(), 0);
      truth[i].T_world_camera.translation() += side;
      estimate[i].T_world_camera.translation() += side + error;
    }
    const Similarity turn = align(test::paired(truth, estimate), Alignment::Se3).value();
    const Scores scores = *score(truth, estimate, Alignment::Se3).scores;
    if (scores.vertical_m.count == 0) continue;
    ++divided;
    CHECK(turn.R(1, 1) > std::cos(11 * std::numbers::pi / 180));
  }
  CHECK(divided > 20);
}
