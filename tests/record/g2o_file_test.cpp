// SPDX-License-Identifier: BSD-3-Clause
// The experience map as a g2o file, for other optimisers.
#include <map>

#include "record/by_hand.hpp"
#include "record/export.hpp"
#include "record/sample_run.hpp"

using namespace tolman;
using namespace tolman::record;

namespace {

/// A file as g2o itself would read it.
struct ReadBack {
  struct Edge {
    int from;
    int to;
    Eigen::Isometry3d T_from_to;
    Matrix6d information;
  };
  std::map<int, Eigen::Isometry3d> vertices;
  std::vector<int> fixed;
  std::vector<Edge> edges;
};

Eigen::Isometry3d readPose(std::istream& words) {
  Eigen::Vector3d t;
  Eigen::Quaterniond q;
  for (double& value : t) words >> value;
  for (double& value : q.coeffs()) words >> value;
  Eigen::Isometry3d T(q);
  T.translation() = t;
  return T;
}

ReadBack readBack(const std::string& text) {
  ReadBack read;
  for (const std::string& line : test::linesOf(text)) {
    std::istringstream words(line);
    std::string tag;
    int id = 0;
    words >> tag >> id;
    if (tag == "VERTEX_SE3:QUAT") {
      read.vertices[id] = readPose(words);
    } else if (tag == "FIX") {
      read.fixed.push_back(id);
    } else {
      REQUIRE(tag == "EDGE_SE3:QUAT");
      ReadBack::Edge& edge = read.edges.emplace_back();
      edge.from = id;
      words >> edge.to;
      edge.T_from_to = readPose(words);
      for (int row = 0; row < 6; ++row) {
        for (int column = row; column < 6; ++column) {
          words >> edge.information(row, column);
          edge.information(column, row) = edge.information(row, column);
        }
      }
    }
    REQUIRE(words);
    CHECK((words >> std::ws).eof());  // and nothing more on the line
  }
  return read;
}

Matrix6d randomCovariance(RandomStream& random) {
  Matrix6d root;
  for (double& entry : root.reshaped()) entry = random.normal();
  return root * root.transpose() + 0.1 * Matrix6d::Identity();
}

/// Random poses in a ring, every link true to them.
MapGraph ring(std::int64_t size) {
  RandomStream random(64);
  MapGraph graph;
  for (std::int64_t id = 0; id < size; ++id) {
    graph.experiences.push_back({id, id, -1, test::randomPose(random)});
  }
  for (std::int64_t id = 0; id < size; ++id) {
    Link link = test::linkBetween(id, id, (id + 1) % size, id);
    link.T_from_to =
        graph.experiences[static_cast<std::size_t>(link.from)].T_world_experience.inverse() *
        graph.experiences[static_cast<std::size_t>(link.to)].T_world_experience;
    link.covariance = randomCovariance(random);
    link.weight = random.uniform(0.1, 1);
    graph.links.push_back(link);
  }
  return graph;
}

}  // namespace

TEST_CASE("a g2o file: vertices, the fixed one, edges with 21 values") {
  const MapGraph graph{1,
                       {test::experienceAt(0, 0, 0), test::experienceAt(1, 2, 2)},
                       {test::linkBetween(0, 0, 1, 2)},
                       {}};
  CHECK(g2oText(graph) ==
        "VERTEX_SE3:QUAT 0 0 0 0 0 0 0 1\n"
        "VERTEX_SE3:QUAT 1 0 0 2 0 0 0 1\n"
        "FIX 0\n"
        "EDGE_SE3:QUAT 0 1 0 0 2 0 0 0 1"
        " 4 0 0 0 0 0 4 0 0 0 0 4 0 0 0 16 0 0 16 0 16\n");
  CHECK(g2oText({}).empty());
}

TEST_CASE("the g2o information gives every small motion the same cost as our covariance") {
  RandomStream random(62);
  Link link = test::linkBetween(0, 0, 1, 0);
  Matrix6d root;
  for (double& entry : root.reshaped()) entry = random.normal();
  link.covariance = root * root.transpose();
  link.weight = 0.5;
  const Matrix6d information = g2oInformation(link);
  for (int i = 0; i < 20; ++i) {
    Vector6d twist;
    for (double& entry : twist) entry = 1e-5 * random.normal();
    // g2o's error of the motion exp(twist): translation and the quaternion's vector part.
    const Eigen::Isometry3d T = expSe3(twist);
    Vector6d error;
    error << T.translation(), Eigen::Quaterniond(T.linear()).vec();
    const double ours = 0.5 * twist.dot(link.covariance.inverse() * twist);
    CHECK(error.dot(information * error) == Approx(ours).epsilon(1e-3));
  }
  link.covariance.setZero();  // no inverse
  CHECK(g2oInformation(link).allFinite());
}

TEST_CASE("a g2o file reads back to the same graph, consistent links without error") {
  const MapGraph graph = ring(12);
  const ReadBack read = readBack(g2oText(graph));
  REQUIRE(read.vertices.size() == 12);
  CHECK(read.fixed == std::vector<int>{0});
  REQUIRE(read.edges.size() == 12);
  for (std::size_t i = 0; i < 12; ++i) {
    const Experience& experience = graph.experiences[i];
    CHECK(read.vertices.at(static_cast<int>(i)).isApprox(experience.T_world_experience, 1e-14));
    const ReadBack::Edge& edge = read.edges[i];
    CHECK(edge.from == graph.links[i].from);
    CHECK(edge.to == graph.links[i].to);
    const Eigen::Isometry3d T_error = edge.T_from_to.inverse() *
                                      read.vertices.at(edge.from).inverse() *
                                      read.vertices.at(edge.to);
    CHECK(T_error.isApprox(Eigen::Isometry3d::Identity(), 1e-13));
  }
}

TEST_CASE("the 21 values are the inverse covariance of g2o's own error") {
  const MapGraph graph = ring(5);
  const ReadBack read = readBack(g2oText(graph));
  for (std::size_t i = 0; i < graph.links.size(); ++i) {
    Matrix6d covariance = graph.links[i].covariance;  // quaternion vector = rotation vector / 2
    covariance.bottomRows<3>() /= 2;
    covariance.rightCols<3>() /= 2;
    const Matrix6d product = read.edges[i].information * covariance / graph.links[i].weight;
    CHECK((product - Matrix6d::Identity()).norm() < 1e-9);
  }
}

TEST_CASE("a rejected link is left out") {
  MapGraph graph = ring(5);
  graph.rejected = {4};
  CHECK(readBack(g2oText(graph)).edges.size() == 4);
}

TEST_CASE("a link of weight 0 has no information, a perfect one not infinitely much") {
  Link link = test::linkBetween(0, 0, 1, 0);
  link.weight = 0;
  CHECK(g2oInformation(link).isZero());
  link.weight = 1;
  link.covariance.setZero();
  CHECK(g2oInformation(link).diagonal().head<3>().isApproxToConstant(1e10, 1e-9));
  CHECK(g2oInformation(link).diagonal().tail<3>().isApproxToConstant(4e10, 1e-9));
}
