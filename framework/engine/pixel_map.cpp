// SPDX-License-Identifier: BSD-3-Clause
#include "engine/pixel_map.hpp"

#include <fmt/format.h>
#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/rectified_view.hpp"

#ifdef __x86_64__
#include <immintrin.h>
#endif

namespace tolman::engine {

namespace {

constexpr int kGroup = 8;
constexpr int kColumns = 16;         // most columns of the raw image for one group
constexpr int kMaxRows = 8;          // with more rows, one pixel at a time is faster
constexpr std::uint8_t kNone = 128;  // a column with the value 0

template <int Channels>
void interpolatePositions(const Image& raw, std::span<const RawPosition> positions,
                          std::uint8_t* out) {
  const std::uint8_t* const data = raw.data();
  const std::ptrdiff_t stride = raw.stride();
  for (const RawPosition& position : positions) {
    if (position.right != RawPosition::kNowhere) {
      const std::uint8_t* above = data + position.y * stride + position.x * Channels;
      const std::uint8_t* below = above + stride;
      for (int k = 0; k < Channels; ++k) {
        const int upper =
            above[k] * (kParts - position.right) + above[k + Channels] * position.right;
        const int lower =
            below[k] * (kParts - position.right) + below[k + Channels] * position.right;
        const int down = ((lower - upper) * position.below + kParts / 2) >> 6;
        out[k] = static_cast<std::uint8_t>((upper + down + kParts / 2) >> 6);
      }
    }
    out += Channels;
  }
}

#ifdef __x86_64__

[[gnu::target("sse4.1")]] inline __m128i load8(const std::uint8_t* from) {
  return _mm_loadl_epi64(reinterpret_cast<const __m128i*>(from));
}

[[gnu::target("sse4.1")]] inline __m128i load16(const std::uint8_t* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// Selects the pairs of columns from each raw row, and keeps them in the lanes that use this row.
[[gnu::target("sse4.1")]] inline __m128i interpolateGroup(const PixelGroup& group,
                                                          const std::uint8_t* row,
                                                          std::ptrdiff_t stride) {
  const __m128i columns = load8(group.column);
  const __m128i pairs = _mm_unpacklo_epi8(columns, _mm_add_epi8(columns, _mm_set1_epi8(1)));
  const __m128i rows = _mm_unpacklo_epi8(load8(group.row), load8(group.row));
  __m128i above = _mm_shuffle_epi8(load16(row), pairs);
  __m128i below = _mm_shuffle_epi8(load16(row += stride), pairs);
  __m128i last = below;
  for (std::uint32_t r = 1; r < group.rows; ++r) {
    const __m128i next = _mm_shuffle_epi8(load16(row += stride), pairs);
    const __m128i here = _mm_cmpeq_epi8(rows, _mm_set1_epi8(static_cast<char>(r)));
    above = _mm_blendv_epi8(above, last, here);
    below = _mm_blendv_epi8(below, next, here);
    last = next;
  }
  const __m128i right = load8(group.right);
  const __m128i shares = _mm_unpacklo_epi8(_mm_sub_epi8(_mm_set1_epi8(kParts), right), right);
  const __m128i upper = _mm_maddubs_epi16(above, shares);
  const __m128i lower = _mm_maddubs_epi16(below, shares);
  // The product of mulhrs is divided by 2^15 and rounded: 2 * difference * (share * 2^8).
  const __m128i share = _mm_unpacklo_epi8(_mm_setzero_si128(), load8(group.below));
  const __m128i difference = _mm_sub_epi16(lower, upper);
  const __m128i down = _mm_mulhrs_epi16(_mm_add_epi16(difference, difference), share);
  const __m128i sum = _mm_add_epi16(_mm_add_epi16(upper, down), _mm_set1_epi16(kParts / 2));
  return _mm_packus_epi16(_mm_srai_epi16(sum, 6), _mm_setzero_si128());
}

[[gnu::target("sse4.1")]] void interpolateGroups(const Image& raw,
                                                 std::span<const RawPosition> positions,
                                                 const PixelGroup* group, std::uint8_t* out) {
  const std::size_t whole = positions.size() / kGroup * kGroup;
  for (std::size_t at = 0; at < whole; at += kGroup, ++group, out += kGroup) {
    if (group->rows == 0) {
      interpolatePositions<1>(raw, positions.subspan(at, kGroup), out);
      continue;
    }
    const __m128i pixels = interpolateGroup(*group, raw.row(group->y) + group->x, raw.stride());
    _mm_storel_epi64(reinterpret_cast<__m128i*>(out), pixels);
  }
  interpolatePositions<1>(raw, positions.subspan(whole), out);
}

#endif

PixelGroup groupOf(std::span<const RawPosition> positions, int raw_width) {
  int x = raw_width;
  int y = 65536;
  int x_end = 0;
  int y_end = 0;
  for (const RawPosition& position : positions) {
    if (position.right == RawPosition::kNowhere) continue;
    x = std::min<int>(x, position.x);
    y = std::min<int>(y, position.y);
    x_end = std::max(x_end, position.x + 2);
    y_end = std::max(y_end, position.y + 1);
  }
  x = std::max(0, std::min(x, raw_width - kColumns));
  PixelGroup group;
  if (x_end <= x || x_end - x > kColumns || x + kColumns > raw_width || y_end - y > kMaxRows) {
    return group;
  }
  group.x = static_cast<std::uint16_t>(x);
  group.y = static_cast<std::uint16_t>(y);
  group.rows = static_cast<std::uint32_t>(y_end - y);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const RawPosition& position = positions[i];
    const bool nowhere = position.right == RawPosition::kNowhere;
    group.column[i] = nowhere ? kNone : static_cast<std::uint8_t>(position.x - x);
    group.row[i] = nowhere ? std::uint8_t{0} : static_cast<std::uint8_t>(position.y - y);
    group.right[i] = nowhere ? std::uint8_t{0} : position.right;
    group.below[i] = position.below;
  }
  return group;
}

}  // namespace

void groupPositions(std::span<const RawPosition> positions, int raw_width, PixelGroup* groups) {
  for (; positions.size() >= kGroup; positions = positions.subspan(kGroup)) {
    *groups++ = groupOf(positions.first(kGroup), raw_width);
  }
}

bool hasGroupInstructions() {
#ifdef __x86_64__
  return __builtin_cpu_supports("sse4.1");
#else
  return false;
#endif
}

void interpolateRow(const Image& raw, std::span<const RawPosition> positions,
                    [[maybe_unused]] const PixelGroup* groups, std::uint8_t* out) {
  if (raw.format() != PixelFormat::Gray8) return interpolatePositions<3>(raw, positions, out);
#ifdef __x86_64__
  if (groups != nullptr) return interpolateGroups(raw, positions, groups, out);
#endif
  interpolatePositions<1>(raw, positions, out);
}

namespace {

constexpr int kRowsAtOnce = 32;  // rows per task

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

}  // namespace

PixelMap::PixelMap(const RawCamera& raw, const Eigen::Matrix3d& R_rectified_raw,
                   const CameraRig& rectified, Speed speed)
    : raw_width_(raw.width),
      raw_height_(raw.height),
      width_(rectified.width),
      height_(rectified.height),
      positions_(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_)) {
  const bool grouped = speed == Speed::Fastest && hasGroupInstructions();
  if (grouped) groups_.resize(firstGroup(height_));
  const Lens lens(raw);
  const Eigen::Matrix3d R_raw_rectified = R_rectified_raw.transpose();
  forRows(height_, [&](int r) {
    RawPosition* position = positions_.data() + std::ptrdiff_t{r} * width_;
    for (int c = 0; c < width_; ++c, ++position) {
      const auto pixel = lens.pixelOf(R_raw_rectified * rectified.pinhole.ray({c, r}));
      if (!pixel) continue;
      position->x = split(pixel->x(), raw_width_, position->right);
      position->y = split(pixel->y(), raw_height_, position->below);
    }
    if (grouped) groupPositions(positionsOf(r), raw_width_, groups_.data() + firstGroup(r));
  });
}

