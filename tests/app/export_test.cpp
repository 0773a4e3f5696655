// SPDX-License-Identifier: BSD-3-Clause
// `tolman dataset export`: a clip as a bag, which other programs read, and which gives the same
// run.
#include <catch2/catch.hpp>
#include <fstream>

#include "end_to_end/process.hpp"
#include "support/data.hpp"
#include "support/ros1_tool.hpp"

using namespace tolman::test;
namespace fs = std::filesystem;

namespace {

/// Runs a stereo chain of the source, and gives its folder.
fs::path runOf(const fs::path& folder, const std::string& source, const std::string& name) {
  const fs::path file = folder / (name + ".yaml");
  std::ofstream(file) << "source: " << source
                      << "\nodometry: {plugin: direct_sparse_stereo}\n"
                         "place: {plugin: view_templates}\ncells: {plugin: bayesian_attractor}\n"
                         "map: {plugin: experience_map}\n";
  const Finished finished =
      tolman::test::tolman({"run", file.string(), "--out", (folder / name).string()});
  INFO(finished.err);
  REQUIRE(finished.exit_code == 0);
  return folder / name;
}

}  // namespace

TEST_CASE("a clip that is exported as a bag of ROS 2 or ROS 1 gives the same run", "[data]") {
  const auto kitti = dataOrSkip("kitti_clips/06");
  if (!kitti) return;
  const TemporaryFolder temporary;
  const fs::path& folder = temporary.path();
  const fs::path original =
      runOf(folder, "{plugin: kitti, path: " + kitti->string() + ", last: 25}", "original");
  for (const std::string ending : {"mcap", "bag"}) {
    const fs::path bag = folder / ("clip." + ending);
    const Finished exported = tolman::test::tolman(
        {"dataset", "export", kitti->string(), "--bag", bag.string(), "--frames", "26"});
    INFO(exported.err);
    REQUIRE(exported.exit_code == 0);
    CHECK(contains(exported.out, "26"));
    const fs::path again = runOf(
        folder, "{plugin: ros_bag, path: " + bag.string() + ", truth: /truth}", "from_" + ending);
    for (const char* file : {"odometry.tum", "trajectory.tum", "map.g2o"}) {
      INFO(file);
      CHECK(readText(again / file) == readText(original / file));
    }
    const Finished refused = tolman::test::tolman(
        {"dataset", "export", kitti->string(), "--bag", bag.string(), "--frames", "1"});
    CHECK(contains(refused.err, "exists; remove it, or choose another --bag"));
  }
  if (!ros1OrSkip()) return;
  // ROS 1's own module reads each message by its definition in the bag.
  const Finished read = run({"/usr/bin/python3", "-c", R"(
import sys, rosbag
bag = rosbag.Bag(sys.argv[1])
counts = {}
for topic, message, stamp in bag.read_messages():
    assert message.header.stamp == stamp
    counts[topic] = counts.get(topic, 0) + 1
    if topic == '/right/camera_info': P = message.P
print(sorted(counts.items()), P[0], round(P[3], 9))
)",
                             (folder / "clip.bag").string()});
  INFO(read.err);
  CHECK(read.out ==
        "[('/left/camera_info', 26), ('/left/image_rect/compressed', 26), "
        "('/right/camera_info', 26), ('/right/image_rect/compressed', 26), ('/truth', 26)] "
        "707.0912 -379.8145\n");
}
