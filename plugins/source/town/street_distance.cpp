// SPDX-License-Identifier: BSD-3-Clause
// Exact distance to polylines: for each block of cells only segments that may be nearest to one of
// its cells are tested.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "street_grids.hpp"

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

}  // namespace tolman::town
