// SPDX-License-Identifier: BSD-3-Clause
// Road, kerbs and the land beside them: marching squares, row by row, so that no memory is needed
// besides that of the mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>

#include "objects.hpp"

namespace tolman::town {
namespace {

constexpr double kCell = 1;              ///< m
constexpr double kSkirtCell = 10;        ///< m
constexpr double kSkirtBelow = 0.25;     ///< m
constexpr double kSkirtBelowTown = 1.5;  ///< m, where the fine ground lies above
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

/// Intersection of the kerb and an edge of the grid: the lower vertex (road) and the upper one
/// (land).
struct Cut {
  std::uint32_t road = kNone;
  std::uint32_t land = kNone;
};

/// One row of grid points.
struct Row {
  std::vector<double> distance;
  std::vector<std::uint32_t> vertices;
  std::vector<Cut> cuts;  ///< on the edge to the next column
};

/// A node of the boundary of a cell: a corner or a cut.
struct Node {
  bool is_cut = false;
  bool on_road = false;  ///< for a corner
  std::uint32_t corner = kNone;
  Cut cut;

  std::uint32_t vertex(bool road) const { return !is_cut ? corner : road ? cut.road : cut.land; }
};

/// The boundary of a cell, or a part of it: up to four corners and four cuts, counter-clockwise.
struct Ring {
  std::array<Node, 8> nodes;
  std::size_t size = 0;

  void add(const Node& node) { nodes[size++] = node; }
  const Node& at(std::size_t i) const { return nodes[i % size]; }
};

class GroundMesher {
 public:
  GroundMesher(const StreetPlan& plan, const GroundSurfaces& surfaces)
      : plan_(plan), surfaces_(surfaces) {
    const Eigen::Vector2d size = plan.highCorner() - plan.lowCorner();
    columns_ = static_cast<std::size_t>(size.x() / kCell) + 1;
    rows_ = static_cast<std::size_t>(size.y() / kCell) + 1;
  }

  Mesh build(double horizon) {
    Row low = row(0);
    for (std::size_t r = 0; r + 1 < rows_; ++r) {
      Row high = row(r + 1);
      upward_.assign(columns_, {});
      for (std::size_t c = 0; c + 1 < columns_; ++c) addCell(c, r, low, high);
      low = std::move(high);
    }
    addSkirt(horizon);
    return std::move(mesh_);
  }

 private:
  static bool onRoad(double distance) { return distance < StreetPlan::kRoadHalfWidth; }

  double distance(const Eigen::Vector2d& at) const { return plan_.distance(at.x(), at.y()); }
  Eigen::Vector2d place(std::size_t column, std::size_t row) const {
    return plan_.lowCorner() +
           kCell * Eigen::Vector2d(static_cast<double>(column), static_cast<double>(row));
  }
  std::uint32_t addVertex(const Eigen::Vector2d& at, double above) {
    return mesh_.addVertex(toVec3(at, plan_.height(at.x(), at.y()) + above));
  }

  Row row(std::size_t r) const {
    Row row{{}, std::vector<std::uint32_t>(columns_, kNone), std::vector<Cut>(columns_)};
    for (std::size_t c = 0; c < columns_; ++c) row.distance.push_back(distance(place(c, r)));
    return row;
  }

  Node corner(Row& row, std::size_t c, std::size_t r) {
    const bool on_road = onRoad(row.distance[c]);
    if (row.vertices[c] == kNone) {
      row.vertices[c] = addVertex(place(c, r), on_road ? 0 : StreetPlan::kKerbHeight);
    }
    return {false, on_road, row.vertices[c], {}};
  }

  /// The cut of an edge; its vertices are made once for the two cells that share the edge.
  Node cut(Cut& shared, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    if (shared.road == kNone) {
      const Eigen::Vector2d at = crossing(from, to);
      shared.road = addVertex(at, 0);
      shared.land = addVertex(at, StreetPlan::kKerbHeight);
    }
    return {true, false, kNone, shared};
  }

  /// Intersection of the kerb and an edge, by bisection, because the plan is finer than the grid.
  Eigen::Vector2d crossing(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
    const auto road_at = [&](double t) { return onRoad(distance(from + t * (to - from))); };
    const bool start = road_at(0);
    double low = 0;
    double high = 1;
    for (int step = 0; step < 12; ++step) {
      const double middle = (low + high) / 2;
      (road_at(middle) == start ? low : high) = middle;
    }
    // Not too near to the grid points, which would give degenerate triangles.
    return from + std::clamp((low + high) / 2, 0.01, 0.99) * (to - from);
  }

