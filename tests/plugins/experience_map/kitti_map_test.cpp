// SPDX-License-Identifier: BSD-3-Clause
// Whole KITTI sequences as planar motion: real drift, true revisits, and the map on top.
#include <array>
#include <complex>
#include <fstream>
#include <iostream>
#include <map>
#include <utility>

#include "map_fixture.hpp"
#include "support/data.hpp"

namespace tolman::experience_map {
namespace {

struct Edge {
  int from = 0;
  int to = 0;
  PlanarPose pose;
};

struct Sequence {
  std::vector<Edge> odometry;
  std::vector<PlanarPose> truth;
  std::map<int, Edge> loops;  ///< by the later frame
};

std::vector<Edge> readEdges(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::vector<Edge> edges;
  std::string tag;
  std::array<double, 6> information{};
  for (Edge e; stream >> tag >> e.from >> e.to >> e.pose.x >> e.pose.y >> e.pose.theta;) {
    for (double& value : information) stream >> value;
    edges.push_back(e);
  }
  return edges;
}

Sequence readSequence(const std::filesystem::path& folder) {
  Sequence sequence;
  sequence.odometry = readEdges(folder / "odometry.g2o");
  sequence.truth.emplace_back();
  for (const Edge& e : readEdges(folder / "ground_truth.g2o")) {
    sequence.truth.push_back(tolman::compose(sequence.truth.back(), e.pose));
  }
  std::map<std::pair<int, int>, Edge> candidates;
  for (const Edge& e : readEdges(folder / "loop_candidates.g2o")) candidates[{e.from, e.to}] = e;
  std::ifstream loops(folder / "true_loops.txt");
  for (int later = 0, earlier = 0; loops >> later >> earlier;) {
    sequence.loops[later] = candidates.at({later, earlier});
  }
  return sequence;
}

/// RMSE in m after the best planar rotation and shift, in closed form.
double alignedRmse(const std::vector<std::complex<double>>& estimate,
                   const std::vector<std::complex<double>>& truth) {
  std::complex<double> mean_estimate;
  std::complex<double> mean_truth;
  const auto count = static_cast<double>(estimate.size());
  for (std::size_t k = 0; k < estimate.size(); ++k) {
    mean_estimate += estimate[k] / count;
    mean_truth += truth[k] / count;
  }
  std::complex<double> turn;
  for (std::size_t k = 0; k < estimate.size(); ++k) {
    turn += (truth[k] - mean_truth) * std::conj(estimate[k] - mean_estimate);
  }
  turn /= std::abs(turn);
  double sum = 0;
  for (std::size_t k = 0; k < estimate.size(); ++k) {
    sum += std::norm(turn * (estimate[k] - mean_estimate) - (truth[k] - mean_truth));
  }
  return std::sqrt(sum / count);
}

/// Plays cells that never err: an experience every `spacing` m of new ground, and each true loop.
class Play {
 public:
  Play(const Sequence& sequence, bool metric, const ParameterValues& values)
      : fixture(values), sequence_(sequence), metric_(metric) {
    fixture.create(Eigen::Isometry3d::Identity());
    experience_of_.push_back({0, {}});
    for (const Edge& edge : sequence.odometry) advance(edge);
    REQUIRE(fixture.map.finish({}).isOk());
  }

  double rmse() const {
    std::vector<std::complex<double>> path;
    std::vector<std::complex<double>> truth;
    for (std::int64_t k = 0; k < fixture.frame; ++k) {
      const PlanarPose pose = toPlanar(fixture.poseOf(k));
      path.emplace_back(pose.x, pose.y);
    }
    for (const PlanarPose& pose : sequence_.truth) truth.emplace_back(pose.x, pose.y);
    return alignedRmse(path, truth);
  }

  Fixture fixture;

 private:
  static constexpr double kSpacing = 5;  // m

  void advance(const Edge& edge) {
    since_ = tolman::compose(since_, edge.pose);
    travelled_ += std::hypot(edge.pose.x, edge.pose.y);
    const auto loop = sequence_.loops.find(edge.to);
    if (loop != sequence_.loops.end()) {
      close(edge, loop->second);
    } else if (travelled_ > kSpacing) {
      restart(fixture.created, {});
      fixture.create(fromPlanar(edge.pose));
    } else {
      fixture.stay(fromPlanar(edge.pose));
    }
    experience_of_.push_back({base_, since_});
  }

  void close(const Edge& edge, const Edge& loop) {
    const auto& [experience, T_experience_earlier] =
        experience_of_[static_cast<std::size_t>(loop.to)];
    const PlanarPose later = tolman::between(loop.pose, PlanarPose{});  // seen from the earlier
    const PlanarPose offset = tolman::compose(T_experience_earlier, later);
    if (metric_) {
      fixture.closeMeasured(fromPlanar(edge.pose), experience, fromPlanar(offset), 0.5);
    } else {
      fixture.close(fromPlanar(edge.pose), experience, offset.theta);
    }
    restart(experience, offset);
  }

  void restart(std::int64_t experience, const PlanarPose& offset) {
    base_ = experience;
    since_ = offset;
    travelled_ = 0;
  }

  const Sequence& sequence_;
  bool metric_;
  std::vector<std::pair<std::int64_t, PlanarPose>> experience_of_;
  std::int64_t base_ = 0;
  PlanarPose since_;
  double travelled_ = 0;
};

struct Figures {
  double odometry = 0;
  double assumed = 0;
  double metric = 0;
};

Figures measure(const char* name) {
  const auto folder = test::dataOrSkip(std::string("kitti_motion/") + name);
  if (!folder) return {};
  const Sequence sequence = readSequence(*folder);
  Figures figures;
  figures.odometry = Play(sequence, false, {{"optimise", false}}).rmse();
  figures.assumed = Play(sequence, false, {}).rmse();
  figures.metric = Play(sequence, true, {}).rmse();
  std::cout << "KITTI " << name << " RMSE: odometry " << figures.odometry << " m, loops by looks "
            << figures.assumed << " m, metric loops " << figures.metric << " m\n";
  return figures;
}

}  // namespace

TEST_CASE("true revisits take the drift out of KITTI 00", "[data]") {
  const Figures figures = measure("00");
  if (figures.odometry == 0) return;
  CHECK(figures.odometry == Approx(21.03).margin(0.01));  // the figure published with the data
  CHECK(figures.metric < 3.0);                            // batch oracle with all edges: 2.13
  CHECK(figures.assumed < 5.0);
}

TEST_CASE("true revisits take the drift out of KITTI 06", "[data]") {
  const Figures figures = measure("06");
  if (figures.odometry == 0) return;
  CHECK(figures.odometry == Approx(3.56).margin(0.01));
  CHECK(figures.metric < 3.0);  // batch oracle with all edges: 2.22
  CHECK(figures.assumed < 3.56);
}

}  // namespace tolman::experience_map
