// SPDX-License-Identifier: BSD-3-Clause
// The eliminated system against a dense one with all inverse depths, and equal bits for any number
// of threads.
#include "linear_system.hpp"

#include <tbb/global_control.h>

#include <Eigen/Cholesky>
#include <catch2/catch.hpp>

#include "street.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

constexpr double kHold = 1e12;

std::unique_ptr<Window> threeKeyframes(int points) {
  const CameraRig rig = test::streetRig();
  auto window = test::streetWindow(
      {test::streetPose(0), test::streetPose(0.5, 0.01), test::streetPose(1.0, 0.015)});
  test::addTruePoints(*window, points);
  window->prior.H.diagonal().head<8>().setConstant(kHold);
  window->prior.H.diagonal().tail<kFieldVariables>().setConstant(1e4);
  window->field.configure(rig.width, rig.height, rig.pinhole.fx, rig.pinhole.fx * rig.baseline, 4);
  window->field.setOn(true);
  // Off the optimum, so that there is a step.
  window->keyframe(1).T0_camera_world =
      expSe3((Vector6d() << 0.01, -0.005, 0.01, 0.001, 0.001, 0).finished()) *
      window->keyframe(1).T0_camera_world;
  return window;
}

/// Normal equations of everything, depths included, from one residual after the other.
struct Dense {
  Eigen::MatrixXd H;
  Eigen::VectorXd b;
};

/// Inverse depth of the point in `target` when its keyframes and depth change by `x`: two twists,
/// then the depth; at the first estimates.
double sightedDepth(const Pinhole& camera, const Keyframe& host, const Keyframe& target,
                    const Point& point, const Eigen::Matrix<double, 13, 1>& x) {
  const Eigen::Isometry3d T_target_world = expSe3(Vector6d(x.head<6>())) * target.T0_camera_world;
  const Eigen::Isometry3d T_host_world = expSe3(Vector6d(x.segment<6>(6))) * host.T0_camera_world;
  const double d = point.inverse_depth + x[12];
  const Eigen::Vector3d ray((point.u - camera.cx) / camera.fx, (point.v - camera.cy) / camera.fy,
                            1);
  return 1 / (T_target_world * T_host_world.inverse() * Eigen::Vector3d(ray / d)).z();
}

/// Derivatives of the column in the right image by the coefficients, by finite differences.
Eigen::RowVectorXd byField(const CameraRig& rig, const DisparityField& field, const Point& point) {
  constexpr double kStep = 1e-6;  // px
  const double disparity = rig.pinhole.fx * rig.baseline * point.inverse_depth;
  const auto moved = [&](int coefficient, double step) {
    DisparityField other = field;
    other.move(step * DisparityField::Terms::Unit(coefficient));
    return other.at(point.u - disparity, point.v, disparity);
  };
  Eigen::RowVectorXd J(kFieldVariables);
  for (int i = 0; i < kFieldVariables; ++i) {
    J[i] = (moved(i, kStep) - moved(i, -kStep)) / (2 * kStep);
  }
  return J;
}

/// The residual in the right image of the newest other keyframe that sees the point; derivatives
/// are finite differences.
void addSighting(const CameraRig& rig, float lambda, const Window& window, int host,
                 const Point& point, Eigen::Index p, Dense& dense) {
  int target = -1;
  PixelSums s;
  for (const int slot : window.order()) {
    if (slot == host) continue;
    const PairGeometry pair =
        pairGeometry(rig.pinhole, window.keyframe(host), window.keyframe(slot));
    const bool seen = test::sumsIn(pair, window.keyframe(slot).left.level(0), point, s) &&
                      s.energy <= window.energy_threshold && s.xx + s.yy >= 2;
    if (seen) target = slot;
  }
  if (target < 0) return;
  const Keyframe& h = window.keyframe(host);
  const Keyframe& t = window.keyframe(target);
  const Eigen::Vector3d P =
      t.T_camera_world() * h.T_world_camera() *
      Eigen::Vector3d((point.u - rig.pinhole.cx) / rig.pinhole.fx / point.inverse_depth,
                      (point.v - rig.pinhole.cy) / rig.pinhole.fy / point.inverse_depth,
                      1 / point.inverse_depth);
  const Eigen::Vector2d pixel = rig.pinhole.project(P);
  const auto u = static_cast<int>(std::lround(pixel.x()));
  const auto v = static_cast<int>(std::lround(pixel.y()));
  if (!t.left.level(0).contains(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()),
                                kPatternRadius + 2)) {
    return;
  }
  Point seen;
  seen.u = static_cast<float>(u);
  seen.v = static_cast<float>(v);
  seen.inverse_depth = static_cast<float>(1 / P.z());
  seen.pattern = patternAt(t.left.level(0), u, v);
  const double fb = rig.pinhole.fx * rig.baseline;
  const StereoGeometry stereo{static_cast<float>(fb), 0, 1, 0};
  const bool good = stereoSums(stereo, t.right.level(0), seen, s) &&
                    s.energy <= window.energy_threshold && s.xx >= 2;
  if (!good) return;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(1, dense.H.cols());
  for (int i = 0; i < 13; ++i) {
    Eigen::Matrix<double, 13, 1> x = Eigen::Matrix<double, 13, 1>::Zero();
    x[i] = 1e-6;
    const double change =
        sightedDepth(rig.pinhole, h, t, point, x) - sightedDepth(rig.pinhole, h, t, point, -x);
    const Eigen::Index column = i < 6 ? 8 * target + i : i < 12 ? 8 * host + i - 6 : p;
    J(0, column) = -fb * change / 2e-6;
  }
  J.middleCols<kFieldVariables>(kOffsetIndex) = byField(rig, window.field, seen);
  dense.H += J.transpose() * (lambda * s.xx) * J;
  dense.b += J.transpose() * (lambda * s.xr);
}

