// SPDX-License-Identifier: BSD-3-Clause
// The shift search against known shifts and a search by the plain formula.
#include <catch2/catch.hpp>
#include <cmath>

#include "profile.hpp"
#include "tolman/context.hpp"

using namespace tolman;
using namespace tolman::scanline;

namespace {

/// Smooth but not periodic.
double wave(double x) {
  return 0.5 + 0.2 * std::sin(0.21 * x) + 0.15 * std::sin(0.077 * x + 1) +
         0.1 * std::sin(0.0131 * x * x / 10);
}

/// The scene moved to the right by `moved`.
Profile waveMoved(double moved, int samples = 200) {
  Profile profile;
  for (int i = 0; i < samples; ++i) profile.push_back(static_cast<float>(wave(i - moved)));
  return profile;
}

Profile randomProfile(RandomStream& random, int samples) {
  Profile profile;
  for (int i = 0; i < samples; ++i) profile.push_back(static_cast<float>(random.uniform()));
  return profile;
}

/// Straight from the description.
double naiveDifference(const Profile& a, const Profile& b, int moved) {
  const int size = static_cast<int>(a.size());
  double mean_a = 0;
  double mean_b = 0;
  int count = 0;
  for (int i = 0; i < size; ++i) {
    if (i + moved < 0 || i + moved >= size) continue;
    mean_a += a[static_cast<std::size_t>(i)];
    mean_b += b[static_cast<std::size_t>(i + moved)];
    ++count;
  }
  double sum = 0;
  for (int i = 0; i < size; ++i) {
    if (i + moved < 0 || i + moved >= size) continue;
    sum += std::abs(b[static_cast<std::size_t>(i + moved)] - mean_b / count -
                    a[static_cast<std::size_t>(i)] + mean_a / count);
  }
  return sum / count;
}

}  // namespace

TEST_CASE("a known shift is found to a part of a sample, in sign and size") {
  const double moved = GENERATE(-30.0, -7.3, -1.0, -0.4, 0.0, 0.25, 2.4, 12.0, 38.6);
  const ProfileMatch match = matchProfiles(waveMoved(0), waveMoved(moved), 40);
  INFO(moved);
  CHECK(match.moved_right == Approx(moved).margin(0.1));
  CHECK(match.compared == 200 - std::abs(std::lround(moved)));
  CHECK(match.difference < 0.02);
}

TEST_CASE("the best shift is that of the plain formula") {
  RandomStream random(11);
  for (int trial = 0; trial < 20; ++trial) {
    const Profile a = randomProfile(random, 60);
    const Profile b = randomProfile(random, 60);
    double least = 1e9;
    int best = 0;
    for (int moved = -15; moved <= 15; ++moved) {
      const double difference = naiveDifference(a, b, moved);
      if (difference >= least) continue;
      least = difference;
      best = moved;
    }
    const ProfileMatch match = matchProfiles(a, b, 15);
    CHECK(match.difference == Approx(least).epsilon(1e-5));
    CHECK(std::abs(match.moved_right - best) <= 0.5);
  }
}

TEST_CASE("equal profiles: no motion, no difference") {
  const ProfileMatch match = matchProfiles(waveMoved(0), waveMoved(0), 40);
  CHECK(match.moved_right == Approx(0).margin(1e-9));
  CHECK(match.difference == 0);
}

TEST_CASE("a change of exposure is no motion") {
  Profile brighter = waveMoved(4);
  for (float& value : brighter) value += 0.2F;
  const ProfileMatch match = matchProfiles(waveMoved(0), brighter, 40);
  CHECK(match.moved_right == Approx(4).margin(0.05));
  CHECK(match.difference < 1e-4);
}

TEST_CASE("a shift beyond half of the profile is not looked for") {
  const ProfileMatch match = matchProfiles(waveMoved(0, 40), waveMoved(0, 40), 1000);
  CHECK(match.moved_right == Approx(0).margin(1e-9));
  CHECK(match.compared == 40);
}

TEST_CASE("doubt is the width of the valley: small for edges, large for fences") {
  RandomStream random(5);
  const Profile edges = randomProfile(random, 200);
  CHECK(matchProfiles(edges, edges, 40).uncertainty <= 1);
  Profile fence;  // every 20th sample a picket: any multiple of 20 fits
  for (int i = 0; i < 200; ++i) fence.push_back(i % 20 < 3 ? 1.0F : 0.0F);
  CHECK(matchProfiles(fence, fence, 45).uncertainty >= 40);
}
