// SPDX-License-Identifier: BSD-3-Clause
#include "engine/camera_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "tolman/image_cv.hpp"

namespace tolman::engine {

namespace {

constexpr double kNearest = 0.01;  // m, of two cameras
constexpr double kWidest = 10;     // m
/// Lenses are centred within a few percent; images cut at one side are within a quarter.
constexpr double kOffCentre = 0.25;
constexpr double kSquare = 1.05;  // KITTI, EuRoC and TUM-VI: 1.00 to 1.003; not tuned
// Rectified images of wider lenses are cut, since their edges would be stretched threefold.
constexpr double kWidestRectified = 115;  // degrees
constexpr double kWidestRaw = 160;        // degrees; of a lens with radial distortion
constexpr double kNarrowest = 3;          // degrees

/// `whose` begins with a space.
void checkPinhole(const Pinhole& K, int width, int height, double widest, const std::string& whose,
                  std::vector<std::string>& doubts) {
  if (width <= 0 || height <= 0 || !(K.fx > 0) || !(K.fy > 0)) return;
  if (std::abs(K.cx / width - 0.5) > kOffCentre || std::abs(K.cy / height - 0.5) > kOffCentre) {
    doubts.push_back(fmt::format(
        "the principal point{} ({:.1f}, {:.1f}) is far from the middle of the {}x{} image; were "
        "the images resized after the calibration? Then scale fx, fy, cx, cy as well",
        whose, K.cx, K.cy, width, height));
  }
  const double half = std::max(width / K.fx, height / K.fy) / 2;
  const double degrees = 2 * std::atan(half) * 180 / std::numbers::pi;
  if (degrees < kNarrowest || degrees > widest) {
    doubts.push_back(fmt::format(
        "the focal length{} ({:.1f}, {:.1f}) gives the {}x{} image a view of {:.0f} degrees, which "
        "such cameras do not have; is it that of these images, in pixels? Depths and paths are "
        "wrong by its error",
        whose, K.fx, K.fy, width, height, degrees));
  }
  if (std::max(K.fx, K.fy) > kSquare * std::min(K.fx, K.fy)) {
    doubts.push_back(fmt::format(
        "the focal lengths{} are {:.5g} px horizontally and {:.5g} px vertically, and pixels of "
        "cameras are nearly square: if the images were not resized by different factors in the two "
        "directions, correct fx or fy in the calibration",
        whose, K.fx, K.fy));
  }
}

}  // namespace

std::vector<std::string> cameraDoubts(const RawRig& raw, const CameraRig& rectified) {
  std::vector<std::string> doubts;
  if (rectified.isStereo() && (rectified.baseline < kNearest || rectified.baseline > kWidest)) {
    doubts.push_back(fmt::format(
        "the two cameras are {:.4g} m apart, and usual pairs 0.01 to 10 m; all lengths of the run "
        "are in this unit: if they are not that far apart, correct the baseline (in metres, not mm "
        "or cm) in the calibration or in the source's parameters",
        rectified.baseline));
  }
  for (std::size_t i = 0; i < raw.cameras.size(); ++i) {
    const RawCamera& camera = raw.cameras[i];
    const bool is_wide =
        camera.model == LensModel::Equidistant || camera.model == LensModel::Omnidirectional;
    const char* whose = raw.cameras.size() < 2 ? ""
                        : i == 0               ? " of the left camera"
                                               : " of the right camera";
    checkPinhole(camera.pinhole, camera.width, camera.height, is_wide ? 360 : kWidestRaw, whose,
                 doubts);
  }
  if (raw.cameras.empty() && rectified.calibrated) {
    checkPinhole(rectified.pinhole, rectified.width, rectified.height, kWidestRectified, "",
                 doubts);
  }
  return doubts;
}

bool isNearlyBlack(const Image& image) {
  constexpr int kQuarter = 64;
  constexpr std::size_t kShare = 10'000;
  if (image.empty()) return false;
  const cv::Mat values = asMat(image).reshape(1);
  return static_cast<std::size_t>(cv::countNonZero(values >= kQuarter)) <= values.total() / kShare;
}

std::optional<Finding> Alternation::add(const Image& image) {
  constexpr std::size_t kJudged = 24;  // images; by chance one in eight million alternates so long
  constexpr double kLeast = 0.02;      // of the texture; chosen
  if (image.width() < 2 || textures_.size() >= kJudged) return std::nullopt;
  const cv::Mat pixels = asMat(image);
  textures_.push_back(
      cv::norm(pixels.colRange(1, pixels.cols), pixels.colRange(0, pixels.cols - 1), cv::NORM_L1));
  if (textures_.size() < kJudged) return std::nullopt;
  double less = 0;  // of the odd images, in sum
  double all = 0;
  for (std::size_t i = 1; i + 1 < kJudged; ++i) {
    const double around = (textures_[i - 1] + textures_[i + 1]) / 2;
    const double step = (i % 2 == 1 ? 1 : -1) * (around - textures_[i]);
    if (less * step < 0) return std::nullopt;
    less += step;
    all += textures_[i];
  }
  if (std::abs(less) <= kLeast * all) return std::nullopt;
  return Finding{Finding::Severity::Warning, "images",
                 "every second one has more texture, as of a projector that blinks "
                 "(emitter_on_off): its dots stand still in the camera",
                 fmt::format("use the others: add {} to source.first, and set source.step to 2",
                             less > 0 ? 1 : 0),
                 Finding::Kind::Unusual};
}

namespace {

// Measuring a pair takes 5 ms, so only every fifth frame is measured; every frame during a fault.
constexpr int kMeasuredEvery = 5;  // frames
constexpr int kCertain = 12;       // matches; with fewer, two measures must find the same fault
constexpr double kTurns = 2;       // px between two frames; chosen, not tuned
constexpr int kSoundAgain = 5;     // measures without a fault, in succession, that end it

/// The value that `share` of the values do not exceed; there must be one.
double quantile(std::vector<double> values, double share) {
  const auto nth =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

/// Whether two images have the same pixels, and not one grey level alone. Two exposures of a real
/// camera never have, because of noise; a covered camera or darkness gives such images again and
/// again, which odometry detects.
bool isRepeated(const Image& a, const Image& b) {
  if (a.empty() || a.width() != b.width() || a.height() != b.height() || a.format() != b.format()) {
    return false;
  }
  const auto bytes = std::ptrdiff_t{a.width()} * bytesPerPixel(a.format());
  bool is_uniform = true;
  for (int r = 0; r < a.height(); ++r) {
    const std::uint8_t* row = a.row(r);
    if (!std::equal(row, row + bytes, b.row(r))) return false;
    is_uniform = is_uniform && std::count(row, row + bytes, a.row(0)[0]) == bytes;
  }
  return !is_uniform;
}

}  // namespace

/// Whether the right image belongs to the left one of the frame before. Where the camera turns to
/// one side, a late image looks as if both were exchanged and fits the left one before it. To the
/// other side both fit: then what was seen in a turn to the first side decides, unless the rows of
/// the pair itself agree better.
bool FrameCheck::isLate(const StereoMeasure& measure, const cv::Mat& right) {
  const StereoFault now = faultOf(measure);
  if (left_.empty() || (now != StereoFault::Exchanged && !late_)) return false;
  const StereoMeasure before = measureStereo(halfOf(left_), right);
  if (before.matched < kCertain) return false;
  const StereoFault then = faultOf(before);
  if (now == StereoFault::Exchanged) {
    late_ = then == StereoFault::None;
    return late_;
  }
  if (then == StereoFault::Exchanged) late_ = false;
  const bool turns = std::fabs(before.to_left - measure.to_left) > kTurns;
  return late_ && turns && then == StereoFault::None && before.spread < measure.spread;
}

/// The present fault of the pair. A fault that is measured with few matches counts only if two
/// measures in succession find it. It ends after kSoundAgain measures without a fault.
StereoFault FrameCheck::stereoFault(const Frame& frame) {
  if (frame.right.empty() || until_measured_-- > 0) return fault_;
  const cv::Mat right = halfOf(frame.right);
  const StereoMeasure measure = measureStereo(halfOf(frame.left), right);
  StereoFault measured = faultOf(measure);
  const bool late = isLate(measure, right);
  if (late) measured = StereoFault::OtherTime;
  const bool certain = measure.matched >= kCertain || measured == last_measured_;
  last_measured_ = measured;
  if (measured != StereoFault::None) {
    if (certain) fault_ = measured;
    if (certain) {
      stereo_text_ = late ? "the right image belongs to the left one of the frame before; are both "
                            "exposed at the same time, and paired by their times?"
                          : faultText(measured, measure);
    }
    sound_measures_ = 0;
  } else if (++sound_measures_ >= kSoundAgain) {
    fault_ = StereoFault::None;
  }
  const bool settled = fault_ == StereoFault::None && measured == StereoFault::None && !late_;
  until_measured_ = settled ? kMeasuredEvery - 1 : 0;
  return fault_;
}

FrameCheck::Use FrameCheck::useOf(const Frame& frame, std::string& defect) {
  const bool left = isRepeated(frame.left, left_);
  const bool right = isRepeated(frame.right, right_);
  if (left || right) {
    defect = left && right ? "both images repeat those of the frame before: no new ones come"
             : left        ? "the left image repeats that of the frame before: no new one comes"
                           : "the right image repeats that of the frame before: no new one comes";
    return left ? Use::None : Use::Left;
  }
  if (isRepeated(frame.left, frame.right)) {
    defect = "the right image is the left one";
    return Use::Left;
  }
  const StereoFault fault = stereoFault(frame);
  if (fault == StereoFault::None) return Use::Both;
  defect = stereo_text_;
  return fault == StereoFault::Exchanged ? Use::None : Use::Left;
}

std::optional<std::string> FrameCheck::check(Frame& frame) {
  if (frame.left.empty()) return std::nullopt;
  std::string defect;
  const Use use = useOf(frame, defect);
  left_ = frame.left;
  right_ = frame.right;
  if (use == Use::Both) return std::nullopt;
  if (use == Use::None) {
    frame.left = frame.right = Image();
  } else {  // black, because a pair must have two images or none
    const Image& right = frame.right;
    frame.right =
        Image::create(right.width(), right.height(), right.format(), [](std::uint8_t*) {});
  }
  return frame.defect = defect;
}

namespace {

// Lengths in pixels of the half images.
const cv::Size kPatch(16, 11);
constexpr int kFarLeft = 64;   // largest disparity
constexpr int kFarRight = 16;  // largest disparity of the wrong sign
constexpr int kRows = 6;       // rows that are searched above and below
const int kBorder = kPatch.width / 2 + kRows + 1;
const cv::Size kCells(12, 5);

constexpr double kMostExchanged = 0.6;  // share of the matches

// Smaller eigenvalue of the structure tensor (Shi and Tomasi 1994): 40 grey levels^2 per pixel.
constexpr double kWeakestCorner = 40.0 / (255 * 255);
constexpr double kLeastAlike = 0.8;  // correlation
/// 1 - correlation, relative to that of any distant place; about 0.75 of the differences, squared.
constexpr double kDistinct = 0.56;

/// The strongest corner of each cell of a grid.
std::vector<cv::Point> findCorners(const cv::Mat& image) {
  constexpr int kWindow = 7;
  std::vector<cv::Point> corners;
  const cv::Size inside(image.cols - 2 * kBorder, image.rows - 2 * kBorder);
  if (inside.width < kCells.width || inside.height < kCells.height) return corners;
  cv::Mat strength;
  cv::cornerMinEigenVal(image, strength, kWindow, 1);
  for (int cell = 0; cell < kCells.area(); ++cell) {
    const cv::Point at(cell % kCells.width, cell / kCells.width);
    const auto begin = [&](int x, int y) {
      return cv::Point(kBorder + x * inside.width / kCells.width,
                       kBorder + y * inside.height / kCells.height);
    };
    const cv::Rect part(begin(at.x, at.y), begin(at.x + 1, at.y + 1));
    double most = 0;
    cv::Point best;
    cv::minMaxLoc(strength(part), nullptr, &most, nullptr, &best);
    if (most > kWeakestCorner) corners.push_back(part.tl() + best);
  }
  return corners;
}

/// How far lower and further left the corner is in the right image; none if that is ambiguous.
std::optional<cv::Point2d> findMatch(const cv::Mat& left, const cv::Point& corner,
                                     const cv::Mat& right) {
  const int begin = std::max(corner.x - kFarLeft, kPatch.width / 2);
  const int end = std::min(corner.x + kFarRight, right.cols - kPatch.width / 2);
  const cv::Point to_middle(kPatch.width / 2, kPatch.height / 2);
  const cv::Rect searched(cv::Point(begin, corner.y - kRows) - to_middle,
                          kPatch + cv::Size(end - begin, 2 * kRows));
  cv::Mat alike;
  cv::matchTemplate(right(searched), left(cv::Rect(corner - to_middle, kPatch)), alike,
                    cv::TM_CCOEFF_NORMED);
  double most = 0;
  cv::Point best;
  cv::minMaxLoc(alike, nullptr, &most, nullptr, &best);
  const bool inside =
      best.x > 0 && best.x < alike.cols - 1 && best.y > 0 && best.y < alike.rows - 1;
  if (!inside || most < kLeastAlike) return std::nullopt;
  // The maximum of a parabola through three correlations.
  const double above = alike.at<float>(best.y - 1, best.x);
  const double below = alike.at<float>(best.y + 1, best.x);
  const double curvature = above - 2 * most + below;
  const double rest = curvature < 0 ? std::clamp(0.5 * (above - below) / curvature, -0.5, 0.5) : 0;
  const cv::Rect near(best - cv::Point(2, 2), cv::Size(5, 5));
  alike(near & cv::Rect(cv::Point(), alike.size())).setTo(-1);
  double second = 0;
  cv::minMaxLoc(alike, nullptr, &second);
  if (1 - most > kDistinct * (1 - second)) return std::nullopt;
  return cv::Point2d(corner.x - begin - best.x, best.y - kRows + rest);
}

}  // namespace

cv::Mat halfOf(const Image& image) {
  const cv::Size size(image.width() / 2, image.height() / 2);
  cv::Mat half;
  if (size.empty()) return half;
  cv::Mat grey = asMat(image)(cv::Rect(0, 0, 2 * size.width, 2 * size.height));
  if (grey.channels() == 3) cv::extractChannel(grey.clone(), grey, 1);
  cv::resize(grey, half, size, 0, 0, cv::INTER_AREA);
  return half;
}

StereoMeasure measureStereo(const cv::Mat& left, const cv::Mat& right) {
  StereoMeasure measure;
  if (left.size() != right.size()) return measure;
  std::vector<double> rows;
  std::vector<double> to_left;
  int exchanged = 0;
  for (const cv::Point& corner : findCorners(left)) {
    ++measure.corners;
    const auto match = findMatch(left, corner, right);
    if (!match) continue;
    rows.push_back(2 * match->y);
    to_left.push_back(2 * match->x);
    exchanged += match->x < -1 ? 1 : 0;
  }
  measure.matched = static_cast<int>(rows.size());
  if (rows.empty()) return measure;
  measure.rows_low = quantile(rows, 0.5);
  measure.to_left = quantile(to_left, 0.5);
  measure.share_exchanged = static_cast<double>(exchanged) / measure.matched;
  for (double& row : rows) row = std::fabs(row - measure.rows_low);
  measure.spread = quantile(rows, 0.8);
  return measure;
}

/// The limits were chosen on kitti_clips/06 with synthetic faults: sound pairs have a spread of at
/// most 0.5 px, strongly blurred ones of 2.8 px, and a right image that is 0.1 s late one of 3.5
/// to 6.8 px.
StereoFault faultOf(const StereoMeasure& measure) {
  constexpr int kMin = 8;             // matches
  constexpr double kApart = 1.2;      // px
  constexpr double kScattered = 3.0;  // px
  if (measure.matched < kMin) return StereoFault::None;
  // Tested first, because on a highway a late right image also has most corners on the wrong side.
  if (measure.spread > kScattered) return StereoFault::OtherTime;
  if (measure.share_exchanged > kMostExchanged) return StereoFault::Exchanged;
  return std::fabs(measure.rows_low) > kApart ? StereoFault::RowsApart : StereoFault::None;
}

std::string faultText(StereoFault fault, const StereoMeasure& measure) {
  switch (fault) {
    case StereoFault::RowsApart:
      return fmt::format(
          "the right image is {:.1f} px {}; are the images rectified, by the "
          "calibration of these cameras?",
          std::fabs(measure.rows_low), measure.rows_low > 0 ? "low" : "high");
    case StereoFault::Exchanged:
      return "left and right image are exchanged; exchange the two folders, topics or cameras of "
             "the calibration";
    case StereoFault::OtherTime:
      return fmt::format(
          "the rows of left and right image do not belong together (differences of {:.1f} px); are "
          "both exposed at the same time, and rectified?",
          measure.spread);
    case StereoFault::None:
      break;
  }
  return "";
}

}  // namespace tolman::engine
