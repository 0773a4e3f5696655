// SPDX-License-Identifier: BSD-3-Clause
#include "engine/rectified_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tolman::engine {

namespace {

// Limits of the distortion model: 84 degrees for a pinhole, the whole sphere for a fisheye.
constexpr double kMaxRadius = 10;
constexpr double kMaxAngle = 3.14159265358979;
constexpr double kLensStep = 1e-3;

}  // namespace

Lens::Lens(const RawCamera& camera) : camera_(camera) {
  const double most = camera.model == LensModel::Equidistant ? kMaxAngle : kMaxRadius;
  for (double before = 0; limit_ < most; limit_ += kLensStep) {
    const double here = distorted(limit_ + kLensStep);
    if (!(here > before)) break;  // also for NaN
    before = here;
  }
}

bool Lens::isPinhole() const {
  const bool straight = camera_.distortion.isZero(0) && camera_.xi == 0;
  return camera_.model == LensModel::Pinhole ||
         (straight && camera_.model != LensModel::Equidistant);
}

double Lens::focal() const {
  const double f = 0.5 * (camera_.pinhole.fx + camera_.pinhole.fy);
  return camera_.model == LensModel::Omnidirectional ? f / (1 + camera_.xi) : f;
}

/// Radial distortion of a radius, or of an angle for Equidistant.
double Lens::distorted(double radius) const {
  const auto& k = camera_.distortion;
  const double s = radius * radius;
  switch (camera_.model) {
    case LensModel::Pinhole:
      return radius;
    case LensModel::Equidistant:
      return radius * (1 + s * (k[0] + s * (k[1] + s * (k[2] + s * k[3]))));
    case LensModel::RadialTangential:
    case LensModel::Omnidirectional:
      break;
  }
  return radius * (1 + s * (k[0] + s * (k[1] + s * k[4]))) /
         (1 + s * (k[5] + s * (k[6] + s * k[7])));
}

/// Radial and tangential distortion (Brown 1966, in the form of OpenCV).
Eigen::Vector2d Lens::distorted(const Eigen::Vector2d& p) const {
  const double p1 = camera_.distortion[2];
  const double p2 = camera_.distortion[3];
  const double radius = p.norm();
  const double ratio = radius > 0 ? distorted(radius) / radius : 1;
  const double s = radius * radius;
  const double xy = 2 * p.x() * p.y();
  return {p.x() * ratio + p1 * xy + p2 * (s + 2 * p.x() * p.x()),
          p.y() * ratio + p1 * (s + 2 * p.y() * p.y()) + p2 * xy};
}

std::optional<Eigen::Vector2d> Lens::project(const Eigen::Vector3d& point) const {
  const Pinhole& K = camera_.pinhole;
  Eigen::Vector2d p;
  if (camera_.model == LensModel::Equidistant) {
    const double across = point.head<2>().norm();
    const double angle = std::atan2(across, point.z());
    if (angle > limit_) return std::nullopt;
    p = across > 0 ? Eigen::Vector2d(point.head<2>() * (distorted(angle) / across))
                   : Eigen::Vector2d(0, 0);
  } else {
    const bool is_mirror = camera_.model == LensModel::Omnidirectional;
    const double depth = point.z() + (is_mirror ? camera_.xi * point.norm() : 0);
    if (depth <= 0) return std::nullopt;
    p = point.head<2>() / depth;
    if (p.norm() > limit_) return std::nullopt;
    if (camera_.model != LensModel::Pinhole) p = distorted(p);
  }
  return Eigen::Vector2d(K.fx * p.x() + K.cx, K.fy * p.y() + K.cy);
}

std::optional<Eigen::Vector2d> Lens::pixelOf(const Eigen::Vector3d& point) const {
  const auto pixel = project(point);
  const bool inside = pixel && pixel->x() >= 0 && pixel->x() <= camera_.width - 1 &&
                      pixel->y() >= 0 && pixel->y() <= camera_.height - 1;
  return inside ? pixel : std::nullopt;
}

