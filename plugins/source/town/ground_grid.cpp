// SPDX-License-Identifier: BSD-3-Clause
// Distances to the streets, and heights of the road from those of the driven path.
#include "ground_grid.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <numbers>

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

// The ground between and around the streets.

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
