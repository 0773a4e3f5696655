// SPDX-License-Identifier: BSD-3-Clause
// The path of the camera through the car park.
#include <algorithm>

#include "car_park.hpp"

namespace tolman::town {
namespace {

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
      path().ahead(CarPark::kLength).turnRight(kRadius);
      path().ahead(CarPark::kEastAisle).turnRight(kRadius);
      path().ahead(CarPark::kLength).turnRight(kRadius);
      for (int floor = 0; floor + 1 < CarPark::kFloors; ++floor) descend();
      if (round == 0) path().ahead(CarPark::kEastAisle).turnRight(kRadius);
    }
    path().ahead(CarPark::kEastAisle - kExitLane).turnLeft(4);
    path().ahead(CarPark::kAisleY - 10);
    drive_.inside_from = CarPark::kAisleY + CarPark::kSouth - kEntranceFloor;
    drive_.inside_to = path().length() - (CarPark::kAisleY - 10) - CarPark::kSouth + kEntranceFloor;
    return std::move(drive_);
  }

 private:
  LanePath& path() { return drive_.path; }

  /// From the southern end of the western aisle to that of the floor above.
  void climb() {
    path().ahead(CarPark::kLength).turnRight(kRadius);
    path().ahead(CarPark::kRampUp).turnRight(kRadius);
    ramp(true);
    path().ahead(CarPark::kRampUp).turnRight(kRadius);
  }

  /// From the southern end of the eastern aisle to that of the floor below.
  void descend() {
    path().ahead(CarPark::kEastAisle - CarPark::kRampDown).turnRight(kRadius);
    ramp(false);
    path().ahead(CarPark::kEastAisle - CarPark::kRampDown).turnRight(kRadius);
    path().ahead(CarPark::kLength).turnRight(kRadius);
  }

  void ramp(bool up) {
    drive_.ramps.push_back({path().length() + kBeforeRamp, height_, up});
    height_ += up ? CarPark::kStorey : -CarPark::kStorey;
    path().ahead(CarPark::kLength).turnRight(kRadius);
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

}  // namespace tolman::town
