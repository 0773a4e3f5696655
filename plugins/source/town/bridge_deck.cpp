// SPDX-License-Identifier: BSD-3-Clause
// The bridges as triangles: one cross-section per metre of the deck's centreline.
#include "bridges.hpp"
#include "shapes.hpp"

namespace tolman::town {
namespace {

constexpr float kRoad = static_cast<float>(StreetPlan::kRoadHalfWidth);  ///< m, half
constexpr float kEdge = kRoad + 1.4F;                                    ///< m, with the walkway
constexpr auto kKerb = static_cast<float>(StreetPlan::kKerbHeight);
constexpr float kDeckThickness = 0.55F;  ///< m thick
constexpr float kRailing = 1.05F;        ///< m above the walkway
constexpr float kFoot = 1.5F;            ///< m that abutments reach below the ground
constexpr std::size_t kPostEvery = 2;

struct DeckSurfaces {
  std::uint32_t road;
  std::uint32_t walkway;
  std::uint32_t concrete;
  std::uint32_t metal;
};

/// A point of the deck, `over` m to the left of the centreline and `up` m above the road.
Vec3 at(const Deck::Point& p, float over, float up) {
  const Eigen::Vector2d q =
      p.position + static_cast<double>(over) * Eigen::Vector2d(-p.direction.y(), p.direction.x());
  return {static_cast<float>(q.x()), static_cast<float>(q.y()), static_cast<float>(p.height) + up};
}

/// A strip between two cross-sections, from (over0, up0) to (over1, up1).
struct Strip {
  float over0, up0, over1, up1;
  std::uint32_t surface;
};

void addSlice(Mesh& mesh, const Deck::Point& a, const Deck::Point& b, const DeckSurfaces& s) {
  const Strip strips[] = {{-kRoad, 0, kRoad, 0, s.road},
                          {-kEdge, -kDeckThickness, kEdge, -kDeckThickness, s.concrete}};
  for (const Strip& t : strips) {
    addQuad(mesh,
            {at(a, t.over0, t.up0), at(a, t.over1, t.up1), at(b, t.over1, t.up1),
             at(b, t.over0, t.up0)},
            t.surface);
  }
  for (const float side : {-1.0F, 1.0F}) {
    const Strip sides[] = {{side * kRoad, 0, side * kRoad, kKerb, s.walkway},
                           {side * kRoad, kKerb, side * kEdge, kKerb, s.walkway},
                           {side * kEdge, kKerb, side * kEdge, -kDeckThickness, s.concrete}};
    for (const Strip& t : sides) {
      addQuad(mesh,
              {at(a, t.over0, t.up0), at(a, t.over1, t.up1), at(b, t.over1, t.up1),
               at(b, t.over0, t.up0)},
              t.surface);
    }
    for (const float up : {0.35F, 0.7F, 1.0F}) {
      const float over = side * (kEdge - 0.1F);
      addPost(mesh,
              {at(a, over, kKerb + up * kRailing), at(b, over, kKerb + up * kRailing), 0.025F,
               0.025F, 5},
              s.metal);
    }
  }
}

void addRailingPosts(Mesh& mesh, const Deck::Point& p, std::uint32_t metal) {
  for (const float side : {-1.0F, 1.0F}) {
    const float over = side * (kEdge - 0.1F);
    addPost(mesh, {at(p, over, 0), at(p, over, kKerb + kRailing), 0.035F, 0.035F, 6}, metal);
  }
}

/// A wall across the end of the deck, with wing walls along it, that reaches into the ground.
void addAbutment(Mesh& mesh, const StreetPlan& plan, const Deck::Point& end,
                 const Deck::Point& inside, std::uint32_t concrete) {
  const auto foot = [&](const Vec3& top) {
    const double ground = plan.height(static_cast<double>(top.x), static_cast<double>(top.y));
    return Vec3{top.x, top.y, std::min(top.z, static_cast<float>(ground) - kFoot)};
  };
  const auto wall = [&](const Vec3& a, const Vec3& b) {
    addQuad(mesh, {foot(a), foot(b), b, a}, concrete);
  };
  wall(at(inside, -kEdge, -kDeckThickness + 0.01F), at(inside, kEdge, -kDeckThickness + 0.01F));
  for (const float side : {-1.0F, 1.0F}) {
    wall(at(inside, side * kEdge, kKerb), at(end, side * kEdge, kKerb));
  }
}

DeckSurfaces addSurfaces(World& world) {
  const auto add = [&](Material material, float tone, std::uint32_t seed) {
    Surface surface;
    surface.material = material;
    surface.tone = tone;
    surface.seed = seed;
    return world.addSurface(surface);
  };
  return {add(Material::Road, 0.19F, 871), add(Material::Kerb, 0.3F, 872),
          add(Material::Plain, 0.33F, 873), add(Material::Plain, 0.2F, 874)};
}

}  // namespace

void addBridges(World& world, const StreetPlan& plan) {
  if (plan.decks().empty()) return;
  const DeckSurfaces surfaces = addSurfaces(world);
  constexpr std::size_t kAbutment = 8;  // points from each end that are over the embankment
  for (const Deck& deck : plan.decks()) {
    const std::vector<Deck::Point>& points = deck.points;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
      addSlice(world.fixed, points[i], points[i + 1], surfaces);
      if (i % kPostEvery == 0) addRailingPosts(world.fixed, points[i], surfaces.metal);
    }
    const std::size_t inside = std::min(kAbutment, points.size() - 1);
    addAbutment(world.fixed, plan, points.front(), points[inside], surfaces.concrete);
    addAbutment(world.fixed, plan, points.back(), points[points.size() - 1 - inside],
                surfaces.concrete);
  }
}

}  // namespace tolman::town
