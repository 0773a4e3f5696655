// SPDX-License-Identifier: BSD-3-Clause
#include "record/map_file.hpp"

#include <Eigen/Eigenvalues>
#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/connected_components.hpp>

#include "record/pose_files.hpp"

namespace tolman::record {

GraphParts partsOf(const MapGraph& graph) {
  boost::adjacency_list<boost::vecS, boost::vecS, boost::undirectedS> links(
      graph.experiences.size());
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    add_edge(static_cast<std::size_t>(link.from), static_cast<std::size_t>(link.to), links);
  }
  GraphParts parts{std::vector<std::int64_t>(graph.experiences.size()), 0};
  parts.count = boost::connected_components(links, parts.of_experience.data());
  return parts;
}

Matrix6d g2oInformation(const Link& link) {
  constexpr double kVarianceFloor = 1e-10;
  const Matrix6d symmetric = (link.covariance + link.covariance.transpose()) / 2;
  const Eigen::SelfAdjointEigenSolver<Matrix6d> solver(symmetric);
  const Vector6d inverse = solver.eigenvalues().cwiseMax(kVarianceFloor).cwiseInverse();
  Vector6d jacobian;  // rotation vector = 2 * quaternion vector
  jacobian << 1, 1, 1, 2, 2, 2;
  const Matrix6d information =
      solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
  return link.weight * (jacobian.asDiagonal() * information * jacobian.asDiagonal());
}

std::string g2oText(const MapGraph& graph) {
  std::string text;
  const GraphParts parts = partsOf(graph);
  if (parts.count > 1) {
    text += "# " + std::to_string(parts.count) +
            " parts that no link joins: their relative poses are unknown\n";
  }
  for (const Experience& experience : graph.experiences) {
    text += "VERTEX_SE3:QUAT " + std::to_string(experience.id) + " " +
            poseText(experience.T_world_experience) + "\n";
  }
  if (!graph.experiences.empty()) text += "FIX 0\n";
  for (const Link& link : graph.links) {
    if (graph.isRejected(link)) continue;
    text += "EDGE_SE3:QUAT " + std::to_string(link.from) + " " + std::to_string(link.to) + " " +
            poseText(link.T_from_to);
    const Matrix6d information = g2oInformation(link);
    for (int row = 0; row < 6; ++row) {
      for (int column = row; column < 6; ++column) {
        text += ' ';
        text += numberText(information(row, column));
      }
    }
    text += "\n";
  }
  return text;
}

}  // namespace tolman::record