Dense denseSystem(const CameraRig& rig, float lambda, Window& window) {
  const auto points = static_cast<Eigen::Index>(window.pointCount());
  Dense dense{Eigen::MatrixXd::Zero(kVariables + points, kVariables + points),
              Eigen::VectorXd::Zero(kVariables + points)};
  // Rows of derivatives by all variables for the two image directions, and by a and b.
  const auto add = [&](const Eigen::MatrixXd& J, const Eigen::MatrixXd& W,
                       const Eigen::VectorXd& g) {
    dense.H += J.transpose() * W * J;
    dense.b += J.transpose() * g;
  };
  Eigen::Index p = kVariables;
  const double fb = rig.pinhole.fx * rig.baseline;
  for (const int host : window.order()) {
    for (Point& point : window.keyframe(host).points) {
      PixelSums s;
      for (const int target : window.order()) {
        if (target == host) continue;
        const PairGeometry pair =
            pairGeometry(rig.pinhole, window.keyframe(host), window.keyframe(target));
        if (!test::sumsIn(pair, window.keyframe(target).left.level(0), point, s)) continue;
        if (s.energy > window.energy_threshold || s.xx + s.yy < 2) continue;
        const CentreJacobian C =
            centreJacobian(rig.pinhole, pair, point.u, point.v, point.inverse_depth);
        Eigen::MatrixXd relative = Eigen::MatrixXd::Zero(4, 8);
        for (int i = 0; i < 6; ++i) {
          relative(0, i) = C.u_by_twist[static_cast<std::size_t>(i)];
          relative(1, i) = C.v_by_twist[static_cast<std::size_t>(i)];
        }
        relative(2, 6) = relative(3, 7) = 1;
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(4, dense.H.cols());
        J.middleCols(8 * target, 8) = relative;
        J.middleCols(8 * host, 8) = relative * pair.relative_by_host.cast<double>();
        J(0, p) = C.u_by_depth;
        J(1, p) = C.v_by_depth;
        Eigen::Matrix4d W;             // gradient u, gradient v, by a, by b
        W << s.xx, s.xy, s.xa, -s.x1,  //
            s.xy, s.yy, s.ya, -s.y1,   //
            s.xa, s.ya, s.aa, -s.a1,   //
            -s.x1, -s.y1, -s.a1, s.w;
        add(J, W, Eigen::Vector4d(s.xr, s.yr, s.ar, -s.r1));
      }
      const StereoGeometry stereo{static_cast<float>(fb), 0, 1, 0};
      if (stereoSums(stereo, window.keyframe(host).right.level(0), point, s) &&
          s.energy <= window.energy_threshold && s.xx >= 2) {
        Eigen::MatrixXd J = Eigen::MatrixXd::Zero(1, dense.H.cols());
        J(0, p) = -fb;
        J.middleCols<kFieldVariables>(kOffsetIndex) = byField(rig, window.field, point);
        add(J, Eigen::MatrixXd::Constant(1, 1, lambda * s.xx),
            Eigen::VectorXd::Constant(1, lambda * s.xr));
      }
      addSighting(rig, lambda, window, host, point, p, dense);
      dense.H(p, p) += 1e-3;
      ++p;
    }
  }
  return dense;
}

