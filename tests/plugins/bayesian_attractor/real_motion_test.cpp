// SPDX-License-Identifier: BSD-3-Clause
// The network as a filter of real loop candidates on real KITTI motion.
#include <catch2/catch.hpp>
#include <fstream>
#include <map>
#include <sstream>

#include "spatial_cells.hpp"
#include "support/data.hpp"

using namespace tolman;
using namespace tolman::bayesian_attractor;

namespace {

struct Edge {
  int from = 0;
  int to = 0;
  PlanarPose step;
};

std::vector<Edge> readEdges(const std::filesystem::path& file) {
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

std::vector<PlanarPose> posesOf(const std::vector<Edge>& edges) {
  std::vector<PlanarPose> poses = {{}};
  for (const Edge& edge : edges) poses.push_back(compose(poses.back(), edge.step));
  return poses;
}

struct Counts {
  int right = 0;
  int wrong = 0;
};

/// Every fifth frame is a view; candidate (i, j) says that frame i looks like frame j.
Counts decisions(const std::filesystem::path& folder, const DecisionSettings& settings,
                 double inhibition_of_integrator) {
  const auto motion = readEdges(folder / "odometry.g2o");
  const auto truth = posesOf(readEdges(folder / "ground_truth.g2o"));
  std::map<int, int> candidates;
  for (const Edge& edge : readEdges(folder / "loop_candidates.g2o"))
    candidates[edge.from] = edge.to;
  const double inhibition = inhibition_of_integrator;
  SpatialCells cells(HeadDirectionRing({.energy = 100, .inhibition_of_integrator = inhibition}),
                     GridTorus({.period = 15, .inhibition_of_integrator = inhibition}, 10),
                     settings);
  std::vector<CellPose> learned = {cells.estimate()};
  Counts counts;
  for (int frame = 1; frame <= static_cast<int>(motion.size()); ++frame) {
    cells.integrate(motion[static_cast<std::size_t>(frame - 1)].step);
    const auto candidate = candidates.find(frame);
    const bool injects = candidate != candidates.end();
    if (injects) cells.inject(learned[static_cast<std::size_t>(candidate->second)], 0.4);
    if (!injects && frame % 5 == 0) cells.noteUnsupportedView();
    if (injects || frame % 5 == 0) cells.settle();
    learned.push_back(cells.estimate());
    if (!injects || !cells.familiar()) continue;
    const PlanarPose apart = between(truth[static_cast<std::size_t>(frame)],
                                     truth[static_cast<std::size_t>(candidate->second)]);
    (std::hypot(apart.x, apart.y) <= 10 ? counts.right : counts.wrong) += 1;
    cells.adoptEstimate();
  }
  return counts;
}

}  // namespace

TEST_CASE("KITTI candidates, 70-99 % false: the gated network is a real filter") {
  const std::string sequence = GENERATE("00", "05", "06", "07");
  const auto folder = tolman::test::dataOrSkip("kitti_motion/" + sequence);
  if (!folder) return;
  const Counts printed = decisions(*folder, {.consistency_gate = false}, 0.2);
  const Counts gated = decisions(*folder, {}, 0.2);
  const Counts strict = decisions(*folder, {.decision_share = 0.7}, 0);
  WARN("KITTI " << sequence << " true/false decisions: as printed " << printed.right << "/"
                << printed.wrong << ", gated " << gated.right << "/" << gated.wrong
                << ", gated, share 0.7, asymmetric " << strict.right << "/" << strict.wrong);
  CHECK(gated.wrong <= 2);
  CHECK(strict.wrong <= 1);
  CHECK(printed.wrong > 4 * gated.wrong);
  if (sequence == "00") CHECK(gated.right >= 8);
}
