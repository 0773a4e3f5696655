// SPDX-License-Identifier: BSD-3-Clause
// The car park as triangles, and the path of the camera through it.
#include <algorithm>
#include <array>

#include "buildings.hpp"
#include "noise.hpp"
#include "world.hpp"

namespace tolman::town {
namespace {

constexpr float kFloorThickness = 0.3F;  ///< m thick
constexpr float kParapet = 1.0F;         ///< m high
constexpr float kRampHalf = 2.0F;        ///< m, half its width
constexpr float kApron = 6.0F;           ///< m of floor before the entrance
constexpr float kEntranceWest = -6;      ///< m, x
constexpr float kEntranceEast = 3;
constexpr double kBay = 2.6;  ///< m, width of a parking bay

constexpr auto kWest = static_cast<float>(CarPark::kWest);
constexpr auto kEast = static_cast<float>(CarPark::kEast);
constexpr auto kSouth = static_cast<float>(CarPark::kSouth);
constexpr auto kNorth = static_cast<float>(CarPark::kNorth);
constexpr auto kRampBegin = static_cast<float>(CarPark::kRampBegin);
constexpr auto kRampEnd = static_cast<float>(CarPark::kRampBegin + CarPark::kRampLength);
constexpr std::array kRamps = {static_cast<float>(CarPark::kRampDown),
                               static_cast<float>(CarPark::kRampUp)};

class CarParkBuilder {
 public:
  CarParkBuilder(World& world, double floor, std::uint32_t seed)
      : world_(world),
        floor_(static_cast<float>(floor)),
        seed_(seed),
        asphalt_(world.addSurface({.material = Material::Road, .seed = 881, .tone = 0.26F})),
        concrete_(world.addSurface({.seed = 882, .tone = 0.42F})),
        paint_(world.addSurface({.material = Material::Paint, .seed = 883, .tone = 0.75F})) {}

  void build() {
    for (int level = 0; level <= CarPark::kFloors; ++level) plate(level);
    quad({{kEntranceWest, kSouth - kApron}, {kEntranceEast, kSouth}}, floor_ + 0.004F, asphalt_);
    for (int level = 0; level < CarPark::kFloors; ++level) {
      walls(level);
      pillars(level);
      bays(level);
      if (level + 1 == CarPark::kFloors) break;
      for (const float middle : kRamps) ramp(level, middle);
    }
  }

 private:
  struct Point {
    float x, y;
  };
  struct Rectangle {
    Point low, high;
  };

  static Vec3 at(float x, float y, float z) {
    return {x, y + static_cast<float>(CarPark::kAisleY), z};
  }
  float levelAt(int level) const {
    return floor_ + static_cast<float>(CarPark::kStorey) * static_cast<float>(level);
  }
  void quad(const Rectangle& r, float z, std::uint32_t surface) {
    addQuad(world_.fixed,
            {at(r.low.x, r.low.y, z), at(r.high.x, r.low.y, z), at(r.high.x, r.high.y, z),
             at(r.low.x, r.high.y, z)},
            surface);
  }
  void box(const Rectangle& r, float low, float high) {
    addBox(world_.fixed, at(r.low.x, r.low.y, low),
           {Vec3{r.high.x - r.low.x, 0, 0}, Vec3{0, r.high.y - r.low.y, 0}, Vec3{0, 0, high - low}},
           concrete_);
  }

  /// A floor with its underside, with openings above the ramps from below; the last one is the
  /// roof.
  void plate(int level) {
    const float z = levelAt(level);
    const std::array<float, 6> x = {kWest,
                                    kRamps[0] - kRampHalf,
                                    kRamps[0] + kRampHalf,
                                    kRamps[1] - kRampHalf,
                                    kRamps[1] + kRampHalf,
                                    kEast};
    const std::array<float, 4> y = {kSouth, kRampBegin, kRampEnd, kNorth};
    const bool is_open = level > 0 && level < CarPark::kFloors;
    for (std::size_t c = 0; c + 1 < x.size(); ++c) {
      for (std::size_t r = 0; r + 1 < y.size(); ++r) {
        if (is_open && c % 2 == 1 && r == 1) continue;
        const Rectangle part = {{x[c], y[r]}, {x[c + 1], y[r + 1]}};
        quad(part, z, asphalt_);
        if (level > 0) quad(part, z - kFloorThickness, concrete_);
      }
    }
    // The edge of the floor, and parapets beside the openings.
    if (level == 0) return;
    edge({kWest, kSouth}, {kEast, kSouth}, z);
    edge({kEast, kSouth}, {kEast, kNorth}, z);
    edge({kEast, kNorth}, {kWest, kNorth}, z);
    edge({kWest, kNorth}, {kWest, kSouth}, z);
    for (const float middle : kRamps) {
      if (!is_open) break;
      for (const float side : {-1.0F, 1.0F}) {
        const float over = middle + side * (kRampHalf + 0.1F);
        box({{over - 0.08F, kRampBegin}, {over + 0.08F, kRampEnd}}, z - kFloorThickness,
            z + kParapet);
      }
      // Cars drive on to the next ramp at the northern end, but on the uppermost floor.
      if (level + 1 < CarPark::kFloors) continue;
      box({{middle - kRampHalf, kRampEnd - 0.08F}, {middle + kRampHalf, kRampEnd + 0.08F}},
          z - kFloorThickness, z + kParapet);
    }
  }

