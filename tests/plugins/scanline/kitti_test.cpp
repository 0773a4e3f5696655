// SPDX-License-Identifier: BSD-3-Clause
// Real streets with true poses.
#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "harness.hpp"
#include "support/data.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;
using namespace tolman::scanline::test;

namespace {

std::vector<Eigen::Isometry3d> readPoses(const std::filesystem::path& file) {
  std::vector<Eigen::Isometry3d> poses;
  std::ifstream stream(file);
  for (Eigen::Matrix<double, 3, 4> M;;) {
    for (int i = 0; i < 12; ++i) stream >> M(i / 4, i % 4);
    if (!stream) return poses;
    Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
    T.linear() = M.leftCols<3>();
    T.translation() = M.col(3);
    poses.push_back(T);
  }
}

CameraRig kittiRig(const Image& image) {
  return {image.width(), image.height(), true, {718.856, 718.856, 607.1928, 185.2157}, 0};
}

}  // namespace

TEST_CASE("KITTI 00 and 03: turns within a sixth of a degree a frame or so, way within 60 %",
          "[data]") {
  const auto folder =
      tolman::test::dataOrSkip(GENERATE("kitti_clips/00_left", "kitti_clips/03_left"));
  if (!folder) return;
  const std::vector<Eigen::Isometry3d> truth = readPoses(*folder / "poses.txt");
  std::set<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(*folder / "image_0")) {
    files.insert(entry.path());
  }
  std::unique_ptr<Host> host;
  double squares = 0;
  double way = 0;
  double true_way = 0;
  std::size_t i = 0;
  for (const auto& file : files) {
    const Image image = asImage(cv::imread(file.string(), cv::IMREAD_GRAYSCALE));
    if (!host) host = std::make_unique<Host>(kittiRig(image));
    const PlanarPose step = toPlanar(host->see(image).T_previous_current);
    if (i > 0) {
      const PlanarPose expected = toPlanar(truth[i - 1].inverse() * truth[i]);
      squares += (step.theta - expected.theta) * (step.theta - expected.theta);
      way += std::hypot(step.x, step.y);
      true_way += std::hypot(expected.x, expected.y);
    }
    ++i;
  }
  const double error = std::sqrt(squares / static_cast<double>(i - 1)) * 57.29577951;
  WARN(folder->filename().string()
       << ": " << error << " degrees a frame, way " << way << " of " << true_way << " m");
  CHECK(error < 0.25);
  CHECK(way > 0.6 * true_way);
  CHECK(way < 1.6 * true_way);
}
