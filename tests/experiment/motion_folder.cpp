// SPDX-License-Identifier: BSD-3-Clause
#include "experiment/motion_folder.hpp"

#include <fstream>

namespace tolman::test {
namespace {

constexpr int kSide = 50;  // frames of 1 m
constexpr int kLap = 4 * kSide;

void writeEdges(const std::filesystem::path& file, double bend) {
  std::ofstream edges(file);
  for (int i = 0; i < 2 * kLap; ++i) {
    const double turn = (i % kSide >= kSide - 5 ? 1.5707963267948966 / 5 : 0) + bend;
    edges << "EDGE_SE2 " << i << " " << i + 1 << " 1 0 " << turn << " 1 0 0 1 0 1\n";
  }
}

}  // namespace

void writeMotionFolder(const std::filesystem::path& folder, double bend) {
  std::filesystem::create_directories(folder);
  writeEdges(folder / "odometry.g2o", bend);
  writeEdges(folder / "ground_truth.g2o", 0);
  std::ofstream candidates(folder / "loop_candidates.g2o");
  for (int i = kLap; i < 2 * kLap; i += 5) {
    candidates << "EDGE_SE2 " << i << " " << i - kLap << " 0 0 0 1 0 0 1 0 1\n";
  }
}

std::filesystem::path writeMotionConfig(const std::filesystem::path& folder,
                                        const std::filesystem::path& log) {
  const std::filesystem::path file = folder / "motion.yaml";
  std::ofstream(file) << "name: motion\n"
                         "source: {plugin: motion_log, path: "
                      << log.string()
                      << "}\n"
                         "odometry: {plugin: motion_replay}\n"
                         "place: {plugin: place_replay, relative_pose: true}\n"
                         "cells: {plugin: bayesian_attractor}\n"
                         "map: {plugin: experience_map}\n"
                         "record: {arrays_every: 0, report: false}\n";
  return file;
}

}  // namespace tolman::test
