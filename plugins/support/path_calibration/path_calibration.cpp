// SPDX-License-Identifier: BSD-3-Clause
#include "path_calibration.hpp"

#include <cmath>
#include <cstdio>
#include <numbers>

namespace tolman {

using namespace steady_error;

Eigen::Matrix<double, 6, kSpatialErrors> steadyEffect(const Eigen::Isometry3d& motion,
                                                      double seconds) {
  const double length = motion.translation().norm();
  Eigen::Matrix<double, 6, kSpatialErrors> effect =
      Eigen::Matrix<double, 6, kSpatialErrors>::Zero();
  effect.col(kTurns).tail<3>() = logSo3(motion.linear());
  effect(4, kTurnPerSecond) = -seconds;  // to the left is about -y
  effect(4, kTurnPerMetre) = -length;
  effect(0, kLeft) = -length;
  effect(1, kDown) = length;
  return effect;
}

namespace {

std::string rounded(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", number);
  return text;
}

/// "0.13 deg/s (+- 0.01)"
std::string withSigma(double number, double sigma, const char* unit) {
  return rounded(std::abs(number)) + unit + " (+- " + rounded(sigma) + ")";
}

/// Two standard deviations from none.
bool isKnown(double error, double sigma) { return sigma > 0 && std::abs(error) > 2 * sigma; }

void describeNoise(double factor, const char* what, std::vector<std::string>& sentences) {
  if (factor > 0.6 && factor < 1.7) return;
  sentences.push_back(std::string(what) + " are " + rounded(factor) + " times as noisy as assumed");
}

}  // namespace

std::vector<std::string> describe(const PathCalibration& calibration) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  std::vector<std::string> sentences;
  const auto& b = calibration.errors;
  const auto& s = calibration.sigmas;
  if (isKnown(calibration.turning, calibration.turning_sigma)) {
    sentences.push_back(
        "the robot turns " +
        withSigma(kDegrees * calibration.turning, kDegrees * calibration.turning_sigma, " deg/s") +
        " more to the " + (calibration.turning > 0 ? "left" : "right") + " than odometry says");
  }
  if (isKnown(b[kTurns], s[kTurns])) {
    sentences.push_back("reported turns are " + withSigma(100 * b[kTurns], 100 * s[kTurns], " %") +
                        (b[kTurns] > 0 ? " too small" : " too large"));
  }
  if (isKnown(b[kLeft], s[kLeft])) {
    sentences.push_back("the robot drifts " + withSigma(100 * b[kLeft], 100 * s[kLeft], " %") +
                        " of the way to the " + (b[kLeft] > 0 ? "left" : "right"));
  }
  if (isKnown(b[kDown], s[kDown])) {
    sentences.push_back("the robot " + std::string(b[kDown] > 0 ? "sinks" : "climbs") + " by " +
                        withSigma(100 * b[kDown], 100 * s[kDown], " %") + " of the way");
  }
  describeNoise(calibration.noise_distance, "distances", sentences);
  describeNoise(calibration.noise_turns, "turns", sentences);
  return sentences;
}

}  // namespace tolman