Eigen::VectorXd solveDense(const Window& window, Dense dense) {
  dense.H.topLeftCorner<kVariables, kVariables>() += window.prior.H;
  for (Eigen::Index i = 0; i < dense.H.rows(); ++i) {
    if (!(dense.H(i, i) > 0)) dense.H(i, i) = 1;
  }
  const Eigen::VectorXd scale = dense.H.diagonal().array().rsqrt();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * dense.H * scale.asDiagonal();
  return -scale.cwiseProduct(scaled.ldlt().solve(scale.cwiseProduct(dense.b)));
}

}  // namespace

TEST_CASE("eliminating the depths changes nothing: steps agree with the dense system") {
  const CameraRig rig = test::streetRig();
  const auto window = threeKeyframes(40);
  const SystemSettings settings{1.5F};
  const Dense dense = denseSystem(rig, settings.lambda, *window);
  const Eigen::VectorXd expected = solveDense(*window, dense);
  LinearSystem system;
  system.build(rig, settings, *window, allPoints(*window));
  CHECK(system.residuals() > 200);
  const SystemVector step = solve(*window, system.H(), system.b());
  for (const int slot : window->order()) {
    CAPTURE(slot, step.segment<8>(8 * slot).transpose(), expected.segment<8>(8 * slot).transpose());
    CHECK((step - expected.head<kVariables>()).segment<6>(8 * slot).norm() < 3e-5);
  }
  for (int i = kOffsetIndex; i < kVariables; ++i) {
    CHECK(step[i] == Approx(expected[i]).margin(1e-3));
  }
  CHECK(step.segment<6>(8).norm() > 1e-3);

  std::vector<float> before;
  for (const int slot : window->order()) {
    for (const Point& point : window->keyframe(slot).points) before.push_back(point.inverse_depth);
  }
  system.applyToDepths(*window, step);
  std::size_t i = 0;
  for (const int slot : window->order()) {
    for (const Point& point : window->keyframe(slot).points) {
      const double change = expected[kVariables + static_cast<Eigen::Index>(i)];
      // Large steps are cut off, which the dense system does not do.
      if (std::abs(change) < 0.3 * before[i]) {
        CHECK(point.inverse_depth - before[i] == Approx(change).margin(2e-4));
      }
      ++i;
    }
  }
}

TEST_CASE("the system has the same bits for one, two and four threads") {
  const CameraRig rig = test::streetRig();
  std::vector<SystemMatrix> H;
  std::vector<SystemVector> b;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    const auto window = threeKeyframes(500);
    LinearSystem system;
    system.build(rig, {1.0F}, *window, allPoints(*window));
    H.push_back(system.H());
    b.push_back(system.b());
  }
  for (std::size_t i = 1; i < H.size(); ++i) {
    CHECK(H[i] == H[0]);
    CHECK(b[i] == b[0]);
  }
}

TEST_CASE("H is symmetric and, with the gauge held, positive definite: the scale is observed") {
  const CameraRig rig = test::streetRig();
  const auto window = threeKeyframes(200);
  LinearSystem system;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  CHECK((system.H() - system.H().transpose()).norm() < 1e-6 * system.H().norm());
  const SystemMatrix H = system.H() + window->prior.H;
  const auto held = H.topLeftCorner<24, 24>().eval();
  CHECK(Eigen::LLT<Eigen::Matrix<double, 24, 24>>(held).info() == Eigen::Success);
  // Moving all cameras along with the scene's scale costs energy, but only with static stereo.
  SystemVector scale = SystemVector::Zero();
  for (const int slot : window->order()) {
    const Keyframe& keyframe = window->keyframe(slot);
    scale.segment<3>(8 * slot) = keyframe.T0_camera_world.translation();
  }
  const double with_stereo = scale.dot(system.H() * scale);
  LinearSystem temporal;
  temporal.build(rig, {0.0F}, *window, allPoints(*window));
  const double without = scale.dot(temporal.H() * scale);
  CHECK(with_stereo > 20 * std::abs(without));
}

TEST_CASE("residuals without a right image or out of view leave the system") {
  const CameraRig rig = test::streetRig();
  const auto window = threeKeyframes(60);
  LinearSystem system;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  const int all = system.residuals();
  for (Point& point : window->keyframe(0).points) point.stereo = ResidualState::Absent;
  system.build(rig, {1.0F}, *window, allPoints(*window));
  CHECK(system.residuals() < all);
  int outside = 0;
  for (const Point& point : window->keyframe(0).points) {
    outside += point.temporal[2] == ResidualState::Outside ? 1 : 0;
  }
  CHECK(outside > 0);  // near points leave the view of the last keyframe
  system.storeInformation(*window);
  for (const Point& point : window->keyframe(1).points) {
    CHECK((point.information > 0) == (point.seen_good > 0));
  }
  CHECK(system.outlierThreshold() >= 13 * 13);
}

