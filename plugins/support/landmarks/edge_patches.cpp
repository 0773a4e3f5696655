// SPDX-License-Identifier: BSD-3-Clause
#include "edge_patches.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "wide_lanes.hpp"

namespace tolman::landmarks {
namespace {

// Chosen on the town's route 06 with its second pass by night.
constexpr std::array<int, 4> kOffsets = {-5, -2, 1, 4};  // cells, of the samples of a patch
constexpr float kLevels = 32;                            // of a value of one, in four bits
constexpr float kRival = 0.9F;      // ratio of the distances of the two best positions
constexpr int kSamePosition = 4;    // cells: nearer positions are the same one
constexpr double kEdgeSigma = 1.1;  // px of the reduced image

using Values = std::array<float, 2 * kPatchBytes>;

struct Cell {
  int row;
  int column;
};

Cell nearestCell(const EdgeMap& map, const cv::Point2f& pixel) {
  const cv::Point2f cell = map.cellOf(pixel);
  const auto within = [](float at, int count) {  // 0 for what is no number
    return at > 0 ? static_cast<int>(std::lround(std::min(at, static_cast<float>(count - 1)))) : 0;
  };
  return {within(cell.y, map.rows()), within(cell.x, map.columns())};
}

/// Values of a patch, of length one.
Values valuesOf(const EdgePatch& patch) {
  Values values;
  float squares = 0;
  for (std::size_t i = 0; i < patch.size(); ++i) {
    values[i] = static_cast<float>(patch[i] & 15U);
    values[kPatchBytes + i] = static_cast<float>(patch[i] >> 4U);
    squares += values[i] * values[i] + values[kPatchBytes + i] * values[kPatchBytes + i];
  }
  const float scale = squares > 0 ? 1 / std::sqrt(squares) : 0;
  for (float& value : values) value *= scale;
  return values;
}

constexpr int kEdgeLanes = 16;  // positions that are computed together
static_assert(kEdgeLanes <= EdgeMap::kReadable);
static_assert(2 * kPatchBytes == 16 * EdgeMap::kDirections);

/// Where the values of a patch are, relative to that of its first direction at its centre.
using Offsets = std::array<std::ptrdiff_t, 2 * kPatchBytes>;

Offsets offsetsIn(const EdgeMap& map) {
  Offsets offsets;
  std::size_t i = 0;
  for (const int dy : kOffsets) {
    for (const int dx : kOffsets) {
      for (int k = 0; k < EdgeMap::kDirections; ++k, ++i) {
        offsets[i] = dy * map.rowStride() + dx + k * map.directionStride();
      }
    }
  }
  return offsets;
}

/// Inner products of a patch with those of `blocks` times kEdgeLanes positions that follow `first`.
TOLMAN_WIDE_LANES void products(const float* first, const std::ptrdiff_t* offsets,
                                const float* patch, int blocks, float* out) {
  for (int b = 0; b < blocks; ++b, first += kEdgeLanes, out += kEdgeLanes) {
    float sums[kEdgeLanes] = {};
    for (int i = 0; i < 2 * kPatchBytes; ++i) {
      const float* strengths = first + offsets[i];
      for (int lane = 0; lane < kEdgeLanes; ++lane) sums[lane] += patch[i] * strengths[lane];
    }
    for (int lane = 0; lane < kEdgeLanes; ++lane) out[lane] = sums[lane];
  }
}

float energyOf(const EdgeMap& map, Cell cell) {
  float energy = 0;
  for (const int dy : kOffsets) {
    for (const int dx : kOffsets) energy += map.energyAt(cell.row + dy, cell.column + dx);
  }
  return energy;
}

/// Cosines between a patch and those of the cells of a window.
class Window {
 public:
  Window(const EdgeMap& map, Cell centre) {
    const int across = map.columns() / 10;
    const int up = map.columns() / 44;
    left_ = std::max(kMargin, centre.column - across);
    top_ = std::max(kMargin, centre.row - up);
    width_ = std::min(map.columns() - kMargin, centre.column + across + 1) - left_;
    height_ = std::min(map.rows() - kMargin, centre.row + up + 1) - top_;
  }

  bool isUsable() const { return width_ > 2 && height_ > 2; }

  /// `lengths`: those of the patches at all cells, as 1 / length.
  void compare(const EdgeMap& map, const Offsets& offsets, const std::vector<float>& lengths,
               const Values& patch) {
    const int blocks = (width_ + kEdgeLanes - 1) / kEdgeLanes;
    std::vector<float> row(static_cast<std::size_t>(blocks * kEdgeLanes));
    cosines_.clear();
    for (int y = 0; y < height_; ++y) {
      products(map.at(0, top_ + y, left_), offsets.data(), patch.data(), blocks, row.data());
      const float* inverse = &lengths[static_cast<std::size_t>((top_ + y) * map.columns() + left_)];
      for (int x = 0; x < width_; ++x) {
        cosines_.push_back(row[static_cast<std::size_t>(x)] * inverse[x]);
      }
    }
  }