namespace {

constexpr int kMinSide = 32;  // px of a rectified image
constexpr double kMaxPixels = 100e6;
constexpr double kMinShare = 0.25;     // least view of a raw side, unless the user asks for less
constexpr double kMinBaseline = 1e-3;  // m
constexpr double kMaxTurned = 45;      // deg between the optical axes and the rectified one
constexpr double kDegree = std::numbers::pi / 180;

/// Rotations from the raw cameras to the rectified view, and the baseline of two cameras.
struct Turned {
  std::vector<Eigen::Matrix3d> R;
  double baseline = 0;  ///< m
};

std::string_view sideOf(std::size_t i, std::size_t cameras) {
  if (cameras == 1) return "the camera";
  return i == 0 ? "the left camera" : "the right camera";
}

Status checkCamera(const RawCamera& camera, std::string_view who) {
  if (camera.width < kMinSide || camera.height < kMinSide || camera.width > 65000 ||
      camera.height > 65000) {
    return Status::invalidInput(
        fmt::format("{} has images of {}x{} px; 32 to 65000 px a side can be rectified", who,
                    camera.width, camera.height));
  }
  const bool focal = camera.pinhole.fx > 0 && camera.pinhole.fy > 0;
  if (!focal || camera.xi < 0 || camera.xi > 10) {
    return Status::invalidInput(
        fmt::format("{} has focal lengths of {} and {} px{}; correct the calibration", who,
                    camera.pinhole.fx, camera.pinhole.fy,
                    focal ? fmt::format(" and a mirror parameter xi of {}", camera.xi) : ""));
  }
  return Status::ok();
}

Result<Turned> turnPair(const RawCamera& left, const RawCamera& right) {
  const Eigen::Isometry3d T_left_right =
      left.T_reference_camera.inverse() * right.T_reference_camera;
  const Eigen::Vector3d baseline = T_left_right.translation();
  if (baseline.norm() < kMinBaseline) {
    return Status::invalidInput(
        "both cameras are at one place; give their poses (Kalibr: T_cn_cnm1, EuRoC: T_BS, "
        "OpenCV: R and T), or use one camera");
  }
  const Eigen::Vector3d x = baseline.normalized();
  if (x.x() < -std::cos(kMaxTurned * kDegree)) {
    return Status::invalidInput(
        "the right camera is left of the left one; exchange the two cameras");
  }
  if (x.x() < std::cos(kMaxTurned * kDegree)) {
    return Status::invalidInput(fmt::format(
        "the second camera is {:.3f} m to the right of the first, {:.3f} m below and {:.3f} m "
        "before it; a pair has its cameras beside each other: use one of them",
        baseline.x(), baseline.y(), baseline.z()));
  }
  const Eigen::Vector3d z_right = T_left_right.linear().col(2);
  const Eigen::Vector3d y = (Eigen::Vector3d::UnitZ() + z_right).cross(x).normalized();
  Eigen::Matrix3d R;
  R << x.transpose(), y.transpose(), x.cross(y).transpose();
  const double least = std::cos(kMaxTurned * kDegree);
  if (!R.allFinite() || R(2, 2) < least || R.row(2).dot(z_right) < least) {
    return Status::invalidInput(
        "the two cameras look into different directions, by more than 45 degrees from their "
        "common view; correct their poses, or use one camera");
  }
  return Turned{{R, R * T_left_right.linear()}, baseline.norm()};
}

/// A rectangle in the plane z = 1 of the rectified camera.
struct Rectangle {
  std::array<double, 4> side{};  ///< left, top, right, bottom

  Eigen::Vector3d at(double u, double v) const {
    return {side[0] + u * (side[2] - side[0]), side[1] + v * (side[3] - side[1]), 1};
  }
};

/// How many of 33 points on each side a camera does not show.
std::array<int, 4> hiddenOn(const Rectangle& rectangle, const Lens& lens,
                            const Eigen::Matrix3d& R) {
  constexpr int kSteps = 32;
  std::array<int, 4> hidden{};
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    const std::array points = {rectangle.at(0, t), rectangle.at(t, 0), rectangle.at(1, t),
                               rectangle.at(t, 1)};
    for (std::size_t k = 0; k < 4; ++k) {
      if (!lens.pixelOf(R.transpose() * points[k])) ++hidden[k];
    }
  }
  return hidden;
}

