// SPDX-License-Identifier: BSD-3-Clause
#include "feature_guess.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>
#include <opencv2/core/eigen.hpp>
#include <opencv2/video/tracking.hpp>
#include <vector>

namespace tolman::direct_sparse {

namespace {

constexpr int kMostPixels = (2 * kLargestPatchRadius + 1) * (2 * kLargestPatchRadius + 1);
using Values = Eigen::Array<float, Eigen::Dynamic, 1, 0, kMostPixels, 1>;

/// Grey values and gradients of the patch, means removed.
struct Patch {
  int radius = 0;
  Values value, gu, gv;
  float guu = 0, guv = 0, gvv = 0;

  float smallestEigenvalue() const {
    const float half = 0.5F * (guu - gvv);
    return 0.5F * (guu + gvv) - std::sqrt(half * half + guv * guv);
  }
};

Patch patchAt(const GrayLevel& image, int u, int v, float gain, int radius) {
  const int pixels = (2 * radius + 1) * (2 * radius + 1);
  Patch patch{radius, Values(pixels), Values(pixels), Values(pixels)};
  int k = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    const std::uint8_t* row = image.row(v + dy) + u;
    for (int dx = -radius; dx <= radius; ++dx, ++k) {
      const std::uint8_t* p = row + dx;
      patch.value[k] = gain * static_cast<float>(*p);
      patch.gu[k] = 0.5F * gain * static_cast<float>(p[1] - p[-1]);
      patch.gv[k] = 0.5F * gain * static_cast<float>(p[image.width] - p[-image.width]);
    }
  }
  patch.value -= patch.value.mean();
  patch.gu -= patch.gu.mean();
  patch.gv -= patch.gv.mean();
  patch.guu = patch.gu.square().sum();
  patch.guv = (patch.gu * patch.gv).sum();
  patch.gvv = patch.gv.square().sum();
  return patch;
}

/// Differences of the image around `at` from the patch, means removed.
Values differences(const Patch& patch, const GrayLevel& image, const Eigen::Vector2f& at) {
  const int x = static_cast<int>(at.x());
  const int y = static_cast<int>(at.y());
  const float fx = at.x() - static_cast<float>(x);
  const float fy = at.y() - static_cast<float>(y);
  const int radius = patch.radius;
  Values e(patch.value.size());
  int k = 0;
  for (int dy = -radius; dy <= radius; ++dy) {
    const std::uint8_t* p = image.row(y + dy) + x;
    const std::uint8_t* q = p + image.width;
    for (int dx = -radius; dx <= radius; ++dx, ++k) {
      const auto p0 = static_cast<float>(p[dx]), q0 = static_cast<float>(q[dx]);
      const float top = p0 + fx * (static_cast<float>(p[dx + 1]) - p0);
      const float bottom = q0 + fx * (static_cast<float>(q[dx + 1]) - q0);
      e[k] = top + fy * (bottom - top);
    }
  }
  e -= e.mean();
  return e - patch.value;
}

}  // namespace

std::optional<Eigen::Vector2f> matchPatch(const GrayLevel& here, int u, int v,
                                          const GrayLevel& there, const Eigen::Vector2f& start,
                                          float gain, int radius) {
  // Chosen, not tuned.
  constexpr float kMinInformation = 25;      // smallest eigenvalue a pixel, grey levels^2
  constexpr float kLargestMeanSquare = 100;  // grey levels^2
  constexpr float kFarthest = 1.5F;          // px
  const float margin = static_cast<float>(radius + 1);
  constexpr int kSteps = 8;
  if (!here.contains(static_cast<float>(u), static_cast<float>(v), margin)) return {};
  const Patch patch = patchAt(here, u, v, gain, radius);
  if (patch.smallestEigenvalue() < kMinInformation * static_cast<float>(patch.value.size()))
    return {};
  const float determinant = patch.guu * patch.gvv - patch.guv * patch.guv;
  Eigen::Vector2f at = start;
  for (int step = 0; step < kSteps; ++step) {
    if (!there.contains(at.x(), at.y(), margin)) return {};
    const auto e = differences(patch, there, at);
    const float eu = (patch.gu * e).sum();
    const float ev = (patch.gv * e).sum();
    const Eigen::Vector2f change((patch.guv * ev - patch.gvv * eu) / determinant,
                                 (patch.guv * eu - patch.guu * ev) / determinant);
    at += change.cwiseMax(-0.7F).cwiseMin(0.7F);
    if ((at - start).cwiseAbs().maxCoeff() > kFarthest) return {};
    if (change.cwiseAbs().maxCoeff() < 0.01F) {
      if (e.square().mean() > kLargestMeanSquare) return {};
      return at;
    }
  }
  return {};
}

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
