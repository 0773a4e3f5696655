// SPDX-License-Identifier: BSD-3-Clause
// Real images, where they are: the error against the truth, and agreed lengths.
#include <Eigen/SVD>
#include <catch2/catch.hpp>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "harness.hpp"
#include "support/data.hpp"
#include "tolman/image_cv.hpp"

using namespace tolman;

namespace {

Eigen::Matrix<double, 3, 4> matrixOf(const std::string& numbers) {
  std::istringstream stream(numbers);
  Eigen::Matrix<double, 3, 4> m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) stream >> m(r, c);
  }
  return m;
}

CameraRig readRig(const std::filesystem::path& clip, const cv::Mat& image) {
  std::ifstream file(clip / "calib.txt");
  std::string left;
  std::string right;
  std::getline(file, left);
  std::getline(file, right);
  const auto P0 = matrixOf(left.substr(3));
  CameraRig rig;
  rig.width = image.cols;
  rig.height = image.rows;
  rig.calibrated = true;
  rig.pinhole = {P0(0, 0), P0(1, 1), P0(0, 2), P0(1, 2)};
  if (right.size() > 3) rig.baseline = -matrixOf(right.substr(3))(0, 3) / P0(0, 0);
  return rig;
}

cv::Mat readImage(const std::filesystem::path& clip, const char* camera, int index,
                  const char* type = ".png") {
  std::ostringstream name;
  name.fill('0');
  name.width(6);
  name << index;
  return cv::imread((clip / camera / (name.str() + type)).string(), cv::IMREAD_GRAYSCALE);
}

/// Frames whose right image is dark.
struct Covered {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Runs images `order` of a clip at 10 Hz; counts frames without measurement.
int run(test::Host& host, const std::filesystem::path& clip, const std::vector<int>& order,
        const char* type = ".png", Covered covered = {}) {
  int lost = 0;
  for (std::size_t k = 0; k < order.size(); ++k) {
    Frame frame;
    frame.frame = static_cast<std::int64_t>(k);
    frame.stamp_ns = frame.frame * 100'000'000;
    frame.left = asImage(readImage(clip, "image_0", order[k], type));
    if (std::filesystem::exists(clip / "image_1")) {
      cv::Mat right = readImage(clip, "image_1", order[k], type);
      if (k >= covered.begin && k < covered.end)
        right = cv::Mat(right.size(), CV_8U, cv::Scalar(6));
      frame.right = asImage(right);
    }
    lost += host.track(frame).state == TrackingState::Lost ? 1 : 0;
  }
  host.finish();
  return lost;
}

/// Root mean square distance after the best rotation and translation, and the best scale where
/// asked for (Umeyama 1991, equations 34 to 43).
double ateRmse(const Eigen::Matrix3Xd& estimate, const Eigen::Matrix3Xd& truth, bool scaled) {
  const Eigen::Matrix3Xd e = estimate.colwise() - estimate.rowwise().mean().eval();
  const Eigen::Matrix3Xd t = truth.colwise() - truth.rowwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(t * e.transpose(),
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::Vector3d sign(1, 1, 1);
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) sign.z() = -1;
  const Eigen::Matrix3d R = svd.matrixU() * sign.asDiagonal() * svd.matrixV().transpose();
  const double scale = scaled ? (R * e).cwiseProduct(t).sum() / e.squaredNorm() : 1;
  return std::sqrt((scale * R * e - t).colwise().squaredNorm().mean());
}

double ateOf(const test::Host& host, const std::filesystem::path& clip,
             const std::vector<int>& order, bool scaled = false) {
  std::ifstream file(clip / "poses.txt");
  std::vector<Eigen::Vector3d> places;
  for (std::string line; std::getline(file, line);) places.push_back(matrixOf(line).col(3));
  const auto poses = host.trajectory();
  Eigen::Matrix3Xd estimate(3, static_cast<Eigen::Index>(poses.size()));
  Eigen::Matrix3Xd truth = estimate;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    estimate.col(static_cast<Eigen::Index>(k)) = poses[k].translation();
    truth.col(static_cast<Eigen::Index>(k)) = places.at(static_cast<std::size_t>(order[k]));
  }
  return ateRmse(estimate, truth, scaled);
}

std::vector<int> range(int from, int to) {
  std::vector<int> indices;
  for (int k = from; k != to; k += from < to ? 1 : -1) indices.push_back(k);
  return indices;
}

}  // namespace

TEST_CASE("KITTI 06, forwards, backwards and back again") {
  const auto clip = test::dataOrSkip("kitti_clips/06");
  if (!clip) return;
  const CameraRig rig = readRig(*clip, readImage(*clip, "image_0", 0));
  test::Host host(rig);
  SECTION("forwards") {
    CHECK(run(host, *clip, range(0, 51)) == 0);
    CHECK(ateOf(host, *clip, range(0, 51)) < 0.06);
  }
  SECTION("backwards") {
    CHECK(run(host, *clip, range(50, -1)) == 0);
    CHECK(ateOf(host, *clip, range(50, -1)) < 0.07);
  }
  SECTION("twenty frames and back: never lost, and home again") {
    std::vector<int> order = range(0, 21);
    for (const int k : range(19, -1)) order.push_back(k);
    CHECK(run(host, *clip, order) == 0);
    CHECK(host.trajectory().back().translation().norm() < 0.06);
  }
}

TEST_CASE("KITTI 06 with the right camera covered for two seconds: not lost, scale kept") {
  const auto clip = test::dataOrSkip("kitti_clips/06");
  if (!clip) return;
  test::Host host(readRig(*clip, readImage(*clip, "image_0", 0)));
  CHECK(run(host, *clip, range(0, 51), ".png", {15, 35}) == 0);
  CHECK(ateOf(host, *clip, range(0, 51)) < 0.1);
}

TEST_CASE("KITTI raw 0001 with moving traffic has the length that others agree on") {
  const auto clip = test::dataOrSkip("kitti_clips/raw_0001");
  if (!clip) return;
  test::Host host(readRig(*clip, readImage(*clip, "image_0", 0)));
  CHECK(run(host, *clip, range(0, 108)) == 0);
  CAPTURE(host.length());
  CHECK(host.length() == Approx(108.1).epsilon(0.005));
}

TEST_CASE("KITTI 00 with one camera: starts early, is never lost") {
  const auto clip = test::dataOrSkip("kitti_clips/00_left");
  if (!clip) return;
  CameraRig rig = readRig(*clip, readImage(*clip, "image_0", 0));
  test::Host host(rig, {}, direct_sparse::Cameras::Single);
  CHECK(run(host, *clip, range(0, 120)) == 0);
  CHECK(ateOf(host, *clip, range(0, 120), true) < 0.35);
}

TEST_CASE("KITTI 03 with one camera and JPEG images: never lost, its scale kept") {
  const auto clip = test::dataOrSkip("kitti_clips/03_left");
  if (!clip) return;
  const CameraRig rig = readRig(*clip, readImage(*clip, "image_0", 0, ".jpg"));
  test::Host host(rig, {}, direct_sparse::Cameras::Single);
  CHECK(run(host, *clip, range(0, 300), ".jpg") == 0);
  CHECK(ateOf(host, *clip, range(0, 300), true) < 3.1);  // of 210 m
}
