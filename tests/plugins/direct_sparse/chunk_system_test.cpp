// SPDX-License-Identifier: BSD-3-Clause
// Sums of one point's residuals against the products of plain matrices, and its elimination.
#include "chunk_system.hpp"

#include <Eigen/Dense>
#include <catch2/catch.hpp>

#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::direct_sparse;

namespace {

/// Eight pixels with gradients, scene values and residuals, and what they sum up to.
struct Pixels {
  Eigen::Matrix<float, 8, 4> J;  ///< gradient u, gradient v, by a, by b
  Eigen::Matrix<float, 8, 1> w;
  Eigen::Matrix<float, 8, 1> r;

  explicit Pixels(std::uint64_t seed) {
    RandomStream random(seed);
    const auto draw = [&random](double size) {
      return static_cast<float>(random.uniform(-size, size));
    };
    for (int k = 0; k < 8; ++k) {
      J.row(k) << draw(20), draw(20), -50 + draw(30), -1;
      w[k] = 0.5F + std::fabs(draw(0.5));
      r[k] = draw(8);
    }
  }
  PixelSums sums() const {
    const Eigen::Matrix4f A = J.transpose() * w.asDiagonal() * J;
    const Eigen::Vector4f g = J.transpose() * w.asDiagonal() * r;
    PixelSums s;
    s.xx = A(0, 0);
    s.xy = A(0, 1);
    s.yy = A(1, 1);
    s.xa = A(0, 2);
    s.ya = A(1, 2);
    s.x1 = -A(0, 3);
    s.y1 = -A(1, 3);
    s.aa = A(2, 2);
    s.a1 = -A(2, 3);
    s.w = A(3, 3);
    s.xr = g[0];
    s.yr = g[1];
    s.ar = g[2];
    s.r1 = -g[3];
    s.energy = (r.array().square() * w.array()).sum();
    return s;
  }
};

/// Derivatives of a column by the field; the first is not one where an offset is compensated.
ChunkSystem::FieldTerms someTerms() {
  ChunkSystem::FieldTerms terms;
  terms << 0.9F, 0.3F, -0.4F, 0.2F, -0.7F, 0.1F, 0.5F, -0.2F, 0.6F, -0.8F;
  return terms;
}

CentreJacobian someJacobian() {
  CentreJacobian C;
  C.u_by_twist = {30, 0, -4, -20, 700, -15};
  C.v_by_twist = {0, 30, -3, -710, 20, 12};
  C.u_by_depth = 55;
  C.v_by_depth = -20;
  return C;
}

PairGeometry somePair() {
  PairGeometry pair;
  pair.relative_by_host = -Matrix8f::Identity();
  pair.relative_by_host(0, 4) = 0.3F;
  pair.relative_by_host(2, 3) = -0.2F;
  pair.relative_by_host(7, 7) = -1.1F;
  return pair;
}

/// Derivatives of the eight pixels by the relative variables, and by the inverse depth.
Eigen::Matrix<float, 8, 9> derivatives(const Pixels& pixels, const CentreJacobian& C) {
  Eigen::Matrix<float, 8, 9> D;
  for (int k = 0; k < 8; ++k) {
    for (int i = 0; i < 6; ++i) {
      D(k, i) = pixels.J(k, 0) * C.u_by_twist[static_cast<std::size_t>(i)] +
                pixels.J(k, 1) * C.v_by_twist[static_cast<std::size_t>(i)];
    }
    D(k, 6) = pixels.J(k, 2);
    D(k, 7) = pixels.J(k, 3);
    D(k, 8) = pixels.J(k, 0) * C.u_by_depth + pixels.J(k, 1) * C.v_by_depth;
  }
  return D;
}

}  // namespace

