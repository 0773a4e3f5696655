// SPDX-License-Identifier: BSD-3-Clause
#include "support/kitti_clip.hpp"

#include <Eigen/SVD>
#include <algorithm>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

#include "tolman/image_cv.hpp"

namespace tolman::test {
namespace {

Eigen::Matrix<double, 3, 4> matrixOf(const std::string& numbers) {
  std::istringstream stream(numbers);
  Eigen::Matrix<double, 3, 4> m;
  for (int r = 0; r < 3; ++r) {
    for (int c = 0; c < 4; ++c) stream >> m(r, c);
  }
  return m;
}

}  // namespace

KittiClip::KittiClip(std::filesystem::path folder, const char* type)
    : folder_(std::move(folder)), type_(type) {
  std::ifstream file(folder_ / "calib.txt");
  std::string left;
  std::string right;
  std::getline(file, left);
  std::getline(file, right);
  const auto P0 = matrixOf(left.substr(3));
  const Image first = image("image_0", 0);
  rig_.width = first.width();
  rig_.height = first.height();
  rig_.calibrated = true;
  rig_.pinhole = {P0(0, 0), P0(1, 1), P0(0, 2), P0(1, 2)};
  if (right.size() > 3) rig_.baseline = -matrixOf(right.substr(3))(0, 3) / P0(0, 0);
}

Image KittiClip::image(const char* camera, int index) const {
  std::ostringstream name;
  name.fill('0');
  name.width(6);
  name << index;
  return asImage(
      cv::imread((folder_ / camera / (name.str() + type_)).string(), cv::IMREAD_GRAYSCALE));
}

Frame KittiClip::frame(std::size_t k, int index, bool covered_right) const {
  Frame frame;
  frame.frame = static_cast<std::int64_t>(k);
  frame.stamp_ns = frame.frame * 100'000'000;
  frame.left = image("image_0", index);
  if (!std::filesystem::exists(folder_ / "image_1")) return frame;
  frame.right = image("image_1", index);
  if (!covered_right) return frame;
  frame.right = Image::create(
      rig_.width, rig_.height, PixelFormat::Gray8,
      [this](std::uint8_t* data) { std::fill_n(data, rig_.width * rig_.height, std::uint8_t{6}); });
  return frame;
}

double KittiClip::ateRmse(const std::vector<Eigen::Isometry3d>& poses,
                          const std::vector<int>& order, bool scaled) const {
  std::ifstream file(folder_ / "poses.txt");
  std::vector<Eigen::Vector3d> true_positions;
  for (std::string line; std::getline(file, line);) {
    true_positions.push_back(matrixOf(line).col(3));
  }
  Eigen::Matrix3Xd estimate(3, static_cast<Eigen::Index>(poses.size()));
  Eigen::Matrix3Xd truth = estimate;
  for (std::size_t k = 0; k < poses.size(); ++k) {
    estimate.col(static_cast<Eigen::Index>(k)) = poses[k].translation();
    truth.col(static_cast<Eigen::Index>(k)) = true_positions.at(static_cast<std::size_t>(order[k]));
  }
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

std::vector<int> indexRange(int from, int to) {
  std::vector<int> indices;
  for (int k = from; k != to; k += from < to ? 1 : -1) indices.push_back(k);
  return indices;
}

}  // namespace tolman::test
