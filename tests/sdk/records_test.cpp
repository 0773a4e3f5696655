// SPDX-License-Identifier: BSD-3-Clause
// Values that records compute from their fields.
#include "tolman/records.hpp"

#include <catch2/catch.hpp>

using namespace tolman;

TEST_CASE("a graph knows which loop links its map has rejected") {
  MapGraph graph;
  graph.links.resize(4);
  for (std::int64_t id = 0; id < 4; ++id) graph.links[static_cast<std::size_t>(id)].id = id;
  CHECK_FALSE(graph.isRejected(graph.links[1]));
  graph.rejected = {1, 3};
  CHECK_FALSE(graph.isRejected(graph.links[0]));
  CHECK(graph.isRejected(graph.links[1]));
  CHECK_FALSE(graph.isRejected(graph.links[2]));
  CHECK(graph.isRejected(graph.links[3]));
}
