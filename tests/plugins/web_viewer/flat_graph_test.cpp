// SPDX-License-Identifier: BSD-3-Clause
// Flat graphs: decoded byte by byte they equal the graph.
#include <catch2/catch.hpp>
#include <numbers>

#include "browser.hpp"
#include "frame_encoder.hpp"
#include "tolman/context.hpp"

namespace tolman::web_viewer {
namespace {

MapGraph randomGraph(RandomStream& random) {
  MapGraph graph;
  graph.version = static_cast<std::int64_t>(random.below(1000));
  const auto count = static_cast<std::int64_t>(random.below(40));
  for (std::int64_t i = 0; i < count; ++i) {
    Experience experience;
    experience.id = i;
    experience.frame = 3 * i;
    experience.T_world_experience =
        fromPlanar({random.uniform(-500, 500), random.uniform(-500, 500),
                    random.uniform(-std::numbers::pi, std::numbers::pi)});
    experience.T_world_experience.translation().z() += random.uniform(-5, 5);
    graph.experiences.push_back(experience);
  }
  for (std::int64_t i = 0; i < 2 * count; ++i) {
    Link link;
    link.id = i;
    link.from = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(count)));
    link.to = static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(count)));
    link.kind = i % 3 == 0 ? LinkKind::Loop : LinkKind::Odometry;
    link.frame = 5 * i;
    graph.links.push_back(link);
    if (i % 3 == 0 && random.below(2) == 0) graph.rejected.push_back(i);
    graph.residuals.push_back(i % 3 == 0 ? 0.25 * static_cast<double>(i) : -1);
  }
  return graph;
}

}  // namespace

TEST_CASE("positions, headings, links and verdicts of any graph arrive") {
  RandomStream random(5);
  FlatGraph flat;  // one for all: nothing of the graph before may stay
  for (int round = 0; round < 60; ++round) {
    const MapGraph graph = randomGraph(random);
    flat.assign(graph, round);
    const test::Container got = test::parseContainer(flat.encode());
    REQUIRE(got.header["type"] == "graph");
    REQUIRE(got.header["version"] == graph.version);
    REQUIRE(got.header["frame"] == round);
    const std::size_t nodes = graph.experiences.size();
    const std::size_t links = graph.links.size();
    REQUIRE(got.arrays.at("experience").shape == std::vector<std::size_t>{nodes, 4});
    REQUIRE(got.arrays.at("link").shape == std::vector<std::size_t>{links, 2});
    const auto loop = got.arrays.at("loop").as<std::int32_t>();
    const auto residual = got.arrays.at("loop_residual").as<float>();
    for (std::size_t i = 0; 3 * i < links; ++i) {
      const Link& link = graph.links[3 * i];
      const std::vector<std::int64_t> expected = {link.id, link.frame, 3 * link.from, 3 * link.to};
      REQUIRE(std::equal(expected.begin(), expected.end(), loop.begin() + 4 * i));
      REQUIRE(residual[i] == 0.75F * static_cast<float>(i));
    }
    const auto experience = got.arrays.at("experience").as<float>();
    for (std::size_t i = 0; i < nodes; ++i) {
      const Eigen::Isometry3d& T = graph.experiences[i].T_world_experience;
      for (std::size_t k = 0; k < 3; ++k) {
        REQUIRE(experience[4 * i + k] ==
                static_cast<float>(T.translation()[static_cast<Eigen::Index>(k)]));
      }
      // The heading is the direction in which the camera looks, in the plane of the map.
      const PlanarPose ahead = toPlanar(T * fromPlanar({1, 0, 0}));
      const PlanarPose here = toPlanar(T);
      const auto yaw = static_cast<double>(experience[4 * i + 3]);
      REQUIRE(std::cos(yaw) == Approx(ahead.x - here.x).margin(1e-4));
      REQUIRE(std::sin(yaw) == Approx(ahead.y - here.y).margin(1e-4));
    }
    const auto ends = got.arrays.at("link").as<std::int32_t>();
    const auto kinds = got.arrays.at("link_kind").as<std::uint8_t>();
    const auto rejected = got.arrays.at("link_rejected").as<std::uint8_t>();
    REQUIRE(kinds.size() == links);
    REQUIRE(rejected.size() == links);
    std::size_t found_rejected = 0;
    for (std::size_t i = 0; i < links; ++i) {
      REQUIRE(ends[2 * i] == graph.links[i].from);
      REQUIRE(ends[2 * i + 1] == graph.links[i].to);
      REQUIRE(static_cast<LinkKind>(kinds[i]) == graph.links[i].kind);
      found_rejected += rejected[i];
    }
    REQUIRE(found_rejected == graph.rejected.size());
    for (const std::int64_t id : graph.rejected) {
      REQUIRE(rejected[static_cast<std::size_t>(id)] == 1);
    }
  }
}

}  // namespace tolman::web_viewer
