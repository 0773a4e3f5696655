// SPDX-License-Identifier: BSD-3-Clause
// One house: walls with facades, a roof, chimneys.
#include "noise.hpp"
#include "objects.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

constexpr float kSunk = 2;         // m that walls reach below ground, for slopes
constexpr float kOverhang = 0.4F;  // m

/// Builds in axes of the house: u along the street, v away from it, up.
class HouseBuilder {
 public:
  HouseBuilder(World& world, const House& house)
      : world_(world),
        house_(house),
        length_(static_cast<float>(house.plot.half_length)),
        depth_(static_cast<float>(house.plot.half_depth)),
        eaves_(kStorey * static_cast<float>(house.storeys) + 0.3F),
        ridge_(eaves_) {}

  void build() {
    const bool to_street = house_.roof == RoofShape::ToStreet;
    if (house_.roof == RoofShape::Flat) {
      walls();
      flatRoof();
      return;
    }
    ridge_ += between(draw(1), 0.6F, 1.1F) * (to_street ? length_ : depth_);
    walls();
    gableRoof(to_street);
    chimney();
  }

 private:
  std::uint32_t draw(std::uint32_t what) const { return hash(house_.seed, what); }

  Vec3 at(float u, float v, float z) const {
    const Eigen::Vector2d p = house_.plot.point(u, v);
    return {static_cast<float>(p.x()), static_cast<float>(p.y()),
            static_cast<float>(house_.ground) + z};
  }
  Vec3 direction(float u, float v) const { return at(u, v, 0) - at(0, 0, 0); }

  /// A wall from (u0, v0) to (u1, v1); `gable`: with a gable up to the ridge.
  void wall(float u0, float v0, float u1, float v1, bool gable) {
    Surface facade = {.material = Material::Facade,
                      .seed = house_.seed,
                      .tone = between(draw(2), 0.3F, 0.8F),
                      .origin = at(u0, v0, 0)};
    const Vec3 span = at(u1, v1, 0) - facade.origin;
    facade.axis_u = normalised(span);
    facade.width = norm(span);
    facade.height = eaves_;
    const std::uint32_t surface = world_.addSurface(facade);
    const Vec3 left = at(u0, v0, eaves_);
    const Vec3 right = at(u1, v1, eaves_);
    addQuad(world_.fixed, {at(u0, v0, -kSunk), at(u1, v1, -kSunk), right, left}, surface);
    if (!gable) return;
    addTriangle(world_.fixed, {left, right, at(0.5F * (u0 + u1), 0.5F * (v0 + v1), ridge_)},
                surface);
  }

  void walls() {
    const bool along = house_.roof == RoofShape::AlongStreet;
    const bool to_street = house_.roof == RoofShape::ToStreet;
    wall(-length_, -depth_, length_, -depth_, to_street);
    wall(length_, -depth_, length_, depth_, along);
    wall(length_, depth_, -length_, depth_, to_street);
    wall(-length_, depth_, -length_, -depth_, along);
  }

  /// A roof of two slopes. `to_street`: the ridge is perpendicular to the street.
  void gableRoof(bool to_street) {
    const float run = to_street ? length_ : depth_;  // from ridge to eaves
    const float span = (to_street ? depth_ : length_) + kOverhang;
    const float low = eaves_ - kOverhang * (ridge_ - eaves_) / run;
    const auto corner = [&](float r, float s, float z) {
      return to_street ? at(r, s, z) : at(s, r, z);
    };
    for (const float side : {-1.0F, 1.0F}) {
      const float r = side * (run + kOverhang);
      const std::array<Vec3, 4> slope = {corner(r, -span, low), corner(r, span, low),
                                         corner(0, span, ridge_), corner(0, -span, ridge_)};
      addQuad(world_.fixed, slope,
              world_.addSurface({.material = Material::Roof,
                                 .seed = draw(3),
                                 .tone = between(draw(4), 0.07F, 0.24F),
                                 .origin = slope[0],
                                 .axis_u = normalised(slope[1] - slope[0]),
                                 .axis_v = normalised(slope[3] - slope[0])}));
    }
  }

  void flatRoof() {
    const float u = length_ + 0.15F;
    const float v = depth_ + 0.15F;
    addBox(world_.fixed, at(-u, -v, eaves_),
           {direction(2 * u, 0), direction(0, 2 * v), Vec3{0, 0, 0.45F}},
           world_.addSurface({.seed = draw(5), .tone = between(draw(6), 0.2F, 0.5F)}));
  }

  void chimney() {
    const float u = between(draw(9), -0.6F, 0.6F) * length_;
    const float v = between(draw(10), -0.3F, 0.3F) * depth_;
    addBox(world_.fixed, at(u, v, eaves_),
           {direction(0.6F, 0), direction(0, 0.6F), Vec3{0, 0, ridge_ - eaves_ + 0.7F}},
           world_.addSurface({.seed = draw(7), .tone = between(draw(8), 0.12F, 0.3F)}));
  }

  World& world_;
  const House& house_;
  float length_;  // m, half
  float depth_;   // m, half
  float eaves_;
  float ridge_;
};

}  // namespace

void addHouse(World& world, const House& house) { HouseBuilder(world, house).build(); }

}  // namespace tolman::town