/// Moves the side with most hidden points inwards until all cameras show the whole rectangle.
Rectangle commonView(const std::vector<Lens>& lenses, const Turned& turned, double most_deg) {
  const double most = std::tan(0.5 * most_deg * kDegree);
  constexpr double kShare = 1.0 / 256;  // one step, as a share of `most`
  Rectangle rectangle{{-most, -most, most, most}};
  while (rectangle.side[2] > rectangle.side[0] && rectangle.side[3] > rectangle.side[1]) {
    std::array<int, 4> hidden{};
    for (std::size_t i = 0; i < lenses.size(); ++i) {
      const auto by_this = hiddenOn(rectangle, lenses[i], turned.R[i]);
      std::ranges::transform(hidden, by_this, hidden.begin(), std::plus<>());
    }
    const auto worst = std::ranges::max_element(hidden);
    if (*worst == 0) break;
    const auto side = static_cast<std::size_t>(worst - hidden.begin());
    rectangle.side[side] += (side < 2 ? kShare : -kShare) * most;
  }
  return rectangle;
}

CameraRig rigOf(const Rectangle& rectangle, double focal, double baseline) {
  const auto& [left, top, right, bottom] = rectangle.side;
  CameraRig rig;
  const double width = std::floor((right - left) * focal) + 1;
  const double height = std::floor((bottom - top) * focal) + 1;
  const bool sound = width >= 1 && height >= 1 && width * height <= kMaxPixels;
  rig.width = sound ? static_cast<int>(width) : 0;
  rig.height = sound ? static_cast<int>(height) : 0;
  rig.calibrated = true;
  rig.pinhole = {focal, focal, -left * focal, -top * focal};
  rig.baseline = baseline;
  return rig;
}

/// The same view with another number of pixels. Pixel centres are at integers, so the border of an
/// image is at -0.5.
CameraRig scaled(CameraRig rig, double scale) {
  if (scale == 1) return rig;
  rig.width = static_cast<int>(std::lround(rig.width * scale));
  rig.height = static_cast<int>(std::lround(rig.height * scale));
  Pinhole& K = rig.pinhole;
  K = {K.fx * scale, K.fy * scale, (K.cx + 0.5) * scale - 0.5, (K.cy + 0.5) * scale - 0.5};
  return rig;
}

Result<RectifiedView> prescribed(const RawRig& raw, double scale) {
  const bool stereo = raw.cameras.size() == 2;
  if (!raw.rectified.calibrated || raw.rectified.isStereo() != stereo ||
      !(raw.rectified.pinhole.fx > 0 && raw.rectified.pinhole.fy > 0)) {
    return Status::invalidInput(
        "the prescribed rectified cameras are not complete; correct the calibration");
  }
  RectifiedView view{scaled(raw.rectified, scale), {}, false};
  for (const RawCamera& camera : raw.cameras) {
    const Eigen::Matrix3d& R = camera.R_rectified_camera;
    if (!(R.transpose() * R).isIdentity(1e-3) || R.determinant() < 0) {
      return Status::invalidInput("a prescribed rotation is none; correct the calibration");
    }
    view.R_rectified_raw.push_back(R);
  }
  return view;
}

/// A single pinhole needs no rectification, only scaling.
RectifiedView keepPinhole(const RawCamera& camera, double scale) {
  RectifiedView view;
  view.rig.width = camera.width;
  view.rig.height = camera.height;
  view.rig.calibrated = true;
  view.rig.pinhole = camera.pinhole;
  view.rig = scaled(view.rig, scale);
  view.R_rectified_raw = {Eigen::Matrix3d::Identity()};
  view.is_identity = scale == 1;
  return view;
}

