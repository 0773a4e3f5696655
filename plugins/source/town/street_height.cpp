// SPDX-License-Identifier: BSD-3-Clause
// Heights of the road from the heights of the driven path.
#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "street_grids.hpp"

namespace tolman::town {
namespace {

/// Two points of different passes at the same place, whose heights must agree.
struct Meeting {
  std::size_t a = 0;
  std::size_t b = 0;
  double weight = 0;
};

constexpr double kMeets = 6;            ///< m between driven points
constexpr double kMeetingScale = 3;     ///< m, of the weight by distance
constexpr double kSameLevel = 1.5;      ///< m
constexpr double kBeyondWeight = 0.01;  ///< weight of heights without a pose

/// Whether points can meet: decks only with decks of the same level.
bool mayMeet(const PathPoint& a, const PathPoint& b) {
  if (!a.raised && !b.raised) return true;
  return a.raised && b.raised && std::abs(a.height - b.height) < kSameLevel;
}

/// For each point the nearest one of every earlier pass.
std::vector<Meeting> findMeetings(const std::vector<PathPoint>& path) {
  std::vector<Meeting> meetings;
  PointGrid grid;
  for (std::size_t i = 0; i < path.size(); ++i) {
    std::vector<std::size_t> others = grid.near(path[i].driven);
    std::sort(others.begin(), others.end());
    std::size_t previous = 0;
    double nearest = kMeets;
    for (const std::size_t other : others) {
      if (!isOtherPass(path[i], path[other]) || !mayMeet(path[i], path[other])) continue;
      const double apart = (path[i].driven - path[other].driven).norm();
      if (apart >= kMeets) continue;
      const double scaled = apart / kMeetingScale;
      const Meeting meeting{i, other, std::exp(-scaled * scaled / 2)};
      const bool same_pass = !meetings.empty() && meetings.back().a == i && other - previous <= 3;
      if (!same_pass) {
        meetings.push_back(meeting);
        nearest = apart;
      } else if (apart < nearest) {
        meetings.back() = meeting;
        nearest = apart;
      }
      previous = other;
    }
    grid.add(path[i].driven, i);
  }
  return meetings;
}

/// Adds the entries of weight * (c_i-1 - 2 c_i + c_i+1)^2.
void addBending(std::vector<Eigen::Triplet<double>>& entries, std::size_t i, double weight) {
  constexpr std::array<double, 3> kDifference = {1, -2, 1};
  for (int a = 0; a < 3; ++a) {
    for (int b = 0; b < 3; ++b) {
      entries.emplace_back(static_cast<int>(i) - 1 + a, static_cast<int>(i) - 1 + b,
                           weight * kDifference[static_cast<std::size_t>(a)] *
                               kDifference[static_cast<std::size_t>(b)]);
    }
  }
}

}  // namespace

// Corrections c of the heights z minimise
//   sum w c_i^2 + L^2 sum (c_i+1 - c_i)^2 + sum W (z_a + c_a - z_b - c_b)^2,
// with points 1 m apart. A single correction decays along the street as exp(-distance / L). With
// is_stiff the second term is L^4 sum (c_i-1 - 2 c_i + c_i+1)^2.
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path,
                                   const HeightAgreement& agreement) {
  const auto n = static_cast<Eigen::Index>(path.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto tie = [&](std::size_t a, std::size_t b, double weight) {
    const auto i = static_cast<int>(a);
    const auto j = static_cast<int>(b);
    entries.insert(entries.end(),
                   {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    return weight;
  };
  for (std::size_t i = 0; i < path.size(); ++i) {
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i),
                         path[i].driven_over ? 1 : kBeyondWeight);
    const double bend = agreement.bend_length * agreement.bend_length;
    if (!agreement.is_stiff && i + 1 < path.size()) tie(i, i + 1, bend);
    if (agreement.is_stiff && i > 0 && i + 1 < path.size()) addBending(entries, i, bend * bend);
  }
  for (const Meeting& meeting : findMeetings(path)) {
    const double pull = tie(meeting.a, meeting.b, agreement.weight * meeting.weight) *
                        (path[meeting.b].height - path[meeting.a].height);
    right[static_cast<Eigen::Index>(meeting.a)] += pull;
    right[static_cast<Eigen::Index>(meeting.b)] -= pull;
  }
  Eigen::SparseMatrix<double> normal(n, n);
  normal.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd corrections = Eigen::SimplicialLDLT<decltype(normal)>(normal).solve(right);
  std::vector<double> heights(path.size());
  for (std::size_t i = 0; i < path.size(); ++i) {
    heights[i] = path[i].height + corrections[static_cast<Eigen::Index>(i)];
  }
  return heights;
}

}  // namespace tolman::town
