// SPDX-License-Identifier: BSD-3-Clause
// Result files from the database, compared with an independent computation from the same rows.
#include "record/export.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

#include "record/by_hand.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

void recordRun(const std::filesystem::path& folder, std::int64_t frames) {
  auto recorder = Recorder::open(folder).value();
  for (std::int64_t i = 0; i < frames; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->close().isOk());
}

Eigen::Matrix4d matrixOf(const std::vector<double>& v, std::size_t first) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  matrix.topLeftCorner<3, 3>() =
      Eigen::Quaterniond(v[first + 6], v[first + 3], v[first + 4], v[first + 5]).matrix();
  matrix.topRightCorner<3, 1>() << v[first], v[first + 1], v[first + 2];
  return matrix;
}

/// The poses of a TUM file as matrices.
std::vector<Eigen::Matrix4d> readTum(const std::filesystem::path& file) {
  std::vector<Eigen::Matrix4d> poses;
  for (const std::string& line : test::linesOf(test::contentOf(file))) {
    poses.push_back(matrixOf(test::numbersOf(line), 1));
  }
  return poses;
}

/// A walk of random steps, five frames an experience, which the map has put elsewhere. Frame 12
/// belongs to no experience.
struct RandomWalk {
  static constexpr std::int64_t kFrames = 20;
  test::TemporaryFolder folder;
  RandomStream random{66};
  std::vector<Eigen::Matrix4d> steps;
  std::vector<Eigen::Matrix4d> map;

  RandomWalk() {
    auto recorder = Recorder::open(folder.path()).value();
    MapGraph graph;
    for (std::int64_t id = 0; id < kFrames / 5; ++id) {
      graph.experiences.push_back({id, 5 * id, -1, test::randomPose(random)});
    }
    for (std::int64_t i = 0; i < kFrames; ++i) recordFrame(*recorder, graph, i);
    REQUIRE(recorder->graph(graph).isOk());
    // Frame 3 is revised twice: the second time after the last frame.
    steps[3] = test::randomPose(random).matrix();
    REQUIRE(recorder->revisions({{3, Eigen::Isometry3d(steps[3]), Matrix6d::Zero()}}).isOk());
    REQUIRE(recorder->close().isOk());
  }

  void recordFrame(Recorder& recorder, const MapGraph& graph, std::int64_t i) {
    const Frame frame = test::frameAt(i);
    Motion motion = test::motionAt(i);
    motion.T_previous_current = test::randomPose(random);
    steps.push_back(motion.T_previous_current.matrix());
    if (i == 7) motion.revisions = {{3, test::randomPose(random), Matrix6d::Zero()}};
    MapUpdate update;
    update.frame = i;
    update.stamp_ns = frame.stamp_ns;
    update.experience = i == 12 ? -1 : i / 5;
    update.T_experience_camera = test::randomPose(random);
    update.T_world_camera = test::randomPose(random);
    const Experience& experience = graph.experiences[static_cast<std::size_t>(i / 5)];
    map.push_back(i == 12 ? update.T_world_camera.matrix()
                          : experience.T_world_experience.matrix() *
                                update.T_experience_camera.matrix());
    Snapshot snapshot;
    snapshot.frame = &frame;
    snapshot.motion = &motion;
    snapshot.map = &update;
    REQUIRE(recorder.snapshot(snapshot).isOk());
  }
};

}  // namespace

TEST_CASE("a run exports from its database alone") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 3);
  const auto out = folder.path() / "out";
  std::filesystem::create_directory(out);
  REQUIRE(exportRun(folder.path(), out).value().size() == 5);
  CHECK(test::contentOf(out / "odometry.tum") ==
        "1.000000000 0 0 0 0 0 0 1\n1.100000000 0 0 1 0 0 0 1\n1.200000000 0 0 2 0 0 0 1\n");
  CHECK(test::contentOf(out / "trajectory.tum") == test::contentOf(out / "odometry.tum"));
  CHECK(test::contentOf(out / "trajectory.kitti").substr(0, 24) == "1 0 0 0 0 1 0 0 0 0 1 0\n");
  CHECK(test::contentOf(out / "map.g2o") == "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\nFIX 0\n");
  CHECK_FALSE(exportRun(out, out).isOk());
}

TEST_CASE("an export of an empty run is refused") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 0);
  CHECK(exportRun(folder.path(), folder.path()).status().message() ==
        folder.path().string() + ": holds nothing to export yet");
}

TEST_CASE("odometry files are the product of all motions, each with its last revision") {
  const RandomWalk walk;
  REQUIRE(exportRun(walk.folder.path(), walk.folder.path()).isOk());
  const auto poses = readTum(walk.folder.path() / "odometry.tum");
  const auto kitti = test::linesOf(test::contentOf(walk.folder.path() / "odometry.kitti"));
  REQUIRE(poses.size() == RandomWalk::kFrames);
  REQUIRE(kitti.size() == RandomWalk::kFrames);
  Eigen::Matrix4d product = Eigen::Matrix4d::Identity();  // the motion of frame 0 does not count
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i > 0) product *= walk.steps[i];
    CHECK((poses[i] - product).norm() < 1e-12);
    const std::vector<double> row = test::numbersOf(kitti[i]);
    for (int cell = 0; cell < 12; ++cell) {
      CHECK(row[static_cast<std::size_t>(cell)] ==
            Approx(product(cell / 4, cell % 4)).margin(1e-12));
    }
  }
}

