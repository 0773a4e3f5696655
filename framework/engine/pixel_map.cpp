// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "engine/rectified_view.hpp"
#include "tolman/image_cv.hpp"

namespace tolman::engine {

namespace {

constexpr int kMinCutSide = 32;  // px, least width and height of an image

/// Whether an array has a value for each pixel of such images.
bool isPlane(const NamedArray& values, cv::Size size) {
  return values.shape == std::vector<int>{size.height, size.width} &&
         values.values.size() == static_cast<std::size_t>(size.area());
}

/// A view of its values.
cv::Mat planeOf(NamedArray& values, cv::Size size) { return {size, CV_32F, values.values.data()}; }

NamedArray arrayOf(const std::string& name, const cv::Mat& plane) {
  return {name, {plane.rows, plane.cols}, {plane.begin<float>(), plane.end<float>()}};
}

Status cropProblem(const CameraRig& rig, const std::string& what) {
  return Status::invalidParameter(
      fmt::format("images.crop {}; the images have {}x{} px: give [left, top, width, height], at "
                  "least 32 px a side",
                  what, rig.width, rig.height));
}

Status checkCrop(const CameraRig& rig, const std::vector<double>& crop) {
  if (crop.size() != 4) {
    return cropProblem(rig, fmt::format("has {} numbers", crop.size()));
  }
  const bool whole = std::ranges::all_of(crop, [](double v) { return v == std::floor(v); });
  if (!whole) return cropProblem(rig, "has fractions of pixels");
  const bool inside = crop[0] >= 0 && crop[1] >= 0 && crop[2] >= kMinCutSide &&
                      crop[3] >= kMinCutSide && crop[0] + crop[2] <= rig.width &&
                      crop[1] + crop[3] <= rig.height;
  return inside ? Status::ok() : cropProblem(rig, "is not inside of the images");
}

/// Adapts one axis of a pinhole to a crop that begins at pixel `left`, then to scaling from `from`
/// to `to` px. Pixel centres are at integers, so the border of an image is at -0.5.
void follow(double& focal, double& centre, int left, int from, int to) {
  const double scale = static_cast<double>(to) / from;
  focal *= scale;
  centre = to == from ? centre - left : (centre - left + 0.5) * scale - 0.5;
}

/// Fills what is not known from the image of half the size, which is filled likewise.
void fillHidden(cv::Mat& pixels, const cv::Mat& known) {
  const cv::Mat hidden = known == 0;
  if (cv::countNonZero(hidden) == 0) return;
  const cv::Size half((pixels.cols + 1) / 2, (pixels.rows + 1) / 2);
  cv::Mat shares;
  known.convertTo(shares, CV_32F, 1.0 / 255);
  cv::resize(shares, shares, half, 0, 0, cv::INTER_AREA);
  cv::Mat means = pixels.clone();
  means.setTo(0, hidden);
  cv::resize(means, means, half, 0, 0, cv::INTER_AREA);
  cv::Mat divisors;
  const cv::Mat above_zero = cv::max(shares, 1e-6);
  cv::merge(std::vector<cv::Mat>(static_cast<std::size_t>(pixels.channels()), above_zero),
            divisors);
  cv::divide(means, divisors, means);
  fillHidden(means, shares > 0);
  cv::resize(means, means, pixels.size(), 0, 0, cv::INTER_LINEAR);
  means.copyTo(pixels, hidden);
}

}  // namespace

Result<ImageMask> ImageMask::create(const CameraRig& rig, const std::vector<double>& rectangles) {
  ImageMask mask;
  if (rectangles.empty()) return mask;
  mask.known_ = cv::Mat(rig.height, rig.width, CV_8U, cv::Scalar(255));
  for (std::size_t i = 0; i + 4 <= rectangles.size(); i += 4) {
    const double right = rectangles[i] + rectangles[i + 2];
    const double bottom = rectangles[i + 1] + rectangles[i + 3];
    if (right > rig.width || bottom > rig.height) {
      return Status::invalidParameter(
          fmt::format("images.mask has a rectangle outside of the images of {}x{} px; correct it",
                      rig.width, rig.height));
    }
    const cv::Point first(static_cast<int>(rectangles[i]), static_cast<int>(rectangles[i + 1]));
    const cv::Point beyond(static_cast<int>(std::ceil(right)), static_cast<int>(std::ceil(bottom)));
    mask.known_(cv::Rect(first, beyond)).setTo(0);
  }
  if (rectangles.size() % 4 == 0 && cv::countNonZero(mask.known_) > 0) return mask;
  return Status::invalidParameter(
      "images.mask is not a list of left, top, width, height of rectangles that leave a part of "
      "the images; correct it");
}

Image ImageMask::apply(const Image& image) const {
  if (isEmpty() || image.width() != known_.cols || image.height() != known_.rows) return image;
  cv::Mat pixels;
  asMat(image).convertTo(pixels, CV_32F);
  fillHidden(pixels, known_);
  pixels.convertTo(pixels, CV_8U);
  return asImage(pixels);
}

PixelMap::PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
                   const CameraRig& rectified)
    : raw_size_(raw.width, raw.height) {
  const Lens lens(raw);
  const Eigen::Matrix3d R_raw_rectified = R_rectified_raw.transpose();
  cv::Mat positions(rectified.height, rectified.width, CV_32FC2);
  cv::parallel_for_(cv::Range(0, rectified.height), [&](const cv::Range& rows) {
    for (int r = rows.start; r < rows.end; ++r) {
      for (int c = 0; c < rectified.width; ++c) {
        const auto at = lens.pixelOf(R_raw_rectified * rectified.pinhole.ray({c, r}))
                            .value_or(Eigen::Vector2d(-2, -2));  // outside: black
        positions.at<cv::Vec2f>(r, c) = cv::Vec2d(at.x(), at.y());
      }
    }
  });
  cv::convertMaps(positions, cv::Mat(), pixels_, shares_, CV_16SC2);
  positions.convertTo(nearest_, CV_16S);
}