  void edge(const Point& a, const Point& b, float z) {
    const float below = z - kFloorThickness;
    addQuad(world_.fixed,
            {at(a.x, a.y, below), at(b.x, b.y, below), at(b.x, b.y, z), at(a.x, a.y, z)},
            concrete_);
  }

  /// Parapets around the floor; the lowest one has the entrance.
  void walls(int level) {
    const float z = levelAt(level);
    constexpr float kThick = 0.15F;
    const auto wall = [&](const Rectangle& r) { box(r, z, z + kParapet); };
    wall({{kWest, kSouth}, {kWest + kThick, kNorth}});
    wall({{kEast - kThick, kSouth}, {kEast, kNorth}});
    wall({{kWest, kNorth - kThick}, {kEast, kNorth}});
    if (level > 0) return wall({{kWest, kSouth}, {kEast, kSouth + kThick}});
    wall({{kWest, kSouth}, {kEntranceWest, kSouth + kThick}});
    wall({{kEntranceEast, kSouth}, {kEast, kSouth + kThick}});
  }

  void pillars(int level) {
    constexpr float kHalf = 0.22F;
    const float z = levelAt(level);
    for (const float x : {-8.6F, 4.2F, 9.8F, 16.0F, 22.2F, 27.8F, 40.6F}) {
      for (const float y : {-3.5F, 9.0F, 17.7F, 26.3F, 35.0F, 47.5F}) {
        box({{x - kHalf, y - kHalf}, {x + kHalf, y + kHalf}}, z,
            z + static_cast<float>(CarPark::kStorey) - kFloorThickness);
      }
    }
  }

  /// A ramp up from `level`, from north to south, in slices of half a metre.
  void ramp(int level, float middle) {
    constexpr float kStep = 0.5F;  // m
    const float z = levelAt(level);
    const auto heightAt = [&](float y) {
      return z + static_cast<float>(CarPark::rampHeight(static_cast<double>(kRampEnd - y)));
    };
    for (float y = kRampBegin; y < kRampEnd - 0.01F; y += kStep) {
      slice(middle, {y, heightAt(y)}, {y + kStep, heightAt(y + kStep)});
    }
  }

  /// Roadway, underside and side walls; points are (y, z).
  void slice(float middle, const Point& a, const Point& b) {
    const auto strip = [&](float x0, float up0, float x1, float up1, std::uint32_t surface) {
      addQuad(world_.fixed,
              {at(x0, a.x, a.y + up0), at(x1, a.x, a.y + up1), at(x1, b.x, b.y + up1),
               at(x0, b.x, b.y + up0)},
              surface);
    };
    strip(middle - kRampHalf, 0, middle + kRampHalf, 0, asphalt_);
    strip(middle - kRampHalf, -kFloorThickness, middle + kRampHalf, -kFloorThickness, concrete_);
    for (const float side : {-kRampHalf, kRampHalf}) {
      strip(middle + side, -kFloorThickness, middle + side, 0.8F, concrete_);
    }
  }

  /// Lines between parking bays, and a car in most of them; the same on all floors.
  void bays(int level) {
    std::uint32_t number = 0;
    const auto bay = [&](double x, double y, float yaw) {
      const bool across = yaw == 0;
      const double half = 2.5;
      for (const double side : {-kBay / 2, kBay / 2}) {
        line(level, across ? x - half : x + side, across ? y + side : y - half, across);
      }
      const std::uint32_t own = hash(seed_, number++, 884);
      if (unit(hash(own, 1)) > 0.7F) return;
      const float turned = unit(hash(own, 2)) < 0.4F ? 3.1416F : 0.0F;
      const Vec3 place = at(static_cast<float>(x), static_cast<float>(y), levelAt(level));
      world_.instances.push_back(
          {world_.cars[own % world_.cars.size()], Placement::at(place, yaw + turned), own});
    };
    for (double y = 6; y < 41; y += kBay) {
      bay(-5.8, y, 0);
      bay(37.8, y, 0);
    }
    for (double x = 11.6; x < 21; x += kBay) {
      bay(x, 5.6, 1.5708F);
      bay(x, 38.4, 1.5708F);
    }
  }