TEST_CASE("a residual's blocks are those of its pixels' derivatives") {
  const Pixels pixels(4);
  const CentreJacobian C = someJacobian();
  const auto D = derivatives(pixels, C);
  const Eigen::Matrix<float, 9, 9> H = D.transpose() * pixels.w.asDiagonal() * D;
  const Eigen::Matrix<float, 9, 1> g = D.transpose() * pixels.w.asDiagonal() * pixels.r;
  ChunkSystem system;
  PointTerms terms;
  system.clear(2);
  system.addTemporal(5, somePair(), pixels.sums(), C, terms);
  CHECK(system.hasTarget(5));
  CHECK_FALSE(system.hasTarget(2));
  const auto& block = system.relative(5);
  for (std::size_t r = 0; r < 8; ++r) {
    for (std::size_t c = r; c < 8; ++c) {
      const float expected = H(static_cast<int>(r), static_cast<int>(c));
      CHECK(block[r][c] == Approx(expected).epsilon(1e-3).margin(1));
    }
    CHECK(block[r][8] == Approx(g[static_cast<int>(r)]).epsilon(1e-3).margin(1));
  }
  CHECK(terms.information == Approx(H(8, 8)).epsilon(1e-3));
  CHECK(terms.gradient == Approx(g[8]).epsilon(1e-3));
  const Vector8f by_host = somePair().relative_by_host.transpose() * H.col(8).head<8>();
  for (int i = 0; i < 8; ++i) {
    CHECK(terms.coupling[static_cast<std::size_t>(40 + i)] == Approx(H(i, 8)).epsilon(1e-3));
    CHECK(terms.coupling[static_cast<std::size_t>(16 + i)] == Approx(by_host[i]).epsilon(1e-3));
  }
  CHECK(terms.slots == ((1U << 5) | (1U << 2)));
  CHECK(terms.good == 1);
}

TEST_CASE("a static residual couples the depth with the field of disparity errors alone") {
  ChunkSystem system;
  PointTerms terms;
  system.clear(0);
  PixelSums sums;
  sums.xx = 30;
  sums.xr = -6;
  const ChunkSystem::FieldTerms by_field = someTerms();
  system.addStereo(sums, 400, 1.5F, by_field, terms);
  CHECK(terms.information == Approx(400.0F * 400 * 1.5F * 30));
  CHECK(terms.gradient == Approx(400 * 1.5F * 6));
  for (int i = 0; i < kFieldVariables; ++i) {
    const auto column = static_cast<std::size_t>(kOffsetIndex + i);
    CHECK(terms.coupling[column] == Approx(-400 * 1.5F * 30 * by_field[i]));
    CHECK(system.field_gradient[i] == Approx(-9 * by_field[i]));
    for (int k = 0; k < kFieldVariables; ++k) {
      CHECK(system.field_information(i, k) == Approx(45 * by_field[i] * by_field[k]));
    }
  }
  CHECK(terms.slots == 0);
}

TEST_CASE("elimination is the Schur complement of the depth") {
  ChunkSystem system;
  PointTerms terms;
  system.clear(1);
  system.addTemporal(3, somePair(), Pixels(9).sums(), someJacobian(), terms);
  system.addTemporal(6, somePair(), Pixels(10).sums(), someJacobian(), terms);
  PixelSums stereo;
  stereo.xx = 0.02F;
  stereo.xr = 0.01F;
  system.addStereo(stereo, 300, 1, someTerms(), terms);
  system.eliminate({&terms, 1});
  for (std::size_t r = 0; r < kVariables; ++r) {
    for (std::size_t c = r; c < kVariables; ++c) {
      const float expected = terms.coupling[r] * terms.coupling[c] / terms.information;
      CHECK(system.schur()[r][c] == Approx(expected).epsilon(1e-3).margin(1e-3));
    }
    CHECK(
        system.schurGradient(r) ==
        Approx(terms.coupling[r] * terms.gradient / terms.information).epsilon(1e-3).margin(1e-3));
  }
}

TEST_CASE("residuals are judged by energy and gradient") {
  ChunkSystem system;
  system.clear(0);
  PixelSums sums;
  sums.xx = 10;
  sums.energy = 80;
  CHECK(system.judge(sums, 100) == ResidualState::Good);
  sums.energy = 120;
  CHECK(system.judge(sums, 100) == ResidualState::Outlier);
  sums.energy = 5;
  sums.xx = 1;
  CHECK(system.judge(sums, 100) == ResidualState::Outlier);  // nothing to see
  CHECK(system.residuals == 1);
  CHECK(system.energy == Approx(80 + 100 + 5));
  CHECK(system.histogram[8] == 1);
  CHECK(system.histogram[10] == 1);
}
