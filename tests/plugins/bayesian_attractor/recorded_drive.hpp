// SPDX-License-Identifier: BSD-3-Clause
// Planar motion and loop candidates of a recorded sequence, from its g2o files.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tolman/geometry.hpp"

namespace tolman::bayesian_attractor::test {

struct Edge {
  int from = 0;
  int to = 0;
  PlanarPose step;
};

inline std::vector<Edge> readEdges(const std::filesystem::path& file) {
  std::vector<Edge> edges;
  std::ifstream stream(file);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream fields(line);
    std::string tag;
    Edge edge;
    fields >> tag >> edge.from >> edge.to >> edge.step.x >> edge.step.y >> edge.step.theta;
    if (fields && tag == "EDGE_SE2") edges.push_back(edge);
  }
  return edges;
}

inline std::vector<PlanarPose> posesOf(const std::vector<Edge>& edges) {
  std::vector<PlanarPose> poses = {{}};
  for (const Edge& edge : edges) poses.push_back(compose(poses.back(), edge.step));
  return poses;
}

}  // namespace tolman::bayesian_attractor::test