Image PixelMap::apply(const Image& raw) const {
  if (raw.width() != raw_size_.width || raw.height() != raw_size_.height) return {};
  cv::Mat made;
  cv::remap(asMat(raw), made, pixels_, shares_, cv::INTER_LINEAR, cv::BORDER_CONSTANT);
  return asImage(made);
}

void PixelMap::apply(NamedArray& values) const {
  if (!isPlane(values, raw_size_)) return;
  cv::Mat made;
  cv::remap(planeOf(values, raw_size_), made, nearest_, cv::Mat(), cv::INTER_NEAREST,
            cv::BORDER_CONSTANT);
  values = arrayOf(values.name, made);
}

Result<ImageCut> ImageCut::create(const CameraRig& rig, const std::vector<double>& crop,
                                  double scale) {
  ImageCut cut;
  cut.old_ = cut.rig_ = rig;
  if (crop.empty() && scale == 1) return cut;
  if (rig.width == 0) {
    return Status::invalidParameter(
        "the source gives no images to crop or to scale; leave out `images`");
  }
  cut.part_ = cv::Rect(0, 0, rig.width, rig.height);
  if (!crop.empty()) {
    if (const Status status = checkCrop(rig, crop); !status.isOk()) return status;
    cut.part_ = cv::Rect2d(crop[0], crop[1], crop[2], crop[3]);
  }
  CameraRig& made = cut.rig_;
  made.width = static_cast<int>(std::lround(cut.part_.width * scale));
  made.height = static_cast<int>(std::lround(cut.part_.height * scale));
  if (made.width < kMinCutSide || made.height < kMinCutSide) {
    return Status::invalidParameter(
        fmt::format("images.scale {} makes images of {}x{} px of {}x{}; at least 32 px a side are "
                    "needed",
                    scale, made.width, made.height, cut.part_.width, cut.part_.height));
  }
  cut.is_whole_ = made.width == rig.width && made.height == rig.height;
  if (rig.calibrated) {
    follow(made.pinhole.fx, made.pinhole.cx, cut.part_.x, cut.part_.width, made.width);
    follow(made.pinhole.fy, made.pinhole.cy, cut.part_.y, cut.part_.height, made.height);
  }
  return cut;
}

std::string ImageCut::text() const {
  if (is_whole_) return "";
  std::string text;
  if (part_.width != old_.width || part_.height != old_.height) {
    text = fmt::format("{}x{} px at ({}, {}) of {}x{} px", part_.width, part_.height, part_.x,
                       part_.y, old_.width, old_.height);
  }
  if (!isScaled()) return text;
  if (text.empty()) text = fmt::format("{}x{} px", part_.width, part_.height);
  return text + fmt::format(", scaled to {}x{} px", rig_.width, rig_.height);
}

Image ImageCut::apply(const Image& image) const {
  if (is_whole_ || image.width() != old_.width || image.height() != old_.height) return image;
  const Image part(image.row(part_.y) + std::ptrdiff_t{part_.x} * bytesPerPixel(image.format()),
                   part_.width, part_.height, image.stride(), image.format(), image.owner());
  if (!isScaled()) return part;
  cv::Mat made;
  cv::resize(asMat(part), made, {rig_.width, rig_.height}, 0, 0, cv::INTER_AREA);
  return asImage(made);
}

void ImageCut::apply(NamedArray& values) const {
  const cv::Size size(old_.width, old_.height);
  if (is_whole_ || !isPlane(values, size)) return;
  const cv::Mat old = planeOf(values, size)(part_);
  cv::Mat made(rig_.height, rig_.width, CV_32F);
  made.forEach<float>([&](float& value, const int* at) {
    value = old.at<float>((2 * at[0] + 1) * old.rows / (2 * made.rows),
                          (2 * at[1] + 1) * old.cols / (2 * made.cols));
  });
  values = arrayOf(values.name, made);
}

}  // namespace tolman::engine
