// SPDX-License-Identifier: BSD-3-Clause
// A random walk in a box, and gridness (Sargolini et al. 2006) written from its definition: the
// autocorrelogram of a rate map, a ring of the six nearest peaks, and its correlation with itself
// turned bin by bin. Nothing of it is shared with framework/evaluation.
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

#include "tolman/context.hpp"
#include "tolman/geometry.hpp"

namespace tolman::test {

/// Steps of an animal that runs and turns at random and turns away from the walls of a square.
class BoxWalk {
 public:
  BoxWalk(double side, double step, std::uint64_t seed) : side_(side), step_(step), random_(seed) {}

  /// The motion of the next step. The walk starts in the middle.
  PlanarPose next() {
    double turn = 0.25 * random_.normal();
    PlanarPose to = compose(pose_, {step_, 0, turn});
    while (std::max(std::abs(to.x), std::abs(to.y)) > side_ / 2) {
      turn = random_.uniform(-3.1, 3.1);
      pose_.theta += turn;
      turned_ += turn;
      to = compose(pose_, {step_, 0, 0});
    }
    const PlanarPose motion = compose({0, 0, turned_}, between(pose_, to));
    turned_ = 0;
    pose_ = to;
    return motion;
  }
  const PlanarPose& pose() const { return pose_; }

 private:
  double side_, step_;
  RandomStream random_;
  PlanarPose pose_;
  double turned_ = 0;
};

/// Mean rates in bins of a square box round 0.
class BoxMap {
 public:
  BoxMap(double side, int bins)
      : side_(side), bins_(bins), sum_(Eigen::MatrixXd::Zero(bins, bins)), visits_(sum_) {}
  void add(const PlanarPose& at, double rate) {
    const auto bin = [&](double x) {
      return std::clamp(static_cast<int>((x / side_ + 0.5) * bins_), 0, bins_ - 1);
    };
    sum_(bin(at.x), bin(at.y)) += rate;
    visits_(bin(at.x), bin(at.y)) += 1;
  }
  Eigen::MatrixXd rates() const { return sum_.array() / visits_.array().max(1); }

 private:
  double side_;
  int bins_;
  Eigen::MatrixXd sum_, visits_;
};

inline double pearson(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<Eigen::Index>(a.size());
  const Eigen::ArrayXd x = Eigen::Map<const Eigen::ArrayXd>(a.data(), n);
  const Eigen::ArrayXd y = Eigen::Map<const Eigen::ArrayXd>(b.data(), n);
  const Eigen::ArrayXd p = x - x.mean();
  const Eigen::ArrayXd q = y - y.mean();
  return (p * q).sum() / std::sqrt((p * p).sum() * (q * q).sum());
}

/// Correlations of all displacements up to two thirds of the box.
inline Eigen::MatrixXd naiveAutocorrelogram(const Eigen::MatrixXd& map, int reach) {
  const auto n = static_cast<int>(map.rows());
  Eigen::MatrixXd r(2 * reach + 1, 2 * reach + 1);
  for (int dx = -reach; dx <= reach; ++dx) {
    for (int dy = -reach; dy <= reach; ++dy) {
      std::vector<double> a, b;
      for (int i = std::max(0, -dx); i < std::min(n, n - dx); ++i) {
        for (int j = std::max(0, -dy); j < std::min(n, n - dy); ++j) {
          a.push_back(map(i, j));
          b.push_back(map(i + dx, j + dy));
        }
      }
      r(dx + reach, dy + reach) = pearson(a, b);
    }
  }
  return r;
}

/// Correlation of the ring with itself turned by an angle, at the nearest bins.
inline double turnedCorrelation(const Eigen::MatrixXd& r, double inner, double outer,
                                double degrees) {
  const auto reach = static_cast<int>(r.rows() / 2);
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  std::vector<double> a, b;
  for (int x = -reach; x <= reach; ++x) {
    for (int y = -reach; y <= reach; ++y) {
      const double away = std::hypot(x, y);
      if (away < inner || away > outer) continue;
      const int i = reach + static_cast<int>(std::lround(c * x - s * y));
      const int j = reach + static_cast<int>(std::lround(s * x + c * y));
      if (i < 0 || j < 0 || i > 2 * reach || j > 2 * reach) continue;
      a.push_back(r(reach + x, reach + y));
      b.push_back(r(i, j));
    }
  }
  return pearson(a, b);
}

struct OracleScores {
  double hexagonal;  ///< min(60, 120) - max(30, 90, 150)
  double square;     ///< 90 - max(45, 135)
};
/// `period` in bins: the ring is from half of it to one and a quarter.
inline OracleScores oracleScores(const Eigen::MatrixXd& map, double period) {
  const Eigen::MatrixXd r = naiveAutocorrelogram(map, static_cast<int>(1.25 * period) + 1);
  const auto at = [&](double degrees) {
    return turnedCorrelation(r, 0.5 * period, 1.25 * period, degrees);
  };
  return {std::min(at(60), at(120)) - std::max({at(30), at(90), at(150)}),
          at(90) - std::max(at(45), at(135))};
}

}  // namespace tolman::test
