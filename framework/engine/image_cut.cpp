// SPDX-License-Identifier: BSD-3-Clause
#include "engine/image_cut.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace tolman::engine {
namespace {

constexpr int kMinCutSide = 32;     // px, least width and height of an image
constexpr int kCutRowsAtOnce = 16;  // rows per task

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

int centreOf(const PixelMeans::Span& span) { return span.first + span.count / 2; }

/// Weighted sums over the rows that a new row covers, in 1/2^kBits of a grey level.
void sumRows(const Image& image, const PixelMeans& rows, int row,
             std::vector<std::uint32_t>& sums) {
  const PixelMeans::Span& span = rows.spanOf(row);
  std::ranges::fill(sums, 0U);
  for (int k = 0; k < span.count; ++k) {
    const std::uint8_t* pixels = image.row(span.first + k);
    const std::uint32_t weight = rows.weight(span.weights + static_cast<std::size_t>(k));
    for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += weight * pixels[i];
  }
}

void meanRow(const std::vector<std::uint32_t>& sums, const PixelMeans& columns, int channels,
             std::uint8_t* out) {
  constexpr int kBits = 2 * PixelMeans::kBits;
  for (int c = 0; c < columns.size(); ++c) {
    const PixelMeans::Span& span = columns.spanOf(c);
    for (int channel = 0; channel < channels; ++channel) {
      std::uint32_t sum = 1U << (kBits - 1U);
      auto at = static_cast<std::size_t>(span.first * channels + channel);
      for (int k = 0; k < span.count; ++k, at += static_cast<std::size_t>(channels)) {
        sum += columns.weight(span.weights + static_cast<std::size_t>(k)) * sums[at];
      }
      *out++ = static_cast<std::uint8_t>(sum >> static_cast<unsigned>(kBits));
    }
  }
}

}  // namespace

PixelMeans::PixelMeans(int from, int to) {
  const double covered = static_cast<double>(from) / to;  // px
  for (int i = 0; i < to; ++i) {
    const double begin = i * covered;
    const double end = std::min<double>(from, begin + covered);
    Span span{static_cast<int>(begin), weights_.size(), 0};
    std::int64_t left = std::int64_t{1} << kBits;
    for (int pixel = span.first; pixel < end - 1e-9; ++pixel, ++span.count) {
      const double part = std::min<double>(end, pixel + 1) - std::max<double>(begin, pixel);
      const auto weight = static_cast<std::int64_t>(std::lround(part / covered * (1 << kBits)));
      weights_.push_back(static_cast<std::uint32_t>(std::min(weight, left)));
      left -= weights_.back();
    }
    // Rounded weights may not add up to 2^kBits; the one in the middle gets the rest.
    weights_[span.weights + static_cast<std::size_t>(span.count / 2)] +=
        static_cast<std::uint32_t>(left);
    spans_.push_back(span);
  }
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
  cut.width_ = rig.width;
  cut.height_ = rig.height;
  if (!crop.empty()) {
    if (const Status status = checkCrop(rig, crop); !status.isOk()) return status;
    cut.left_ = static_cast<int>(crop[0]);
    cut.top_ = static_cast<int>(crop[1]);
    cut.width_ = static_cast<int>(crop[2]);
    cut.height_ = static_cast<int>(crop[3]);
  }
  CameraRig& made = cut.rig_;
  made.width = static_cast<int>(std::lround(cut.width_ * scale));
  made.height = static_cast<int>(std::lround(cut.height_ * scale));
  if (made.width < kMinCutSide || made.height < kMinCutSide) {
    return Status::invalidParameter(
        fmt::format("images.scale {} makes images of {}x{} px of {}x{}; at least 32 px a side are "
                    "needed",
                    scale, made.width, made.height, cut.width_, cut.height_));
  }
  cut.is_whole_ = made.width == rig.width && made.height == rig.height;
  if (rig.calibrated) {
    follow(made.pinhole.fx, made.pinhole.cx, cut.left_, cut.width_, made.width);
    follow(made.pinhole.fy, made.pinhole.cy, cut.top_, cut.height_, made.height);
  }
  cut.columns_ = PixelMeans(cut.width_, made.width);
  cut.rows_ = PixelMeans(cut.height_, made.height);
  return cut;
}

std::string ImageCut::text() const {
  if (is_whole_) return "";
  std::string text;
  if (width_ != old_.width || height_ != old_.height) {
    text = fmt::format("{}x{} px at ({}, {}) of {}x{} px", width_, height_, left_, top_, old_.width,
                       old_.height);
  }
  if (rig_.width == width_ && rig_.height == height_) return text;
  if (text.empty()) text = fmt::format("{}x{} px", width_, height_);
  return text + fmt::format(", scaled to {}x{} px", rig_.width, rig_.height);
}

Image ImageCut::apply(const Image& image) const {
  if (is_whole_ || image.width() != old_.width || image.height() != old_.height) return image;
  const int channels = bytesPerPixel(image.format());
  const Image part(image.row(top_) + std::ptrdiff_t{left_} * channels, width_, height_,
                   image.stride(), image.format(), image.owner());
  if (rig_.width == width_ && rig_.height == height_) return part;
  return Image::create(rig_.width, rig_.height, image.format(), [&](std::uint8_t* pixels) {
    const std::ptrdiff_t stride = std::ptrdiff_t{rig_.width} * channels;
    const auto work = [&](const tbb::blocked_range<int>& range) {
      std::vector<std::uint32_t> sums(static_cast<std::size_t>(width_ * channels));
      for (int r = range.begin(); r < range.end(); ++r) {
        sumRows(part, rows_, r, sums);
        meanRow(sums, columns_, channels, pixels + r * stride);
      }
    };
    tbb::parallel_for(tbb::blocked_range<int>(0, rig_.height, kCutRowsAtOnce), work);
  });
}

void ImageCut::apply(NamedArray& values) const {
  const auto all = static_cast<std::size_t>(old_.width) * static_cast<std::size_t>(old_.height);
  if (is_whole_ || values.shape != std::vector<int>{old_.height, old_.width} ||
      values.values.size() != all) {
    return;
  }
  NamedArray made{values.name, {rig_.height, rig_.width}, {}};
  made.values.reserve(static_cast<std::size_t>(rig_.width) * static_cast<std::size_t>(rig_.height));
  for (int r = 0; r < rig_.height; ++r) {
    const int row = top_ + centreOf(rows_.spanOf(r));
    for (int c = 0; c < rig_.width; ++c) {
      const int at = row * old_.width + left_ + centreOf(columns_.spanOf(c));
      made.values.push_back(values.values[static_cast<std::size_t>(at)]);
    }
  }
  values = std::move(made);
}

}  // namespace tolman::engine
