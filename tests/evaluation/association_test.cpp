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
  CHECK_FALSE(associate({}, late, {MatchRule::Nearest, 1}).isOk());
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
  const Matches matches = associate(truth, estimate, {MatchRule::Nearest, 10 * ms}).value();
  REQUIRE(matches.size() == 3);
  CHECK(matches.truth[1].frame == 1);
  CHECK(matches.estimate[1].frame == 2);
  CHECK(matches.truth[2].frame == 3);
  CHECK(matches.coverage() == Approx(0.75));
  CHECK_FALSE(associate(truth, {estimate[3]}, {MatchRule::Nearest, 10 * ms}).isOk());
}

TEST_CASE("matching by stamp agrees with taking the nearest pair of all, again and again") {
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
    const auto result = associate(truth, estimate, {MatchRule::Nearest, 2});
    std::size_t expected = 0;  // the nearest pair of those that are left, again and again
    std::vector<std::int64_t> left;
    for (const auto& pose : truth) left.push_back(pose.stamp_ns);
    std::vector<std::int64_t> stamps;
    for (const auto& pose : estimate) stamps.push_back(pose.stamp_ns);
    for (std::int64_t apart = 0; apart <= 2; ++apart) {
      for (auto at = left.begin(); at != left.end();) {
        const auto found = std::ranges::find_if(
            stamps, [&](std::int64_t stamp) { return std::abs(stamp - *at) == apart; });
        const bool is_pair = found != stamps.end();
        if (is_pair) stamps.erase(found);
        at = is_pair ? left.erase(at) : at + 1;
        expected += is_pair ? 1 : 0;
      }
    }
    CHECK((result.isOk() ? result.value().size() : 0) == expected);
  }
}

namespace {

/// The path with its stamps moved by `offset_ns`.
Trajectory later(Trajectory path, std::int64_t offset_ns) {
  for (TrajectoryPose& pose : path) pose.stamp_ns += offset_ns;
  return path;
}

/// Every `step`th pose, numbered anew, as of a file.
Trajectory thinned(const Trajectory& path, std::size_t step) {
  Trajectory result;
  for (std::size_t i = 0; i < path.size(); i += step) {
    result.push_back(path[i]);
    result.back().frame = static_cast<std::int64_t>(i / step);
  }
  return result;
}

constexpr std::int64_t kMs = 1'000'000;

}  // namespace

TEST_CASE("poses are matched by time where both have stamps of one clock") {
  const Trajectory truth = test::straightPath(50);  // every 100 ms
  CHECK(usualDifference(truth, truth) == 50 * kMs);
  CHECK(usualDifference(truth, thinned(truth, 3)) == 50 * kMs);
  CHECK(usualDifference(thinned(truth, 3), truth) == 50 * kMs);
  Trajectory fast = truth;
  for (TrajectoryPose& pose : fast) pose.stamp_ns /= 100;
  CHECK(usualDifference(fast, truth) == 20 * kMs);
  CHECK(usualDifference(truth, later(truth, 5'000 * kMs)) == -1);
  CHECK(usualDifference(truth, later(truth, -5'000 * kMs)) == -1);
}

TEST_CASE("files without stamps are matched by frame") {
  Trajectory kitti = test::straightPath(10);
  for (TrajectoryPose& pose : kitti) pose.stamp_ns = 0;
  CHECK_FALSE(hasStamps(kitti));
  CHECK_FALSE(hasStamps({}));
  CHECK(hasStamps(test::straightPath(2)));
  CHECK(usualDifference(kitti, test::straightPath(10)) == -1);
  CHECK(usualDifference(test::straightPath(10), kitti) == -1);
}