  void line(int level, double x, double y, bool across) {
    const auto x0 = static_cast<float>(x);
    const auto y0 = static_cast<float>(y);
    const Rectangle r = across ? Rectangle{{x0, y0 - 0.05F}, {x0 + 5, y0 + 0.05F}}
                               : Rectangle{{x0 - 0.05F, y0}, {x0 + 0.05F, y0 + 5}};
    quad(r, levelAt(level) + 0.012F, paint_);
  }

  World& world_;
  float floor_;
  std::uint32_t seed_;
  std::uint32_t asphalt_;
  std::uint32_t concrete_;
  std::uint32_t paint_;
};

constexpr double kRadius = 6;           ///< m, of turns
constexpr double kBlend = 5;            ///< m of changing slope at both ends of a ramp
constexpr double kExitLane = -3.4;      ///< m, x
constexpr double kEntranceFloor = 4.2;  ///< m of floor before the entrance
constexpr double kSlope = CarPark::kStorey / (CarPark::kRampLength - kBlend);
/// m from the end of a turn to the ramp.
constexpr double kBeforeRamp = CarPark::kRampBegin - kRadius;

class Driver {
 public:
  CarParkDrive drive() {
    path().ahead(CarPark::kAisleY);
    for (int round = 0; round < 2; ++round) {
      for (int floor = 0; floor + 1 < CarPark::kFloors; ++floor) climb();
      // Across the uppermost floor to its eastern aisle.
      aheadAndRight(CarPark::kLength).aheadAndRight(CarPark::kEastAisle);
      aheadAndRight(CarPark::kLength);
      for (int floor = 0; floor + 1 < CarPark::kFloors; ++floor) descend();
      if (round == 0) aheadAndRight(CarPark::kEastAisle);
    }
    path().ahead(CarPark::kEastAisle - kExitLane).turnLeft(4);
    path().ahead(CarPark::kAisleY - 10);
    drive_.inside_from = CarPark::kAisleY + CarPark::kSouth - kEntranceFloor;
    drive_.inside_to = path().length() - (CarPark::kAisleY - 10) - CarPark::kSouth + kEntranceFloor;
    return std::move(drive_);
  }

 private:
  LanePath& path() { return drive_.path; }
  Driver& aheadAndRight(double length) {
    path().ahead(length).turnRight(kRadius);
    return *this;
  }

  /// From the southern end of the western aisle to that of the floor above.
  void climb() {
    aheadAndRight(CarPark::kLength).aheadAndRight(CarPark::kRampUp);
    ramp(true);
    aheadAndRight(CarPark::kRampUp);
  }

  /// From the southern end of the eastern aisle to that of the floor below.
  void descend() {
    aheadAndRight(CarPark::kEastAisle - CarPark::kRampDown);
    ramp(false);
    aheadAndRight(CarPark::kEastAisle - CarPark::kRampDown).aheadAndRight(CarPark::kLength);
  }

  void ramp(bool up) {
    drive_.ramps.push_back({path().length() + kBeforeRamp, height_, up});
    height_ += up ? CarPark::kStorey : -CarPark::kStorey;
    aheadAndRight(CarPark::kLength);
  }

  CarParkDrive drive_;
  double height_ = 0;
};

}  // namespace

double CarPark::rampHeight(double along) {
  const double t = std::clamp(along, 0.0, kRampLength);
  const double end = kRampLength - t;
  if (t < kBlend) return kSlope * t * t / (2 * kBlend);
  if (end < kBlend) return kStorey - kSlope * end * end / (2 * kBlend);
  return kSlope * (t - kBlend / 2);
}

double CarPark::rampSlope(double along) {
  if (along <= 0 || along >= kRampLength) return 0;
  return kSlope * std::min({1.0, along / kBlend, (kRampLength - along) / kBlend});
}

CarParkHeight CarParkDrive::at(double s) const {
  CarParkHeight found;
  for (const Ramp& ramp : ramps) {
    if (s < ramp.begin) break;
    const double sign = ramp.up ? 1 : -1;
    found.height = ramp.bottom + sign * CarPark::rampHeight(s - ramp.begin);
    found.slope = sign * CarPark::rampSlope(s - ramp.begin);
  }
  return found;
}

CarParkDrive carParkDrive() { return Driver().drive(); }

Plot carParkPlot() {
  return {{(CarPark::kWest + CarPark::kEast) / 2,
           CarPark::kAisleY + (CarPark::kSouth + CarPark::kNorth) / 2},
          Eigen::Vector2d::UnitX(),
          (CarPark::kEast - CarPark::kWest) / 2 + 2,
          (CarPark::kNorth - CarPark::kSouth) / 2 + 4};
}

void addCarPark(World& world, double floor, std::uint32_t seed) {
  CarParkBuilder(world, floor, seed).build();
}

}  // namespace tolman::town
