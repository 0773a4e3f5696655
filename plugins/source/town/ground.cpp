// SPDX-License-Identifier: BSD-3-Clause
// Marching squares, row by row, so that no memory is needed besides that of the mesh.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

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

/// The boundary of a cell: up to four corners and four cuts, counter-clockwise.
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

  Eigen::Vector2d place(double column, double row) const {
    return plan_.lowCorner() + kCell * Eigen::Vector2d(column, row);
  }

  std::uint32_t addVertex(const Eigen::Vector2d& at, double above) {
    return mesh_.addVertex(static_cast<float>(at.x()), static_cast<float>(at.y()),
                           static_cast<float>(plan_.height(at.x(), at.y()) + above));
  }

  Row row(std::size_t r) const {
    Row row{std::vector<double>(columns_), std::vector<std::uint32_t>(columns_, kNone),
            std::vector<Cut>(columns_)};
    for (std::size_t c = 0; c < columns_; ++c) {
      const Eigen::Vector2d at = place(static_cast<double>(c), static_cast<double>(r));
      row.distance[c] = plan_.distance(at.x(), at.y());
    }
    return row;
  }

  Node corner(Row& row, std::size_t c, std::size_t r) {
    const bool on_road = onRoad(row.distance[c]);
    if (row.vertices[c] == kNone) {
      row.vertices[c] = addVertex(place(static_cast<double>(c), static_cast<double>(r)),
                                  on_road ? 0 : StreetPlan::kKerbHeight);
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
    const auto road_at = [&](double t) {
      const Eigen::Vector2d at = from + t * (to - from);
      return onRoad(plan_.distance(at.x(), at.y()));
    };
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
    const auto x = static_cast<double>(c);
    const auto y = static_cast<double>(r);
    const std::array<Eigen::Vector2d, 4> places = {place(x, y), place(x + 1, y),
                                                   place(x + 1, y + 1), place(x, y + 1)};
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
      const Eigen::Vector2d middle = place(x + 0.5, y + 0.5);
      addSaddle(ring, onRoad(plan_.distance(middle.x(), middle.y())));
    }
  }

  /// The part of a cell on one side of the kerb.
  void addSide(const Ring& ring, bool road) {
    std::array<Node, 8> part;
    std::size_t size = 0;
    for (std::size_t i = 0; i < ring.size; ++i) {
      const Node& node = ring.at(i);
      if (node.is_cut || node.on_road == road) part[size++] = node;
    }
    addPolygon({part.data(), size}, road);
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
    const auto columns = static_cast<std::size_t>(std::ceil(size.x() / kSkirtCell)) + 1;
    const auto rows = static_cast<std::size_t>(std::ceil(size.y() / kSkirtCell)) + 1;
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    std::vector<bool> covered;  // points well inside of the fine ground
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns; ++c) {
        const Eigen::Vector2d at =
            low + kSkirtCell * Eigen::Vector2d(static_cast<double>(c), static_cast<double>(r));
        const double distance = distanceBeyond(at);
        covered.push_back(distance < StreetPlan::kFarthest - 2 * kSkirtCell);
        const double below = distance < StreetPlan::kFarthest ? kSkirtBelowTown : kSkirtBelow;
        addVertex(at, StreetPlan::kKerbHeight - below);
      }
    }
    for (std::size_t r = 0; r + 1 < rows; ++r) {
      for (std::size_t c = 0; c + 1 < columns; ++c) {
        const std::size_t a = r * columns + c;
        if (covered[a] && covered[a + 1] && covered[a + columns] && covered[a + columns + 1]) {
          continue;
        }
        const auto at = [&](std::size_t i) { return first + static_cast<std::uint32_t>(i); };
        mesh_.addTriangle(at(a), at(a + 1), at(a + columns + 1), surfaces_.land);
        mesh_.addTriangle(at(a), at(a + columns + 1), at(a + columns), surfaces_.land);
      }
    }
  }

  /// Distance to the nearest street; outside of the plan kFarthest.
  double distanceBeyond(const Eigen::Vector2d& at) const {
    const bool inside = (at.array() >= plan_.lowCorner().array()).all() &&
                        (at.array() <= plan_.highCorner().array()).all();
    return inside ? plan_.distance(at.x(), at.y()) : StreetPlan::kFarthest;
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
