// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_map.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/rectified_view.hpp"

namespace tolman::engine {

namespace {

constexpr int kParts = 64;       // positions are rounded to this fraction of a pixel
constexpr int kRowsAtOnce = 32;  // rows per task
constexpr int kBlock = 64;       // pixels whose means are calculated at once

template <class Work>
void forRows(int rows, const Work& work) {
  tbb::parallel_for(tbb::blocked_range<int>(0, rows, kRowsAtOnce),
                    [&](const tbb::blocked_range<int>& range) {
                      for (int r = range.begin(); r < range.end(); ++r) work(r);
                    });
}

/// The pixel before a position; `share` is the rest in 1/kParts px.
std::uint16_t split(double at, int size, std::uint8_t& share) {
  const int parts = static_cast<int>(std::lround(at * kParts));
  const int whole = std::min(parts / kParts, size - 2);
  share = static_cast<std::uint8_t>(parts - whole * kParts);
  return static_cast<std::uint16_t>(whole);
}

/// Of two neighbours in a row, the left one in the lower byte.
std::uint16_t pairAt(const std::uint8_t* pixel, int channels) {
  return static_cast<std::uint16_t>(pixel[0] | pixel[channels] << 8);
}

/// The mean of four neighbours by the shares of the right and the lower ones. Integers of 16 bits,
/// so that the compiler calculates eight at once.
std::uint8_t meanOf(std::uint16_t above, std::uint16_t below, std::uint16_t right, int down) {
  const auto word = [](int value) { return static_cast<std::uint16_t>(value); };
  const std::uint16_t left = word(kParts - right);
  const std::uint16_t upper = word(word((above & 255) * left) + word((above >> 8) * right));
  const std::uint16_t lower = word(word((below & 255) * left) + word((below >> 8) * right));
  // (lower - upper) * down / kParts, rounded: the upper bits of the product, and its bits 5 and 6.
  const auto step = static_cast<std::int16_t>(word(lower - upper));
  const auto twice = static_cast<std::int16_t>(2 * step);
  const auto share = static_cast<std::int16_t>(down << 8);
  const std::uint16_t upper_bits = word(static_cast<std::int16_t>(twice * share >> 16));
  const std::uint16_t bits = word(word(step * down) >> 5) & 3;
  const std::uint16_t change = word(2 * upper_bits + ((bits + 1) >> 1));
  return static_cast<std::uint8_t>(word(upper + change + kParts / 2) >> 6);
}

}  // namespace

PixelMap::PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
                   const CameraRig& rectified)
    : raw_width_(raw.width),
      raw_height_(raw.height),
      width_(rectified.width),
      height_(rectified.height),
      pixels_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)),
      right_(pixels_.size(), kNowhere),
      below_(pixels_.size(), 0) {
  const Lens lens(raw);
  const Eigen::Matrix3d R_raw_rectified = R_rectified_raw.transpose();
  forRows(height_, [&](int r) {
    std::size_t i = firstOf(r);
    for (int c = 0; c < width_; ++c, ++i) {
      const auto at = lens.pixelOf(R_raw_rectified * rectified.pinhole.ray({c, r}));
      if (!at) continue;
      pixels_[i] = {split(at->x(), raw_width_, right_[i]), split(at->y(), raw_height_, below_[i])};
    }
  });
}

/// The pixels are gathered in blocks, since only the means of a block are calculated at once.
template <int Channels>
void PixelMap::interpolateRow(const Image& raw, int row, std::uint8_t* out) const {
  std::array<std::uint16_t, kBlock> above{};
  std::array<std::uint16_t, kBlock> below{};
  for (int c = 0; c < width_; c += kBlock, out += kBlock * Channels) {
    const auto count = static_cast<std::size_t>(std::min(kBlock, width_ - c));
    const std::size_t first = firstOf(row) + static_cast<std::size_t>(c);
    const std::uint8_t* right = right_.data() + first;
    const std::uint8_t* down = below_.data() + first;
    for (int k = 0; k < Channels; ++k) {
      for (std::size_t i = 0; i < count; ++i) {
        const auto& [x, y] = pixels_[first + i];
        const std::uint8_t* at = raw.data() + y * raw.stride() + x * Channels + k;
        above[i] = pairAt(at, Channels);
        below[i] = pairAt(at + raw.stride(), Channels);
      }
      for (std::size_t i = 0; i < count; ++i) {
        const std::uint8_t mean = meanOf(above[i], below[i], right[i], down[i]);
        out[i * Channels + static_cast<std::size_t>(k)] =
            right[i] == kNowhere ? std::uint8_t{0} : mean;
      }
    }
  }
}

Image PixelMap::apply(const Image& raw) const {
  if (raw.width() != raw_width_ || raw.height() != raw_height_) return {};
  const bool is_grey = raw.format() == PixelFormat::Gray8;
  return Image::create(width_, height_, raw.format(), [&](std::uint8_t* pixels) {
    const std::ptrdiff_t stride = std::ptrdiff_t{width_} * bytesPerPixel(raw.format());
    forRows(height_, [&](int r) {
      std::uint8_t* out = pixels + r * stride;
      is_grey ? interpolateRow<1>(raw, r, out) : interpolateRow<3>(raw, r, out);
    });
  });
}

void PixelMap::apply(NamedArray& values) const {
  const auto all = static_cast<std::size_t>(raw_width_) * static_cast<std::size_t>(raw_height_);
  if (values.shape != std::vector<int>{raw_height_, raw_width_} || values.values.size() != all) {
    return;
  }
  NamedArray made{values.name, {height_, width_}, {}};
  made.values.reserve(pixels_.size());
  for (std::size_t i = 0; i < pixels_.size(); ++i) {
    const int x = pixels_[i].x + (right_[i] >= kParts / 2 ? 1 : 0);
    const int y = pixels_[i].y + (below_[i] >= kParts / 2 ? 1 : 0);
    const auto nearest = static_cast<std::size_t>(y) * static_cast<std::size_t>(raw_width_) +
                         static_cast<std::size_t>(x);
    made.values.push_back(right_[i] == kNowhere ? 0 : values.values[nearest]);
  }
  values = std::move(made);
}

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
