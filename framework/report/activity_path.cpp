// SPDX-License-Identifier: BSD-3-Clause
#include "report/activity_path.hpp"

#include <algorithm>
#include <map>

#include "tolman/geometry.hpp"

namespace tolman::report {
namespace {

constexpr int kMostBins = 70;
constexpr double kFarthest = 1e7;  // m

int binsFor(const std::vector<Sample>& way) {
  Eigen::AlignedBox2d box;
  double length = 0;
  for (std::size_t i = 0; i < way.size(); ++i) {
    box.extend(way[i].position);
    if (i > 0) length += (way[i].position - way[i - 1].position).norm();
  }
  const double step = length / std::max(static_cast<double>(way.size()) - 1, 1.0);
  if (!(step > 0)) return 1;
  return std::clamp(static_cast<int>(box.sizes().maxCoeff() / (1.5 * step)), 1, kMostBins);
}

}  // namespace

ActivityPath::ActivityPath(const PopulationHistory& population, const evaluation::Trajectory& map) {
  std::map<std::int64_t, const Eigen::Isometry3d*> poses;
  for (const auto& pose : map) poses[pose.frame] = &pose.T_world_camera;
  for (std::size_t i = 0; i < population.frames.size(); ++i) {
    const auto pose = poses.find(population.frames[i]);
    if (pose == poses.end()) continue;
    const Eigen::Vector3d p = pose->second->translation();
    if (!(p.cwiseAbs().maxCoeff() < kFarthest)) continue;
    way_.push_back({{p.x(), p.z()}, toPlanar(*pose->second).theta, 0});
    activity_.push_back(&population.activity[i]);
  }
  bins_ = binsFor(way_);
}

std::vector<Sample> ActivityPath::samples(std::size_t unit, double shift) const {
  std::vector<Sample> samples;
  const auto later = static_cast<std::size_t>(shift * static_cast<double>(way_.size()));
  for (std::size_t i = 0; i < way_.size(); ++i) {
    const std::vector<float>& activity = *activity_[(i + later) % way_.size()];
    if (unit >= activity.size()) continue;
    samples.push_back(way_[i]);
    samples.back().rate = activity[unit];
  }
  return samples;
}

RateMap ActivityPath::rates(std::size_t unit, double shift) const {
  return rateMap(samples(unit, shift), bins_);
}

}  // namespace tolman::report