TEST_CASE("variables without residuals and the oldest keyframe stay") {
  constexpr int k = kFrameVariables;  // of the second keyframe
  Window window;
  window.add();
  window.add();
  SystemMatrix H = SystemMatrix::Zero();
  SystemVector b = SystemVector::Zero();
  H(0, 0) = H(k, k) = 4;
  H(k + 1, k + 1) = 1e6;
  b[0] = b[k] = -8;
  b[k + 1] = 1e6;
  b[k + 2] = 5;  // of a variable that nothing observes
  const SystemVector step = solve(window, H, b);
  CHECK(step.head<k>().isZero(0));
  CHECK(step[k] == Approx(2));
  CHECK(step[k + 1] == Approx(-1));
  CHECK(step.tail<kVariables - k - 2>().isZero(0));
}

TEST_CASE("a free scale stays: the window does not grow, and all else moves as it would") {
  const auto window = test::streetWindow(
      {test::streetPose(0), test::streetPose(0.6, 0.01), test::streetPose(1.3, -0.01)});
  for (const int slot : window->order()) window->keyframe(slot).has_right = false;
  test::addTruePoints(*window, 200);
  for (const int slot : window->order()) {
    for (Point& point : window->keyframe(slot).points) point.stereo = ResidualState::Absent;
  }
  LinearSystem system;
  system.build(test::streetRig(), {}, *window, allPoints(*window));
  const SystemVector larger = scaleDirection(*window);
  // Nothing sees it: against a step of the same size in any single variable.
  const double seen = larger.dot(system.H() * larger);
  const auto second = static_cast<Eigen::Index>(kFrameVariables * window->order()[1]);
  CHECK(seen < 1e-4 * system.H()(second, second));
  const SystemVector held = solve(*window, system.H(), system.b(), Scale::Free);
  CHECK(std::abs(held.dot(larger)) < 1e-6);
  // Rounding that pushes along it moves a free system by metres, a held one hardly.
  const SystemVector pushed = system.b() - 1e-6 * system.H().norm() * larger;
  const SystemVector moved = solve(*window, system.H(), pushed, Scale::Free);
  const SystemVector loose = solve(*window, system.H(), pushed);
  CHECK((moved - held).norm() < 0.01);
  CHECK(std::abs(loose.dot(larger)) > 10 * (moved - held).norm());
}

TEST_CASE("a step of the field does not act like a common factor of the disparities") {
  const CameraRig rig = test::streetRig();
  const auto window = threeKeyframes(400);
  LinearSystem system;
  system.build(rig, SystemSettings{1.5F}, *window, allPoints(*window));
  const SmoothField::Terms factor = system.moments().factorDirection();
  const SystemVector free_step = solve(*window, system.H(), system.b());
  CHECK(std::abs(factor.dot(free_step.tail<kFieldVariables>())) > 1e-3);
  window->moments.add(system.moments());
  const SystemVector step = solve(*window, system.H(), system.b());
  CHECK(factor.dot(step.tail<kFieldVariables>()) == Approx(0).margin(1e-5));
  CHECK(step.tail<kFieldVariables>().norm() > 1e-3);
}

TEST_CASE("while the field is off only its offset moves; what it would be is known") {
  const CameraRig rig = test::streetRig();
  const auto window = threeKeyframes(400);
  LinearSystem system;
  system.build(rig, SystemSettings{1.5F}, *window, allPoints(*window));
  const SystemVector on = solve(*window, system.H(), system.b());
  window->field.setOn(false);
  const SmoothField would_be = fieldIfOn(*window, system.H(), system.b());
  CHECK(would_be.coefficients == on.tail<kFieldVariables>());
  const SystemVector off = solve(*window, system.H(), system.b());
  CHECK(off.tail<kFieldVariables - 1>().isZero(0));
  // The same as with coefficients that a prior holds.
  window->field.setOn(true);
  window->prior.H.diagonal().tail<kFieldVariables - 1>().setConstant(1e13);
  const SystemVector held = solve(*window, system.H(), system.b());
  CHECK((off - held).norm() < 1e-6);
  CHECK(off[kOffsetIndex] == Approx(held[kOffsetIndex]));
}
