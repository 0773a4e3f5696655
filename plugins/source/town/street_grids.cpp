// SPDX-License-Identifier: BSD-3-Clause
// Distances to the streets, and heights of the road from those of the driven path.

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "ground_grid.hpp"

namespace tolman::town {

namespace {

constexpr double kFinestCell = 0.5;  ///< m
constexpr double kMaxCells = 16e6;   ///< of 4 bytes
constexpr int kBlock = 16;           ///< cells

struct Segment {
  Eigen::Vector2d start;
  Eigen::Vector2d along;
  double inverse_squared_length = 0;

  double squaredDistance(const Eigen::Vector2d& place) const {
    const Eigen::Vector2d from_start = place - start;
    const double t = std::clamp(from_start.dot(along) * inverse_squared_length, 0.0, 1.0);
    return (from_start - t * along).squaredNorm();
  }
};

std::vector<Segment> centrelines(const std::vector<PathPoint>& path) {
  std::vector<Segment> segments;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i].raised || path[std::min(i + 1, path.size() - 1)].raised) continue;
    const Eigen::Vector2d& start = path[i].centre;
    const Eigen::Vector2d along = path[std::min(i + 1, path.size() - 1)].centre - start;
    const double squared = along.squaredNorm();
    segments.push_back({start, along, squared > 0 ? 1 / squared : 0});
  }
  return segments;
}

class DistanceRaster {
 public:
  DistanceRaster(const std::vector<PathPoint>& path, const GridExtent& extent, double cell,
                 double farthest)
      : segments_(centrelines(path)),
        raster_(extent.low, extent.high, cell, static_cast<float>(farthest)),
        farthest_(farthest),
        half_diagonal_(cell * kBlock * std::numbers::sqrt2 / 2),
        block_columns_((raster_.columns() + kBlock - 1) / kBlock),
        block_rows_((raster_.rows() + kBlock - 1) / kBlock),
        candidates_(static_cast<std::size_t>(block_columns_) *
                    static_cast<std::size_t>(block_rows_)) {}

  GroundGrid fill() {
    for (std::uint32_t i = 0; i < segments_.size(); ++i) offer(i);
    for (int row = 0; row < block_rows_; ++row) {
      for (int column = 0; column < block_columns_; ++column) fillBlock(column, row);
    }
    return std::move(raster_);
  }

 private:
  std::vector<std::uint32_t>& candidates(int column, int row) {
    return candidates_[static_cast<std::size_t>(row) * static_cast<std::size_t>(block_columns_) +
                       static_cast<std::size_t>(column)];
  }

  Eigen::Vector2d blockCentre(int column, int row) const {
    return raster_.position(column * kBlock, row * kBlock) +
           Eigen::Vector2d::Constant(raster_.cell() * kBlock / 2);
  }

  /// Adds a segment to the candidates of all blocks that are near enough.
  void offer(std::uint32_t index) {
    const Segment& segment = segments_[index];
    const Eigen::Vector2d middle = segment.start + segment.along / 2;
    const double reach = farthest_ + half_diagonal_;
    const double width = raster_.cell() * kBlock;
    const Eigen::Vector2d at = (middle - raster_.position(0, 0)) / width;
    const double blocks = (reach + segment.along.norm() / 2) / width + 1;
    const auto clampTo = [](double value, int count) {
      return static_cast<int>(std::clamp(value, 0.0, count - 1.0));
    };
    for (int row = clampTo(at.y() - blocks, block_rows_);
         row <= clampTo(at.y() + blocks, block_rows_); ++row) {
      for (int column = clampTo(at.x() - blocks, block_columns_);
           column <= clampTo(at.x() + blocks, block_columns_); ++column) {
        if (segment.squaredDistance(blockCentre(column, row)) <= reach * reach) {
          candidates(column, row).push_back(index);
        }
      }
    }
  }

  /// Removes candidates that are farther than the nearest one by more than the size of the block.
  void prune(int column, int row) {
    const Eigen::Vector2d centre = blockCentre(column, row);
    std::vector<std::uint32_t>& all = candidates(column, row);
    double nearest = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : all) {
      nearest = std::min(nearest, segments_[i].squaredDistance(centre));
    }
    const double limit = std::sqrt(nearest) + 2 * half_diagonal_;
    std::erase_if(
        all, [&](std::uint32_t i) { return segments_[i].squaredDistance(centre) > limit * limit; });
  }

  void fillBlock(int block_column, int block_row) {
    prune(block_column, block_row);
    const std::vector<std::uint32_t>& all = candidates(block_column, block_row);
    const int last_row = std::min((block_row + 1) * kBlock, raster_.rows());
    const int last_column = std::min((block_column + 1) * kBlock, raster_.columns());
    for (int row = block_row * kBlock; row < last_row; ++row) {
      for (int column = block_column * kBlock; column < last_column; ++column) {
        const Eigen::Vector2d place = raster_.position(column, row);
        double nearest = farthest_ * farthest_;
        for (const std::uint32_t i : all) {
          nearest = std::min(nearest, segments_[i].squaredDistance(place));
        }
        raster_.value(column, row) = static_cast<float>(std::sqrt(nearest));
      }
    }
    candidates(block_column, block_row) = {};
  }

  std::vector<Segment> segments_;
  GroundGrid raster_;
  double farthest_;
  double half_diagonal_;
  int block_columns_;
  int block_rows_;
  std::vector<std::vector<std::uint32_t>> candidates_;
};

}  // namespace

GroundGrid distanceGrid(const std::vector<PathPoint>& path, const GridExtent& extent,
                        double farthest) {
  const Eigen::Vector2d size = extent.high - extent.low;
  const double cell = std::max(kFinestCell, std::sqrt(size.prod() / kMaxCells));
  return DistanceRaster(path, extent, cell, farthest).fill();
}

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
