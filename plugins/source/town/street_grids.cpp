// SPDX-License-Identifier: BSD-3-Clause
// Distances to the streets, and heights of the road from those of the driven path.
#include <oneapi/tbb/parallel_for.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "ground_grid.hpp"

namespace tolman::town {
namespace {

constexpr double kFinestCell = 0.5;     ///< m
constexpr double kMaxCells = 16e6;      ///< of 4 bytes
constexpr int kBlock = 16;              ///< cells
constexpr double kMeets = 6;            ///< m between driven points
constexpr double kMeetingScale = 3;     ///< m, of the weight by distance
constexpr double kSameLevel = 1.5;      ///< m
constexpr double kBeyondWeight = 0.01;  ///< weight of heights without a pose
constexpr double kMeetingWeight = 200;  ///< that of a measured height is 1
constexpr double kBendLength = 15;      ///< m, over which a correction fades out along the street

struct Segment {
  Eigen::Vector2d start;
  Eigen::Vector2d along;
  double inverse_squared_length;

  double squaredDistance(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d from_start = place - start;
    const double t = std::clamp(from_start.dot(along) * inverse_squared_length, 0.0, 1.0);
    return (from_start - t * along).squaredNorm();
  }
};

std::vector<Segment> centrelines(const std::vector<PathPoint>& path) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const PathPoint& next = path[std::min(i + 1, path.size() - 1)];
    if (path[i].raised || next.raised) continue;
    const Eigen::Vector2d along = next.centre - path[i].centre;
    const double squared = along.squaredNorm();
    segments.push_back({path[i].centre, along, squared > 0 ? 1 / squared : 0});
  }
  return segments;
}

/// Two points of different passes at the same place, whose heights must agree.
struct Meeting {
  std::size_t a = 0;
  std::size_t b = 0;
  double weight = 0;
};

/// Whether points can meet: floors only with floors of the same level.
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
      previous = other;
      if (same_pass && apart >= nearest) continue;
      if (same_pass) meetings.pop_back();
      meetings.push_back(meeting);
      nearest = apart;
    }
    grid.add(path[i].driven, i);
  }
  return meetings;
}

}  // namespace

GroundGrid distanceGrid(const std::vector<PathPoint>& path, const GridExtent& extent,
                        double farthest) {
  const Eigen::Vector2d size = extent.high - extent.low;
  const double cell = std::max(kFinestCell, std::sqrt(size.prod() / kMaxCells));
  GroundGrid grid(extent.low, extent.high, cell, static_cast<float>(farthest));
  const std::vector<Segment> segments = centrelines(path);
  const double half_diagonal = cell * kBlock * std::numbers::sqrt2 / 2;
  // By blocks of cells: only segments that are not much farther from the middle of a block than the
  // nearest one can be nearest to one of its cells.
  const auto fill = [&](int first_column, int first_row, std::vector<double>& squared) {
    const Eigen::Vector2d middle =
        grid.position(first_column, first_row) + Eigen::Vector2d::Constant(cell * kBlock / 2);
    double limit = farthest * farthest;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      squared[i] = segments[i].squaredDistance(middle);
      limit = std::min(limit, squared[i]);
    }
    limit = std::pow(std::sqrt(limit) + 2 * half_diagonal, 2);
    std::vector<Segment> near;
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (squared[i] <= limit) near.push_back(segments[i]);
    }
    for (int row = first_row; row < std::min(first_row + kBlock, grid.rows()); ++row) {
      for (int c = first_column; c < std::min(first_column + kBlock, grid.columns()); ++c) {
        double nearest = farthest * farthest;
        for (const Segment& segment : near) {
          nearest = std::min(nearest, segment.squaredDistance(grid.position(c, row)));
        }
        grid.value(c, row) = static_cast<float>(std::sqrt(nearest));
      }
    }
  };
  oneapi::tbb::parallel_for(0, (grid.rows() + kBlock - 1) / kBlock, [&](int band) {
    std::vector<double> squared(segments.size());
    for (int c = 0; c < grid.columns(); c += kBlock) fill(c, band * kBlock, squared);
  });
  return grid;
}

// Corrections c of the heights z minimise
//   sum w c_i^2 + L^2 sum (c_i+1 - c_i)^2 + sum W (z_a + c_a - z_b - c_b)^2,
// with points 1 m apart. A single correction decays along the street as exp(-distance / L).
std::vector<double> agreeOnHeights(const std::vector<PathPoint>& path) {
  const auto n = static_cast<int>(path.size());
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
  const auto tie = [&](int i, int j, double weight) {
    entries.insert(entries.end(),
                   {{i, i, weight}, {j, j, weight}, {i, j, -weight}, {j, i, -weight}});
    return weight;
  };
  for (int i = 0; i < n; ++i) {
    entries.emplace_back(i, i, path[static_cast<std::size_t>(i)].driven_over ? 1 : kBeyondWeight);
    if (i + 1 < n) tie(i, i + 1, kBendLength * kBendLength);
  }
  for (const Meeting& meeting : findMeetings(path)) {
    const auto a = static_cast<int>(meeting.a);
    const auto b = static_cast<int>(meeting.b);
    const double pull = tie(a, b, kMeetingWeight * meeting.weight) *
                        (path[meeting.b].height - path[meeting.a].height);
    right[a] += pull;
    right[b] -= pull;
  }
  Eigen::SparseMatrix<double> normal(n, n);
  normal.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd corrections = Eigen::SimplicialLDLT<decltype(normal)>(normal).solve(right);
  std::vector<double> heights;
  for (int i = 0; i < n; ++i) {
    heights.push_back(path[static_cast<std::size_t>(i)].height + corrections[i]);
  }
  return heights;
}

}  // namespace tolman::town