  /// The cell of the best position, between cells; empty if it is at the border or has a rival.
  std::optional<cv::Point2f> unique() const {
    const auto best = static_cast<int>(std::ranges::max_element(cosines_) - cosines_.begin());
    const int x = best % width_;
    const int y = best / width_;
    if (x == 0 || y == 0 || x + 1 == width_ || y + 1 == height_) return std::nullopt;
    // For vectors of length one the squared distance is 2 - 2 cosine.
    if (1 - at(x, y) > kRival * kRival * (1 - bestAwayFrom(x, y))) return std::nullopt;
    return cv::Point2f(static_cast<float>(left_ + x) + peak(at(x - 1, y), at(x, y), at(x + 1, y)),
                       static_cast<float>(top_ + y) + peak(at(x, y - 1), at(x, y), at(x, y + 1)));
  }

 private:
  static constexpr int kMargin = 5;  // cells: patches reach out of the image by little

  float at(int x, int y) const { return cosines_[static_cast<std::size_t>(y * width_ + x)]; }

  float bestAwayFrom(int best_x, int best_y) const {
    float best = 0;
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        if (std::max(std::abs(x - best_x), std::abs(y - best_y)) <= kSamePosition) continue;
        best = std::max(best, at(x, y));
      }
    }
    return best;
  }

  /// Of the parabola through three values at -1, 0 and 1; the middle one is the largest.
  static float peak(float before, float middle, float after) {
    const float curve = before - 2 * middle + after;
    return curve < 0 ? 0.5F * (before - after) / curve : 0;
  }

  int left_;
  int top_;
  int width_;
  int height_;
  std::vector<float> cosines_;
};

}  // namespace

cv::Point2f pixelOf(const cv::Point3f& point, const Pinhole& pinhole) {
  const Eigen::Vector2d pixel = pinhole.project({point.x, point.y, point.z});
  return {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())};
}

EdgePatch patchAt(const EdgeMap& map, const cv::Point2f& pixel) {
  const Cell cell = nearestCell(map, pixel);
  const float* centre = map.at(0, cell.row, cell.column);
  const Offsets offsets = offsetsIn(map);
  const float energy = energyOf(map, cell);
  const float scale = energy > 0 ? kLevels / std::sqrt(energy) : 0;
  const auto level = [&](std::size_t v) {
    return static_cast<unsigned>(std::lround(std::min(15.0F, centre[offsets[v]] * scale)));
  };
  EdgePatch patch;
  for (std::size_t b = 0; b < patch.size(); ++b) {
    patch[b] = static_cast<std::uint8_t>(level(b) | level(kPatchBytes + b) << 4U);
  }
  return patch;
}

EdgeSearch::EdgeSearch(const EdgeMap& map) : map_(map) {
  for (int r = 0; r < map.rows(); ++r) {
    for (int c = 0; c < map.columns(); ++c) {
      const float energy = energyOf(map, {r, c});
      lengths_.push_back(energy > 0 ? 1 / std::sqrt(energy) : 0);
    }
  }
}

std::vector<LandmarkMatch> EdgeSearch::find(const std::vector<cv::Point3f>& points,
                                            const std::vector<EdgePatch>& patches,
                                            const Pinhole& pinhole, std::size_t step) const {
  std::vector<LandmarkMatch> matches;
  const Offsets offsets = offsetsIn(map_);
  for (std::size_t i = 0; i < points.size(); i += step) {
    if (!(points[i].z > 0)) continue;
    const cv::Point2f pixel = pixelOf(points[i], pinhole);
    const Cell cell = nearestCell(map_, pixel);
    Window window(map_, cell);
    if (!window.isUsable()) continue;
    window.compare(map_, offsets, lengths_, valuesOf(patches[i]));
    const auto found = window.unique();
    if (!found) continue;
    // The patch is that of the nearest cell, from which the landmark is a little away.
    const cv::Point2f centre =
        map_.pixelOf(cv::Point2f(static_cast<float>(cell.column), static_cast<float>(cell.row)));
    matches.push_back({points[i], map_.pixelOf(*found) + pixel - centre});
  }
  return matches;
}

double EdgeSearch::sigma() const { return kEdgeSigma * map_.factor(); }

}  // namespace tolman::landmarks
