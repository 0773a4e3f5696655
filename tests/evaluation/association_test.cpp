// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/association.hpp"

#include <catch2/catch.hpp>

#include "evaluation/paths.hpp"

using namespace tolman;
using namespace tolman::evaluation;

TEST_CASE("frames match by index, and coverage counts the truth") {
  const Trajectory truth = test::straightPath(10);
  Trajectory estimate = test::straightPath(12);
  estimate.erase(estimate.begin() + 3);  // a dropped frame
  const Matches matches = associateByFrame(truth, estimate).value();
  CHECK(matches.size() == 9);
  CHECK(matches.coverage() == Approx(0.9));
  Matches lost = matches;
  for (std::size_t i = 0; i < 3; ++i) lost.estimate[i].tracked = false;
  CHECK(lost.coverage() == Approx(0.6));
  for (std::size_t i = 0; i < matches.size(); ++i) {
    CHECK(matches.truth[i].frame == matches.estimate[i].frame);
  }
}

TEST_CASE("no match is an error, never a perfect score") {
  Trajectory late = test::straightPath(3);
  for (TrajectoryPose& pose : late) pose.frame += 100;
  const auto by_frame = associateByFrame(test::straightPath(3), late);
  CHECK(by_frame.status().message() ==
        "no pose of the estimate (3) matches one of the truth (3) by frame index; check that both "
        "are of the same run");
  CHECK_FALSE(associateByFrame({}, late).isOk());
  CHECK_FALSE(associateByFrame(late, {}).isOk());
  CHECK_FALSE(associateByStamp({}, late, 1).isOk());
}

TEST_CASE("stamps match the nearest within the limit, one to one") {
  const Trajectory truth = test::straightPath(4);  // 0, 100, 200, 300 ms
  Trajectory estimate = test::straightPath(5);
  const std::int64_t ms = 1'000'000;
  estimate[0].stamp_ns = 8 * ms;    // truth 0
  estimate[1].stamp_ns = 95 * ms;   // truth 1, 5 ms off
  estimate[2].stamp_ns = 102 * ms;  // truth 1, nearer
  estimate[3].stamp_ns = 150 * ms;  // too far from both
  estimate[4].stamp_ns = 309 * ms;  // truth 3
  const Matches matches = associateByStamp(truth, estimate, 10 * ms).value();
  REQUIRE(matches.size() == 3);
  CHECK(matches.truth[1].frame == 1);
  CHECK(matches.estimate[1].frame == 2);
  CHECK(matches.truth[2].frame == 3);
  CHECK(matches.coverage() == Approx(0.75));
  CHECK_FALSE(associateByStamp(truth, {estimate[3]}, 10 * ms).isOk());
}

TEST_CASE("matching by stamp agrees with looking at every pair") {
  RandomStream random(3);
  for (int round = 0; round < 50; ++round) {
    Trajectory truth = test::straightPath(20);
    Trajectory estimate = test::straightPath(7);
    for (auto* path : {&truth, &estimate}) {
      std::int64_t stamp = 0;
      for (auto& pose : *path) {
        pose.stamp_ns = stamp +=
            static_cast<std::int64_t>(1 + random.below(path == &truth ? 5 : 20));
      }
    }
    const auto result = associateByStamp(truth, estimate, 2);
    std::size_t expected = 0;  // truths that are the nearest of some estimate
    std::int64_t last = -1;
    for (const auto& pose : estimate) {
      std::int64_t best = 0;
      for (std::int64_t i = 0; i < 20; ++i) {
        const auto d = [&](std::int64_t k) {
          return std::abs(truth[static_cast<std::size_t>(k)].stamp_ns - pose.stamp_ns);
        };
        if (d(i) < d(best)) best = i;
      }
      if (std::abs(truth[static_cast<std::size_t>(best)].stamp_ns - pose.stamp_ns) > 2) continue;
      expected += best != last ? 1 : 0;
      last = best;
    }
    CHECK((result.isOk() ? result.value().size() : 0) == expected);
  }
}