  void addCell(std::size_t c, std::size_t r, Row& low, Row& high) {
    const double nearest =
        std::min({low.distance[c], low.distance[c + 1], high.distance[c], high.distance[c + 1]});
    if (nearest >= StreetPlan::kFarthest) return;
    const std::array<Node, 4> corners = {corner(low, c, r), corner(low, c + 1, r),
                                         corner(high, c + 1, r + 1), corner(high, c, r + 1)};
    const std::array<Cut*, 4> cuts = {&low.cuts[c], &upward_[c + 1], &high.cuts[c], &upward_[c]};
    const std::array<Eigen::Vector2d, 4> places = {place(c, r), place(c + 1, r),
                                                   place(c + 1, r + 1), place(c, r + 1)};
    Ring ring;
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t next = (i + 1) % 4;
      ring.add(corners[i]);
      if (corners[i].on_road != corners[next].on_road) {
        ring.add(cut(*cuts[i], places[i], places[next]));
      }
    }
    if (ring.size < 8) {
      addSide(ring, true);
      addSide(ring, false);
    } else {
      addSaddle(ring, onRoad(distance(places[0] + Eigen::Vector2d::Constant(kCell / 2))));
    }
  }

  /// The part of a cell on one side of the kerb.
  void addSide(const Ring& ring, bool road) {
    Ring part;
    for (std::size_t i = 0; i < ring.size; ++i) {
      if (ring.at(i).is_cut || ring.at(i).on_road == road) part.add(ring.at(i));
    }
    addPolygon({part.nodes.data(), part.size}, road);
  }

  /// Cell whose opposite corners are on the same side: the side of the centre connects its corners.
  void addSaddle(const Ring& ring, bool middle_on_road) {
    addSide(ring, middle_on_road);
    for (std::size_t i = 0; i < ring.size; ++i) {
      const Node& node = ring.at(i);
      if (node.is_cut || node.on_road == middle_on_road) continue;
      addPolygon(std::array{ring.at(i + ring.size - 1), node, ring.at(i + 1)}, !middle_on_road);
    }
  }

  void addPolygon(std::span<const Node> nodes, bool road) {
    if (nodes.size() < 3) return;
    const std::uint32_t surface = road ? surfaces_.road : surfaces_.land;
    for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
      mesh_.addTriangle(nodes[0].vertex(road), nodes[i].vertex(road), nodes[i + 1].vertex(road),
                        surface);
    }
    if (!road) return;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& a = nodes[i];
      const Node& b = nodes[(i + 1) % nodes.size()];
      if (!a.is_cut || !b.is_cut) continue;  // kerb between two cuts, road on its left
      mesh_.addTriangle(b.cut.road, a.cut.road, a.cut.land, surfaces_.kerb);
      mesh_.addTriangle(b.cut.road, a.cut.land, b.cut.land, surfaces_.kerb);
    }
  }

  void addSkirt(double horizon) {
    const Eigen::Vector2d low = plan_.lowCorner().array() - horizon;
    const Eigen::Vector2d size = plan_.highCorner() - low + Eigen::Vector2d::Constant(horizon);
    const auto columns = static_cast<std::uint32_t>(std::ceil(size.x() / kSkirtCell)) + 1;
    const auto rows = static_cast<std::uint32_t>(std::ceil(size.y() / kSkirtCell)) + 1;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    std::vector<bool> covered;  // points well inside of the fine ground
    for (std::uint32_t i = 0; i < rows * columns; ++i) {
      const Eigen::Vector2d at = low + kSkirtCell * Eigen::Vector2d(i % columns, i / columns);
      const double away = distanceBeyond(at);
      covered.push_back(away < StreetPlan::kFarthest - 2 * kSkirtCell);
      const double below = away < StreetPlan::kFarthest ? kSkirtBelowTown : kSkirtBelow;
      addVertex(at, StreetPlan::kKerbHeight - below);
    }
    for (std::uint32_t a = 0; a + columns < rows * columns; ++a) {
      if (a % columns + 1 == columns) continue;
      if (covered[a] && covered[a + 1] && covered[a + columns] && covered[a + columns + 1]) {
        continue;
      }
      const std::uint32_t corner = first + a;
      mesh_.addTriangle(corner, corner + 1, corner + columns + 1, surfaces_.land);
      mesh_.addTriangle(corner, corner + columns + 1, corner + columns, surfaces_.land);
    }
  }

  /// Distance to the nearest street; outside of the plan kFarthest.
  double distanceBeyond(const Eigen::Vector2d& at) const {
    const bool inside = (at.array() >= plan_.lowCorner().array()).all() &&
                        (at.array() <= plan_.highCorner().array()).all();
    return inside ? distance(at) : StreetPlan::kFarthest;
  }

  const StreetPlan& plan_;
  GroundSurfaces surfaces_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Cut> upward_;  ///< on the edges from the lower row to the upper one
  Mesh mesh_;
};

}  // namespace

Mesh buildGround(const StreetPlan& plan, const GroundSurfaces& surfaces, double horizon) {
  return GroundMesher(plan, surfaces).build(horizon);
}

}  // namespace tolman::town
