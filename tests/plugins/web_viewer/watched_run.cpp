// SPDX-License-Identifier: BSD-3-Clause
#include "watched_run.hpp"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>
#include <numbers>

namespace tolman::test {
namespace {

constexpr int kWidth = 96;
constexpr int kHeight = 48;

Image gradient(std::int64_t index) {
  return Image::create(kWidth, kHeight, PixelFormat::Gray8, [&](std::uint8_t* pixels) {
    for (int i = 0; i < kWidth * kHeight; ++i) {
      pixels[i] = static_cast<std::uint8_t>(i % kWidth + index);
    }
  });
}

}  // namespace

MapGraph graphAt(std::int64_t index) {
  MapGraph graph;
  graph.version = index / 10;
  for (std::int64_t id = 0; id <= index / 10; ++id) {
    Experience experience{id, id * 10, id, Eigen::Isometry3d::Identity()};
    experience.T_world_experience.translation().z() = static_cast<double>(id) * 10;
    graph.experiences.push_back(experience);
    if (id == 0) continue;
    Link link;
    link.id = id - 1;
    link.from = id - 1;
    link.to = id;
    graph.links.push_back(link);
  }
  if (graph.experiences.size() > 2) {
    Link loop;
    loop.id = static_cast<std::int64_t>(graph.links.size());
    loop.from = 2;
    loop.to = 0;
    loop.kind = LinkKind::Loop;
    graph.links.push_back(loop);
    graph.rejected.push_back(loop.id);
  }
  return graph;
}

TestFrame::TestFrame(std::int64_t index, bool with_image) {
  frame.frame = index;
  frame.stamp_ns = 1'000'000'000 + index * 100'000'000;
  if (with_image) frame.left = gradient(index);
  frame.has_truth = true;
  frame.T_world_camera_truth.translation() << 100, 0, 50 + static_cast<double>(index);
  motion.frame = index;
  motion.state = index == 0 ? TrackingState::Initialising : TrackingState::Tracking;
  motion.tracked = 300 + index;
  motion.points_frame = index;
  motion.points.resize(4, 2);
  motion.points << 10, 20, 5, 6, 0.5F, 0.25F, 0.01F, 0.02F;
  if (index > 0) motion.T_previous_current.translation().z() = 1;
  setPlanarVelocity(motion, index > 0 ? 0.1 : 0);
  const bool novel = index % 10 == 0;
  place.frame = index;
  place.recognition = novel ? Recognition::Novel : Recognition::Familiar;
  place.template_id = index / 10;
  place.score = 0.125;
  decision.frame = index;
  decision.action = novel ? Action::CreateExperience : Action::Stay;
  decision.experience = index / 10;
  decision.heading = 0.25;
  map.frame = index;
  map.experience = index / 10;
  map.T_world_camera.translation().z() = static_cast<double>(index) + 0.5;
  map.experiences = index / 10 + 1;
  map.links = index / 10;
  cells = {{"hd.activity", {3}, {0.25F, 0.5F, static_cast<float>(index)}},
           {"grid.activity", {2, 2}, {1, 2, 3, 4}}};
  if (novel) events.push_back({index, LogLevel::Info, "place", "new view"});
  graph_changed = novel;
  if (novel) graph = graphAt(index);
}

Snapshot TestFrame::snapshot() const {
  Snapshot snapshot;
  snapshot.frame = &frame;
  snapshot.motion = &motion;
  snapshot.place = &place;
  snapshot.decision = &decision;
  snapshot.map = &map;
  snapshot.cells = &cells;
  snapshot.graph = graph_changed ? &graph : nullptr;
  snapshot.stage_times_ns = {1'000'000, 2'000'000, 0, 4'000'000, 5'000'000, 0};
  snapshot.events = &events;
  return snapshot;
}

ParameterValues withAnyPort(ParameterValues values) {
  values.try_emplace("port", std::int64_t{0});
  return values;
}

WatchedRun::WatchedRun(ParameterValues values) : context(withAnyPort(std::move(values))) {
  const Status status = viewer->configure(context);
  INFO(status.message());
  REQUIRE(status.isOk());
  RunInfo run;
  run.name = "made up";
  run.directory = "/runs/made-up";
  run.source.description = "a straight road";
  run.source.frames = 100;
  run.source.has_truth = true;
  ArrayInfo ring;
  ring.name = "hd.activity";
  ring.kind = ArrayKind::Activity;
  ring.axes = {{"heading", "rad", 0, 2 * std::numbers::pi / 3, 2 * std::numbers::pi, {}}};
  run.arrays = {ring};
  run.source.rig = {kWidth, kHeight, true, {80, 81, 48, 24}, 0.5};
  REQUIRE(viewer->begin(run).isOk());
}

void WatchedRun::frames(std::int64_t count, bool with_image) {
  for (const std::int64_t end = next_ + count; next_ < end; ++next_) {
    const TestFrame test_frame(next_, with_image);
    REQUIRE(viewer->observe(test_frame.snapshot()).isOk());
  }
}

void WatchedRun::finish() { REQUIRE(end().isOk()); }

Status WatchedRun::end() { return viewer->finish(graphAt(next_ - 1)); }

int WatchedRun::port() const {
  return nlohmann::json::parse(context.artefacts.at("viewer.json")).at("port");
}

}  // namespace tolman::test
