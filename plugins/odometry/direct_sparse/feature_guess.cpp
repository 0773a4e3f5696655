// SPDX-License-Identifier: BSD-3-Clause
#include "feature_guess.hpp"

#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

namespace tolman::direct_sparse {
namespace {

// At most this many points are tracked; poseByConsensus() needs 30 inliers, 6 % of them.
constexpr std::size_t kMaxFollowed = 500;

cv::Mat asMat(const GrayLevel& image) {
  return {image.height, image.width, CV_8UC1, const_cast<std::uint8_t*>(image.row(0))};
}

/// Points that are tracked from the newest keyframe to the image: positions in the camera frame of
/// the keyframe (m), and pixels in both images.
struct Followed {
  std::vector<cv::Point3f> points;
  std::vector<cv::Point2f> before;
  std::vector<cv::Point2f> after;
};

/// Points of all keyframes that lie in the image of the newest one. `after` are the pixels at which
/// the motion `expected` predicts them.
Followed pointsInView(const CameraRig& rig, const Window& window,
                      const Eigen::Isometry3d& expected) {
  constexpr double kNearest = 0.1;  // m; keeps the projection finite
  const GrayLevel& image = window.newest().left.level(0);
  Followed followed;
  for (const Eigen::Vector3d& p :
       somePositions(rig.pinhole, window, window.newest().T_camera_world(), kMaxFollowed)) {
    const Eigen::Vector3d q = expected * p;
    if (p.z() < kNearest || q.z() < kNearest) continue;
    const Eigen::Vector2f there = rig.pinhole.project(p).cast<float>();
    if (!image.contains(there.x(), there.y(), kPatternRadius)) continue;
    const Eigen::Vector2f now = rig.pinhole.project(q).cast<float>();
    followed.points.emplace_back(float(p.x()), float(p.y()), float(p.z()));
    followed.before.emplace_back(there.x(), there.y());
    followed.after.emplace_back(now.x(), now.y());
  }
  return followed;
}

/// Tracks the points forward and back, and keeps those that return to where they started.
void follow(const cv::Mat& before, const cv::Mat& after, Followed& followed) {
  // Pyramidal Lucas-Kanade (Bouguet 2001) with OpenCV's default termination criteria. Four levels
  // with windows of 15 px follow about 60 px.
  constexpr int kLevels = 4;
  constexpr double kConsistency = 1;  // px; chosen, not tuned
  const cv::Size window(15, 15);
  const cv::TermCriteria stop(cv::TermCriteria::COUNT | cv::TermCriteria::EPS, 30, 0.01);
  const auto flow = [&](const cv::Mat& from, const cv::Mat& to, const auto& at, auto& moved) {
    std::vector<uchar> found;
    std::vector<float> error;
    cv::calcOpticalFlowPyrLK(from, to, at, moved, found, error, window, kLevels - 1, stop,
                             cv::OPTFLOW_USE_INITIAL_FLOW);
    return found;
  };
  std::vector<cv::Point2f> back = followed.before;
  const std::vector<uchar> found = flow(before, after, followed.before, followed.after);
  const std::vector<uchar> returned = flow(after, before, followed.after, back);
  Followed kept;
  for (std::size_t i = 0; i < back.size(); ++i) {
    const bool good = found[i] != 0 && returned[i] != 0;
    if (!good || cv::norm(back[i] - followed.before[i]) > kConsistency) continue;
    kept.points.push_back(followed.points[i]);
    kept.before.push_back(followed.before[i]);
    kept.after.push_back(followed.after[i]);
  }
  followed = std::move(kept);
}

std::optional<Eigen::Isometry3d> poseByConsensus(const CameraRig& rig, const Followed& followed) {
  // The guess is only the initial value of the photometric alignment, which rejects a wrong one.
  // The number of samples is derived, not tuned: with 35 % inliers, the probability that none of
  // 300 samples of four points is free of outliers is (1 - 0.35^4)^300 = 0.01.
  constexpr int kMin = 30;        // chosen, not tuned
  constexpr double kShare = 0.3;  // of the points; a little below the 35 % above
  constexpr double kNoise = 2;    // px, twice kConsistency of follow()
  constexpr int kSamples = 300;
  if (followed.points.size() < kMin) return std::nullopt;
  const cv::Matx33d K(rig.pinhole.fx, 0, rig.pinhole.cx, 0, rig.pinhole.fy, rig.pinhole.cy, 0, 0,
                      1);
  cv::Vec3d rotation;
  cv::Vec3d translation;
  std::vector<int> inliers;
  const bool solved =
      cv::solvePnPRansac(followed.points, followed.after, K, cv::noArray(), rotation, translation,
                         false, kSamples, kNoise, 0.999, inliers, cv::SOLVEPNP_SQPNP);
  const auto count = static_cast<double>(inliers.size());
  if (!solved || count < kMin || count < kShare * static_cast<double>(followed.points.size())) {
    return std::nullopt;
  }
  Eigen::Isometry3d T = Eigen::Isometry3d::Identity();
  T.linear() = expSo3({rotation[0], rotation[1], rotation[2]});
  T.translation() << translation[0], translation[1], translation[2];
  if (!T.matrix().allFinite()) return std::nullopt;
  return T;
}

}  // namespace

std::optional<Eigen::Isometry3d> guessByFeatures(const CameraRig& rig, const Window& window,
                                                 const GrayLevel& image,
                                                 const Eigen::Isometry3d& expected) {
  Followed followed = pointsInView(rig, window, expected);
  if (followed.points.empty()) return std::nullopt;
  follow(asMat(window.newest().left.level(0)), asMat(image), followed);
  return poseByConsensus(rig, followed);
}

}  // namespace tolman::direct_sparse