std::span<const RawPosition> PixelMap::positionsOf(int row) const {
  const auto width = static_cast<std::size_t>(width_);
  return std::span(positions_).subspan(static_cast<std::size_t>(row) * width, width);
}

Image PixelMap::apply(const Image& raw) const {
  if (raw.width() != raw_width_ || raw.height() != raw_height_) return {};
  return Image::create(width_, height_, raw.format(), [&](std::uint8_t* pixels) {
    const std::ptrdiff_t stride = std::ptrdiff_t{width_} * bytesPerPixel(raw.format());
    forRows(height_, [&](int r) {
      const PixelGroup* groups = groups_.empty() ? nullptr : groups_.data() + firstGroup(r);
      interpolateRow(raw, positionsOf(r), groups, pixels + r * stride);
    });
  });
}

void PixelMap::apply(NamedArray& values) const {
  const auto all = static_cast<std::size_t>(raw_width_) * static_cast<std::size_t>(raw_height_);
  if (values.shape != std::vector<int>{raw_height_, raw_width_} || values.values.size() != all) {
    return;
  }
  NamedArray made{values.name, {height_, width_}, {}};
  made.values.reserve(positions_.size());
  for (const RawPosition& position : positions_) {
    const int x = position.x + (position.right >= kParts / 2 ? 1 : 0);
    const int y = position.y + (position.below >= kParts / 2 ? 1 : 0);
    made.values.push_back(
        position.right == RawPosition::kNowhere
            ? 0
            : values.values[static_cast<std::size_t>(y) * static_cast<std::size_t>(raw_width_) +
                            static_cast<std::size_t>(x)]);
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
