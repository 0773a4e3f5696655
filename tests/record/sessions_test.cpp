// SPDX-License-Identifier: BSD-3-Clause
// Runs that continue earlier ones, and maps in parts.
#include "record/export.hpp"
#include "record/sample_run.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

Eigen::Isometry3d at(double z) {
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.translation().z() = z;
  return T;
}

/// Frames first ... end - 1 of one session.
void recordSession(Recorder& recorder, std::int64_t id, std::int64_t first, std::int64_t end) {
  REQUIRE(recorder.session({id, first, "run" + std::to_string(id), "made up"}).isOk());
  for (std::int64_t i = first; i < end; ++i) REQUIRE(test::recordFrame(recorder, i).isOk());
}

MapGraph chainOf(std::int64_t experiences) {
  MapGraph graph;
  for (std::int64_t i = 0; i < experiences; ++i) graph.experiences.push_back({i, i, -1, at(0)});
  return graph;
}

void join(MapGraph& graph, std::int64_t from, std::int64_t to) {
  Link link;
  link.id = static_cast<std::int64_t>(graph.links.size());
  link.from = from;
  link.to = to;
  graph.links.push_back(link);
}

}  // namespace

TEST_CASE("a run copies the frames of an earlier one, and its record is complete without it") {
  const test::TemporaryFolder old_folder;
  const test::TemporaryFolder folder;
  {
    auto recorder = Recorder::open(old_folder.path()).value();
    recordSession(*recorder, 0, 0, 4);
    REQUIRE(recorder->revisions({{3, at(5), Matrix6d::Zero()}}).isOk());
    REQUIRE(recorder->close().isOk());
  }
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(recorder->inherit(*RunReader::open(old_folder.path()).value(), INT64_MAX).isOk());
  recordSession(*recorder, 1, 4, 7);
  REQUIRE(recorder->finalPoses({{1, at(9)}, {5, at(-2)}}).isOk());
  REQUIRE(recorder->close().isOk());

  const auto reader = RunReader::open(folder.path()).value();
  CHECK(reader->nextFrame().value() == 7);
  REQUIRE(reader->sessions().value().size() == 2);
  CHECK(reader->sessions().value()[1].first_frame == 4);
  const auto& odometry = reader->odometry().value();
  REQUIRE(odometry.size() == 7);
  CHECK(odometry[3].T_world_camera.translation().z() == 7);  // 1 m + 1 m + 5 m, revised
  CHECK(odometry[4].T_world_camera.translation().z() == 0);  // each session from its own start
  CHECK(odometry[6].T_world_camera.translation().z() == 2);
  // Final poses take precedence over poses computed from experiences.
  CHECK(reader->map().value()[1].T_world_camera.translation().z() == 9);
  CHECK(reader->map().value()[5].T_world_camera.translation().z() == -2);

  const test::TemporaryFolder out;
  REQUIRE(exportRun(*reader, out.path()).isOk());
  REQUIRE(exportRun(*reader, out.path(), 0).isOk());
  CHECK(exportRun(*reader, out.path(), 2)
            .status()
            .message()
            .find("has no session 2; the last is 1") != std::string::npos);
}

TEST_CASE("a run that was killed is inherited up to its last checkpoint") {
  const test::TemporaryFolder old_folder;
  const test::TemporaryFolder folder;
  auto killed = Recorder::open(old_folder.path()).value();
  recordSession(*killed, 0, 0, 6);
  REQUIRE(killed->commit().isOk());
  auto recorder = Recorder::open(folder.path()).value();
  REQUIRE(recorder->inherit(*RunReader::open(old_folder.path()).value(), 4).isOk());
  recordSession(*recorder, 1, 4, 5);
  REQUIRE(recorder->close().isOk());
  const auto reader = RunReader::open(folder.path()).value();
  CHECK(reader->nextFrame().value() == 5);
  CHECK(reader->odometry().value().size() == 5);
}

TEST_CASE("parts of a map are joined by all links that it has not rejected") {
  MapGraph graph = chainOf(6);
  join(graph, 0, 1);
  join(graph, 3, 2);
  join(graph, 4, 5);
  join(graph, 5, 1);
  graph.links.back().kind = LinkKind::Loop;
  graph.rejected = {3};
  GraphParts parts = partsOf(graph);
  CHECK(parts.count == 3);
  CHECK(parts.of_experience == std::vector<std::int64_t>{0, 0, 1, 1, 2, 2});
  join(graph, 5, 0);
  parts = partsOf(graph);
  CHECK(parts.count == 2);
  CHECK(parts.of_experience == std::vector<std::int64_t>{0, 0, 1, 1, 0, 0});
  join(graph, 3, 4);
  graph.links.back().weight = 0.01;  // a small weight alone rejects nothing
  CHECK(partsOf(graph).count == 1);
  CHECK(partsOf(MapGraph{}).count == 0);
}
