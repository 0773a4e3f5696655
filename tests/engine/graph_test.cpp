// SPDX-License-Identifier: BSD-3-Clause
// When the graph of the map is published; its cost is proportional to its size.
#include <numeric>

#include "engine/toy_stages.hpp"

using namespace tolman;
using tolman::test::Hooks;
using tolman::test::ToySystem;

TEST_CASE("a graph that stays as it is is published once") {
  Hooks hooks;
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 2).failure);
  REQUIRE(system.diary.graphs.size() == 1);
  CHECK(system.diary.graphs[0].first == 0);
  CHECK(system.diary.final_size == 1);
}

TEST_CASE("a small graph is published at every change") {
  Hooks hooks;
  hooks.frames = 300;
  hooks.map_grows = true;
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 2).failure);
  REQUIRE(system.diary.graphs.size() == 300);
  for (std::size_t k = 0; k < 300; ++k) CHECK(system.diary.graphs[k].second == k + 1);
}

TEST_CASE("publishing a graph that grows without end costs a bounded time a frame") {
  Hooks hooks;
  hooks.frames = 8000;
  hooks.map_grows = true;
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 2).failure);
  const auto& graphs = system.diary.graphs;
  const double copied =
      std::accumulate(graphs.begin(), graphs.end(), 0.0,
                      [](double sum, const auto& graph) { return sum + double(graph.second); });
  CHECK(copied / 8000 < 400);  // with every change it would be 4000
  for (std::size_t k = 1; k < graphs.size(); ++k) {
    // The published graph is at most as old as its size allows: 20 frames at a size of 8000.
    CHECK(graphs[k].first - graphs[k - 1].first <=
          1 + static_cast<std::int64_t>(graphs[k - 1].second / 400));
    CHECK(graphs[k].second == static_cast<std::size_t>(graphs[k].first + 1));  // and is of now
  }
  CHECK(system.diary.final_size == 8000);  // the last changes come with the end
}

TEST_CASE("a change that had to wait is published although nothing changes any more") {
  Hooks hooks;
  hooks.frames = 1100;
  hooks.map_grows = true;
  hooks.map = [&](std::int64_t frame) {
    if (frame == 1000) hooks.map_grows = false;  // from 1001 experiences back to one, for good
    return Status::ok();
  };
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 1).failure);
  REQUIRE(system.diary.graphs.back().second == 1);
  CHECK(system.diary.graphs.back().first <= 1004);
}

TEST_CASE("PlaceInput is read once") {
  Hooks hooks;
  ToySystem system(hooks);
  REQUIRE_FALSE(system.drive({}, 2).failure);
  CHECK(hooks.input_asked == 1);
}