Status tooSmall(double width, double height) {
  return Status::invalidInput(fmt::format(
      "the rectified images would have {:.0f}x{:.0f} px: the cameras show too little in common, or "
      "their distortion is not of this model; check the model, the order of its coefficients, the "
      "poses of the cameras, and `rectification.scale`",
      std::max(width, 0.0), std::max(height, 0.0)));
}

Result<RectifiedView> largestView(const RawRig& raw, const std::vector<Lens>& lenses,
                                  const ViewOptions& options) {
  Turned turned{{Eigen::Matrix3d::Identity()}, 0};
  if (raw.cameras.size() == 2) {
    Result<Turned> pair = turnPair(raw.cameras[0], raw.cameras[1]);
    if (!pair.isOk()) return pair.status();
    turned = std::move(pair).value();
  }
  double focal = 0;
  for (const Lens& lens : lenses) focal += lens.focal() / static_cast<double>(lenses.size());
  const Rectangle rectangle = commonView(lenses, turned, options.field_of_view);
  const double most = 2 * std::tan(0.5 * options.field_of_view * kDegree);
  const auto isSmall = [&](double side, int raw_side) {
    return side < 0.5 * most && side * focal < kMinShare * raw_side;
  };
  const auto& [left, top, right, bottom] = rectangle.side;
  if (isSmall(right - left, raw.cameras[0].width) || isSmall(bottom - top, raw.cameras[0].height)) {
    return tooSmall((right - left) * focal, (bottom - top) * focal);
  }
  return RectifiedView{rigOf(rectangle, options.scale * focal, turned.baseline), turned.R, false};
}

}  // namespace

Result<RectifiedView> chooseView(const RawRig& raw, const ViewOptions& options) {
  if (raw.cameras.empty() || raw.cameras.size() > 2) {
    return Status::invalidInput(
        fmt::format("{} cameras; one or two can be rectified", raw.cameras.size()));
  }
  std::vector<Lens> lenses;
  for (std::size_t i = 0; i < raw.cameras.size(); ++i) {
    const Status status = checkCamera(raw.cameras[i], sideOf(i, raw.cameras.size()));
    if (!status.isOk()) return status;
    lenses.emplace_back(raw.cameras[i]);
  }
  if (!raw.has_rectified && lenses.size() == 1 && lenses[0].isPinhole()) {
    return keepPinhole(raw.cameras[0], options.scale);
  }
  Result<RectifiedView> view =
      raw.has_rectified ? prescribed(raw, options.scale) : largestView(raw, lenses, options);
  if (!view.isOk()) return view;
  const CameraRig& rig = view.value().rig;
  if (rig.width < kMinSide || rig.height < kMinSide ||
      static_cast<double>(rig.width) * rig.height > kMaxPixels) {
    return tooSmall(rig.width, rig.height);
  }
  return view;
}

std::string viewText(const RawRig& raw, const RectifiedView& view) {
  const RawCamera& left = raw.cameras.front();
  const std::string cameras =
      fmt::format("{} {} {} of {}x{} px", raw.cameras.size(), enumName(left.model),
                  raw.cameras.size() == 1 ? "camera" : "cameras", left.width, left.height);
  if (view.is_identity) return cameras + ", without distortion";
  const CameraRig& rig = view.rig;
  const auto degrees = [](double low, double high) { return (high - low) / kDegree; };
  const Pinhole& K = rig.pinhole;
  return fmt::format(
      "{}, rectified to {}x{} px, {:.0f} x {:.0f} deg{}", cameras, rig.width, rig.height,
      degrees(std::atan((-0.5 - K.cx) / K.fx), std::atan((rig.width - 0.5 - K.cx) / K.fx)),
      degrees(std::atan((-0.5 - K.cy) / K.fy), std::atan((rig.height - 0.5 - K.cy) / K.fy)),
      raw.has_rectified ? " as prescribed by the calibration" : "");
}

}  // namespace tolman::engine
