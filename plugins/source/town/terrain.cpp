// SPDX-License-Identifier: BSD-3-Clause
// The ground between and around the streets.
#include <algorithm>
#include <cmath>

#include "ground_grid.hpp"

namespace tolman::town {
namespace {

constexpr double kFinestTerrainCell = 1;  ///< m
constexpr double kMaxTerrainCells = 4e6;  ///< of 4 bytes; five times as much during the computation
constexpr double kSmoothing = 2.5;        ///< m, of driven heights
constexpr double kReach = 16;             ///< m from the path up to which its heights are used
constexpr double kLevelTo = 6.5;          ///< m from the centreline: level up to here
constexpr double kFadedAt = 12;           ///< m
constexpr double kSettles = 150;          ///< m over which the membrane approaches the hills
constexpr int kSweeps = 12;               ///< per level; few, because coarser levels give the start

/// Normalised convolution of the values at path points with a Gaussian; 0 beyond kReach.
GroundGrid spread(const std::vector<PathPoint>& path, const std::vector<double>& values,
                  const GridExtent& extent, double cell) {
  GroundGrid sum(extent.low, extent.high, cell, 0);
  GroundGrid weights(extent.low, extent.high, cell, 0);
  const double smoothing = std::max(kSmoothing, 1.5 * cell);
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (path[i].raised) continue;
    sum.forEachNear(path[i].driven, kReach, [&](int c, int r) {
      const double squared = (sum.position(c, r) - path[i].driven).squaredNorm();
      if (squared > kReach * kReach) return;
      const double weight = std::exp(-squared / (2 * smoothing * smoothing));
      sum.value(c, r) += static_cast<float>(weight * values[i]);
      weights.value(c, r) += static_cast<float>(weight);
    });
  }
  sum.forEach([&](int c, int r) {
    if (weights.value(c, r) > 0) sum.value(c, r) /= weights.value(c, r);
  });
  return sum;
}

/// Spreads heights, then the residuals of this smoothing, so that crests are exact to centimetres.
GroundGrid streetHeights(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                         const GridExtent& extent, double cell) {
  GroundGrid street = spread(path, heights, extent, cell);
  std::vector<double> missing;
  for (std::size_t i = 0; i < path.size(); ++i) {
    missing.push_back(heights[i] - street.at(path[i].driven.x(), path[i].driven.y()));
  }
  const GroundGrid rest = spread(path, missing, extent, cell);
  street.forEach([&](int c, int r) { street.value(c, r) += rest.value(c, r); });
  return street;
}

/// Known heights and their weights at one resolution.
struct Level {
  GroundGrid known;
  GroundGrid weight;  ///< 1 keeps the height, 0 leaves it to the membrane
};

/// The level of half the resolution; a coarse point represents up to four fine ones.
Level coarser(const Level& fine) {
  const auto [low, high] = fine.known.extent();
  const double cell = 2 * fine.known.cell();
  Level coarse{GroundGrid(low, high, cell, 0), GroundGrid(low, high, cell, 0)};
  auto& [known, weight] = coarse;
  fine.known.forEach([&](int c, int r) {
    const float w = fine.weight.value(c, r);
    known.value(c / 2, r / 2) += w * fine.known.value(c, r);
    weight.value(c / 2, r / 2) += w;
  });
  known.forEach([&](int c, int r) {
    float& w = weight.value(c, r);
    if (w > 0) known.value(c, r) /= w;
    w /= 4;
  });
  return coarse;
}

/// Gauss-Seidel on the screened membrane equation: known heights by their weight, otherwise the
/// mean of the neighbours with a small share of the hills.
void relax(GroundGrid& height, const Level& level, double mean) {
  const int right = height.columns() - 1;
  const int top = height.rows() - 1;
  const double scaled = height.cell() / kSettles;
  const auto settle = static_cast<float>(scaled * scaled / (4 + scaled * scaled));
  GroundGrid hills = height;
  hills.forEach([&](int c, int r) {
    const Eigen::Vector2d place = hills.position(c, r);
    hills.value(c, r) = static_cast<float>(mean + farHills(place.x(), place.y()));
  });
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    height.forEach([&](int c, int r) {
      const float w = level.weight.value(c, r);
      if (w >= 1) return;
      const float around =
          (height.value(std::max(c - 1, 0), r) + height.value(std::min(c + 1, right), r) +
           height.value(c, std::max(r - 1, 0)) + height.value(c, std::min(r + 1, top))) /
          4;
      const float membrane = around + settle * (hills.value(c, r) - around);
      height.value(c, r) = membrane + w * (level.known.value(c, r) - membrane);
    });
  }
}

