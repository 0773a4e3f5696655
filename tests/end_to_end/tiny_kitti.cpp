// SPDX-License-Identifier: BSD-3-Clause
#include "end_to_end/tiny_kitti.hpp"

#include <cstdio>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "support/paths.hpp"
#include "tolman/context.hpp"

namespace tolman::test {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 60;

cv::Mat texture() {
  RandomStream random(5);
  cv::Mat image(kHeight, 4 * kWidth, CV_8UC1);
  for (int r = 0; r < image.rows; ++r) {
    for (int c = 0; c < image.cols; ++c) {
      image.at<unsigned char>(r, c) = static_cast<unsigned char>(random.below(256));
    }
  }
  return image;
}

}  // namespace

void writeTinyKitti(const std::filesystem::path& folder, int frames) {
  std::filesystem::create_directories(folder / "image_0");
  std::filesystem::create_directories(folder / "image_1");
  const cv::Mat world = texture();
  std::ofstream times(folder / "times.txt");
  std::ofstream poses(folder / "poses.txt");
  for (int k = 0; k < frames; ++k) {
    char name[16];
    std::snprintf(name, sizeof(name), "%06d.png", k);
    const int shift = (8 * k) % (2 * kWidth);
    cv::imwrite((folder / "image_0" / name).string(), world.colRange(shift, shift + kWidth));
    cv::imwrite((folder / "image_1" / name).string(),
                world.colRange(shift + 6, shift + 6 + kWidth));
    times << 0.1 * k << "\n";
    poses << "1 0 0 0 0 1 0 0 0 0 1 " << k << "\n";
  }
  std::ofstream(folder / "calib.txt") << "P0: 100 0 80 0 0 100 30 0 0 0 1 0\n"
                                      << "P1: 100 0 80 -50 0 100 30 0 0 0 1 0\n";
}

std::filesystem::path writeTinyConfig(const std::filesystem::path& folder,
                                      const std::filesystem::path& sequence) {
  const auto file = folder / "tiny.yaml";
  std::ofstream(file) << "name: tiny\n"
                      << "source: {plugin: kitti, path: " << sequence.string() << "}\n"
                      << "odometry: {plugin: steady, speed: 10}\n"
                      << "place: {plugin: view_templates}\n"
                      << "cells: {plugin: bayesian_attractor}\n"
                      << "map: {plugin: experience_map}\n";
  return file;
}

std::vector<std::string> tinyRun(const std::filesystem::path& config,
                                 const std::filesystem::path& out) {
  const std::string fixtures = inBuild("tests/fixtures/plugins/");
  return {"run",           config.string(),     "--out",         out.string(),
          "--plugin-path", fixtures + "steady", "--plugin-path", fixtures + "misbehaving"};
}

}  // namespace tolman::test