TEST_CASE("poses follow their experiences; a frame without experience keeps its own pose") {
  const RandomWalk walk;
  REQUIRE(exportRun(walk.folder.path(), walk.folder.path()).isOk());
  const auto poses = readTum(walk.folder.path() / "trajectory.tum");
  REQUIRE(poses.size() == walk.map.size());
  for (std::size_t i = 0; i < poses.size(); ++i) CHECK((poses[i] - walk.map[i]).norm() < 1e-12);
}

TEST_CASE("vertices are the rows that SQL shows") {
  const RandomWalk walk;
  REQUIRE(exportRun(walk.folder.path(), walk.folder.path()).isOk());
  const auto rows = test::queryByHand(
      walk.folder.path(),
      "SELECT replace(printf('%.17g %.17g %.17g %.17g %.17g %.17g %.17g', T_world_experience_x,"
      " T_world_experience_y, T_world_experience_z, T_world_experience_qx, T_world_experience_qy,"
      " T_world_experience_qz, T_world_experience_qw), ',', '.') FROM experience ORDER BY id");
  auto lines = test::linesOf(test::contentOf(walk.folder.path() / "map.g2o"));
  REQUIRE(rows.size() == 4);
  REQUIRE(lines.size() == 6);  // and FIX 0
  CHECK(lines.front().starts_with("# 4 parts that no link joins"));
  lines.erase(lines.begin());
  for (std::size_t id = 0; id < 4; ++id) {
    const std::string head = "VERTEX_SE3:QUAT " + std::to_string(id) + " ";
    REQUIRE(lines[id].starts_with(head));
    const auto written = matrixOf(test::numbersOf(lines[id].substr(head.size())), 0);
    CHECK((written - matrixOf(test::numbersOf(rows[id]), 0)).norm() < 1e-14);
  }
}

TEST_CASE("a run without a map exports its odometry, and leaves other files alone") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  const Frame frame = test::frameAt(0);
  const Motion motion = test::motionAt(0);
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.motion = &motion;
  REQUIRE(recorder->snapshot(snapshot).isOk());
  REQUIRE(recorder->close().isOk());
  std::ofstream(folder.path() / "map.g2o") << "somebody's";
  const auto written = exportRun(folder.path(), folder.path());
  CHECK(written.value() ==
        std::vector{folder.path() / "odometry.tum", folder.path() / "odometry.kitti"});
  CHECK(test::contentOf(folder.path() / "map.g2o") == "somebody's");
}

TEST_CASE("a running run exports what is committed; one reader sees one state") {
  const test::TemporaryFolder folder;
  auto recorder = Recorder::open(folder.path()).value();
  for (std::int64_t i = 0; i < 4; ++i) REQUIRE(test::recordFrame(*recorder, i).isOk());
  REQUIRE(recorder->commit().isOk());
  const auto reader = RunReader::open(folder.path()).value();
  REQUIRE(exportRun(*reader, folder.path()).isOk());
  CHECK(readTum(folder.path() / "trajectory.tum").size() == 4);
  REQUIRE(test::recordFrame(*recorder, 4).isOk());
  REQUIRE(recorder->commit().isOk());
  REQUIRE(exportRun(*reader, folder.path()).isOk());
  CHECK(readTum(folder.path() / "trajectory.tum").size() == 4);
  REQUIRE(exportRun(folder.path(), folder.path()).isOk());
  CHECK(readTum(folder.path() / "trajectory.tum").size() == 5);
}

TEST_CASE("a killed run exports what SQL finds in it") {
  const test::TemporaryFolder folder;
  const pid_t child = fork();
  if (child == 0) {
    auto recorder = Recorder::open(folder.path());
    if (!recorder.isOk()) _exit(2);
    for (std::int64_t i = 0; i < 30; ++i) {
      if (!test::recordFrame(*recorder.value(), i).isOk()) _exit(3);
      if (i == 20 && !recorder.value()->commit().isOk()) _exit(4);
    }
    kill(getpid(), SIGKILL);
  }
  int result = 0;
  REQUIRE(waitpid(child, &result, 0) == child);
  REQUIRE(WIFSIGNALED(result));
  REQUIRE(exportRun(folder.path(), folder.path()).value().size() == 5);
  const auto count = test::queryByHand(folder.path(), "SELECT count(*) FROM frame");
  const auto poses = readTum(folder.path() / "odometry.tum");
  CHECK(std::to_string(poses.size()) == count.at(0));
  REQUIRE(poses.size() >= 21);
  for (std::size_t i = 0; i < poses.size(); ++i) CHECK(poses[i](2, 3) == double(i));
}

TEST_CASE("an export that cannot be written, or of a damaged map, is refused with the reason") {
  const test::TemporaryFolder folder;
  recordRun(folder.path(), 2);
  const auto absent = folder.path() / "absent";
  CHECK(exportRun(folder.path(), absent).status().message() ==
        (absent / "odometry.tum").string() +
            ": cannot be created; check folder and permissions (No such file or directory)");
  test::queryByHand(folder.path(), "UPDATE experience SET id = 5");
  CHECK(exportRun(folder.path(), folder.path()).status().message() ==
        (folder.path() / "run.sqlite").string() + ": experience 0 is missing");
  // What does not hang on the map is saved.
  CHECK(std::filesystem::exists(folder.path() / "odometry.kitti"));
}