/// The membrane at this level, starting from the coarser one.
GroundGrid membrane(const Level& level, double mean) {
  const auto [low, high] = level.known.extent();
  GroundGrid height(low, high, level.known.cell(), static_cast<float>(mean));
  if (std::min(level.known.columns(), level.known.rows()) > 4) {
    const GroundGrid coarse = membrane(coarser(level), mean);
    // A coarse point represents the middle of its fine points.
    const double shift = level.known.cell() / 2;
    height.forEach([&](int c, int r) {
      const Eigen::Vector2d place = height.position(c, r);
      const auto guess = static_cast<float>(coarse.at(place.x() - shift, place.y() - shift));
      const float w = level.weight.value(c, r);
      height.value(c, r) = guess + w * (level.known.value(c, r) - guess);
    });
  }
  relax(height, level, mean);
  return height;
}

/// Lowers the ground below the roadway of floors, also before the entrance.
void lowerUnderFloors(GroundGrid& height, const std::vector<PathPoint>& path,
                      const std::vector<double>& heights) {
  constexpr double kBelow = 0.35;  // m, more than a kerb
  constexpr double kOver = 6.5;    // m to either side
  constexpr double kAlong = 0.75;  // m
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (!path[i].raised) continue;
    height.forEachNear(path[i].centre, kOver, [&](int c, int r) {
      const Eigen::Vector2d offset = height.position(c, r) - path[i].centre;
      const Eigen::Vector2d& d = path[i].direction;
      if (std::abs(offset.dot(d)) > kAlong) return;
      if (std::abs(offset.x() * d.y() - offset.y() * d.x()) > kOver) return;
      height.value(c, r) = std::min(height.value(c, r), static_cast<float>(heights[i] - kBelow));
    });
  }
}

}  // namespace

double farHills(double x, double y) {
  return 1.6 * std::sin(x / 47 + y / 91 + 0.7) + 1.9 * std::sin(y / 53 - x / 130 + 2.1) +
         1.2 * std::sin((x + y) / 29 + 4);
}

GroundGrid heightGrid(const std::vector<PathPoint>& path, const std::vector<double>& heights,
                      const GroundGrid& distance, const GridExtent& extent, double mean,
                      const std::vector<GroundPad>& pads) {
  const Eigen::Vector2d size = extent.high - extent.low;
  const double cell = std::max(kFinestTerrainCell, std::sqrt(size.prod() / kMaxTerrainCells));
  Level level{streetHeights(path, heights, extent, cell),
              GroundGrid(extent.low, extent.high, cell, 0)};
  level.weight.forEach([&](int c, int r) {
    const Eigen::Vector2d place = level.weight.position(c, r);
    const double away = distance.at(place.x(), place.y());
    const double t = std::clamp((kFadedAt - away) / (kFadedAt - kLevelTo), 0.0, 1.0);
    level.weight.value(c, r) = static_cast<float>(t * t * (3 - 2 * t));
    for (const GroundPad& pad : pads) {  // their heights hold also near streets
      if ((place.array() < pad.low.array()).any() || (place.array() > pad.high.array()).any()) {
        continue;
      }
      level.known.value(c, r) = static_cast<float>(pad.height);
      level.weight.value(c, r) = 1;
    }
  });
  GroundGrid height = membrane(level, mean);
  lowerUnderFloors(height, path, heights);
  return height;
}

}  // namespace tolman::town
