// SPDX-License-Identifier: BSD-3-Clause
// True poses that stand still and then jump.
#include "true_speeds.hpp"

#include <catch2/catch.hpp>

#include "data_folder.hpp"
#include "kitti_source.hpp"

namespace tolman::image_folders {
namespace {

/// The warning for poses at `positions` (m), 0.1 s apart, in lines from 5; "" for none.
std::string speedWarning(const std::vector<double>& positions, std::int64_t step_ns = 100'000'000) {
  StampedPoses truth;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    truth.stamps_ns.push_back(static_cast<std::int64_t>(i) * step_ns);
    truth.lines.push_back(static_cast<int>(i) + 5);
    truth.T_world_camera.emplace_back(Eigen::Translation3d(0, 0, positions[i]));
  }
  Inspection inspection;
  checkTrueSpeeds("poses.txt", truth, inspection);
  CHECK_FALSE(inspection.hasErrors());
  if (inspection.findings().empty()) return "";
  return inspection.findings()[0].where + ": " + inspection.findings()[0].message;
}

}  // namespace

TEST_CASE("true poses that stand still and jump are told with line and speed") {
  CHECK(speedWarning({0, 1, 1, 1, 25, 26}) ==
        "poses.txt:9: true pose is 24.0 m from the one before (240 m/s, after 3 equal poses), and "
        "1 of 5 steps are faster than 100 m/s; correct poses and times, or remove the file to run "
        "without truth, because errors are measured against these poses");
  CHECK_THAT(speedWarning({0, 50, 100}), Catch::Contains("500 m/s), and 2 of 2 steps"));
}

TEST_CASE("speeds of vehicles and small errors at a high rate are no jumps") {
  CHECK(speedWarning({}).empty());
  CHECK(speedWarning({0, 0, 0, 9.9, 19}).empty());
  CHECK(speedWarning({0, 0.05, 0}, 100'000).empty());  // 500 m/s
}

TEST_CASE("kitti tells of a jump in poses.txt and goes on") {
  const DataFolder data;
  data.write("poses.txt",
             "1 0 0 0 0 1 0 0 0 0 1 0\n# a comment\n1 0 0 0 0 1 0 0 0 0 1 0\n"
             "1 0 0 0 0 1 0 0 0 0 1 24\n1 0 0 0 0 1 0 0 0 0 1 25\n");
  KittiSource source;
  REQUIRE(configure(source, {{"path", data.path().string()}}).empty());
  CHECK_THAT(data.anonymous(inspect(source)[0]),
             Catch::Contains("DATA/poses.txt:4: true pose is 24.0 m from the one before (240 m/s, "
                             "after 2 equal poses)"));
}

}  // namespace tolman::image_folders
