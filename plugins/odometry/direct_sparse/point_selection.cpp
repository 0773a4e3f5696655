// SPDX-License-Identifier: BSD-3-Clause
// Thresholds of 32x32 blocks, and the strongest pixel of each cell.
#include "point_selection.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "gradient_samples.hpp"

namespace tolman::direct_sparse {
namespace {

// As in DSO (Engel et al.)
constexpr int kBlock = 32;         // px
constexpr int kCap = 48;           // grey levels / px; stronger gradients count as this value
constexpr float kAboveMedian = 7;  // grey levels / px
constexpr int kDirections = 16;
constexpr int kMedianStep = 2;  // px between the pixels of which medians are taken

/// A pseudo-random direction per cell, so that gradients of all directions are selected.
std::array<float, 2> direction(int u, int v) {
  const auto hash =
      static_cast<std::uint32_t>(u) * 73856093U ^ static_cast<std::uint32_t>(v) * 19349663U;
  const float angle = static_cast<float>((hash >> 7U) % kDirections) * 3.14159265F / kDirections;
  return {std::cos(angle), std::sin(angle)};
}

#if defined(__SSE2__)
__m128i eightShorts(const std::uint8_t* p) {
  return _mm_unpacklo_epi8(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(p)),
                           _mm_setzero_si128());
}

/// Lengths of the gradients of eight pixels, as bytes; reads one more pixel on either side.
void storeLengths(const std::uint8_t* here, const std::uint8_t* above, const std::uint8_t* below,
                  std::uint8_t* out) {
  const __m128i gx = _mm_sub_epi16(eightShorts(here + 1), eightShorts(here - 1));
  const __m128i gy = _mm_sub_epi16(eightShorts(below), eightShorts(above));
  const auto lengths = [](__m128i pairs) {
    const __m128 squared = _mm_cvtepi32_ps(_mm_madd_epi16(pairs, pairs));
    return _mm_cvttps_epi32(_mm_mul_ps(_mm_set1_ps(0.5F), _mm_sqrt_ps(squared)));
  };
  const __m128i shorts =
      _mm_packs_epi32(lengths(_mm_unpacklo_epi16(gx, gy)), lengths(_mm_unpackhi_epi16(gx, gy)));
  _mm_storel_epi64(reinterpret_cast<__m128i*>(out), _mm_packus_epi16(shorts, shorts));
}
#endif

struct Cell {
  int u_begin = 0;
  int u_end = 0;
  int v_begin = 0;
  int v_end = 0;
};

/// The pixel whose gradient is longest along a direction, and that length; 0 without one.
struct Strongest {
  Pixel pixel;
  float projection = 0;
  float largest = 0;  ///< squared differences, of any pixel of the cell or a little to its right
};

/// Of the pixels whose squared differences are at least `least`; the first of equal ones.
/// Reads up to eight pixels behind the end of a row.
TOLMAN_WIDE_LANES Strongest strongestIn(const GrayLevel& image, const Cell& cell, float least,
                                        const std::array<float, 2>& along) {
  constexpr EightInts kLane = {0, 1, 2, 3, 4, 5, 6, 7};
  const float along_u = along[0];
  const float along_v = along[1];
  Eight best{};
  Eight largest{};
  EightInts best_place{};
  for (int v = cell.v_begin; v < cell.v_end; ++v) {
    const int row = v * image.width;
    for (int u = cell.u_begin; u < cell.u_end; u += 8) {
      const std::uint8_t* p = image.pixels.data() + row + u;
      const Eight gu = differences(p + 1, p - 1);
      const Eight gv = differences(p + image.width, p - image.width);
      const Eight squared = gu * gu + gv * gv;
      largest = larger(largest, squared);
      const EightInts weak = negative(squared - least);
      const Eight sum = along_u * gu + along_v * gv;
      const Eight projection = chosen(negative(sum), -sum, sum);
      const EightInts better =
          ~weak & negative(u + kLane - cell.u_end) & negative(best - projection);
      best = chosen(better, projection, best);
      best_place = chosen(better, row + u + kLane, best_place);
    }
  }
  Strongest found;
  int place = 0;
  for (int k = 0; k < 8; ++k) {
    const bool earlier = best_place[k] < place;
    if (best[k] < found.projection || (best[k] == found.projection && !earlier)) continue;
    place = best_place[k];
    found.projection = best[k];
  }
  found.pixel = {place % image.width, place / image.width};
  for (int k = 0; k < 8; ++k) found.largest = std::max(found.largest, largest[k]);
  return found;
}

}  // namespace

void PointSelector::measure(const GrayLevel& image) {
  width_ = image.width;
  height_ = image.height;
  strength_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  tbb::parallel_for(0, (height_ + kMedianStep - 1) / kMedianStep, [&](int i) {
    const int v = kMedianStep * i;
    const bool inner = v > 0 && v < height_ - 1;
    const std::uint8_t* here = image.row(v);
    const std::uint8_t* above = inner ? image.row(v - 1) : here;
    const std::uint8_t* below = inner ? image.row(v + 1) : here;
    std::uint8_t* out = strength_.data() + static_cast<std::ptrdiff_t>(v) * width_;
    out[0] = out[width_ - 1] = 0;
    int u = 1;
#if defined(__SSE2__)
    for (; u + 8 < width_; u += 8) storeLengths(here + u, above + u, below + u, out + u);
#endif
    for (; u < width_ - 1; ++u) {
      const int gu = here[u + 1] - here[u - 1];
      const int gv = below[u] - above[u];
      out[u] = static_cast<std::uint8_t>(0.5F * std::sqrt(static_cast<float>(gu * gu + gv * gv)));
    }
  });
}

void PointSelector::findThresholds() {
  blocks_u_ = std::max(1, width_ / kBlock);
  blocks_v_ = std::max(1, height_ / kBlock);
  raw_.assign(static_cast<std::size_t>(blocks_u_ * blocks_v_), 0);
  thresholds_ = raw_;
  for (int j = 0; j < blocks_v_; ++j) {
    for (int i = 0; i < blocks_u_; ++i) {
      std::array<int, kCap + 1> histogram{};
      int count = 0;
      for (int v = j * kBlock; v < std::min((j + 1) * kBlock, height_); v += kMedianStep) {
        const std::uint8_t* row = strength_.data() + static_cast<std::ptrdiff_t>(v) * width_;
        for (int u = i * kBlock; u < std::min((i + 1) * kBlock, width_);
             u += kMedianStep, ++count) {
          ++histogram[static_cast<std::size_t>(std::min<int>(row[u], kCap))];
        }
      }
      int median = 0;
      for (int below = histogram[0]; 2 * below < count;) {
        below += histogram[static_cast<std::size_t>(++median)];
      }
      raw_[static_cast<std::size_t>(j * blocks_u_ + i)] = static_cast<float>(median) + kAboveMedian;
    }
  }
  for (int j = 0; j < blocks_v_; ++j) {
    for (int i = 0; i < blocks_u_; ++i) {
      float sum = 0;
      float count = 0;
      for (int y = std::max(0, j - 1); y <= std::min(blocks_v_ - 1, j + 1); ++y) {
        for (int x = std::max(0, i - 1); x <= std::min(blocks_u_ - 1, i + 1); ++x, ++count) {
          sum += raw_[static_cast<std::size_t>(y * blocks_u_ + x)];
        }
      }
      thresholds_[static_cast<std::size_t>(j * blocks_u_ + i)] = sum / count;
    }
  }
}

float PointSelector::thresholdAt(int u, int v) const {
  const int i = std::min(u / kBlock, blocks_u_ - 1);
  const int j = std::min(v / kBlock, blocks_v_ - 1);
  return thresholds_[static_cast<std::size_t>(j * blocks_u_ + i)];
}

float PointSelector::pickFromCell(const GrayLevel& image, int u0, int v0, int size, int border,
                                  float relax, float most) {
  const int u_begin = std::max(u0, border);
  const int v_begin = std::max(v0, border);
  const int u_end = std::min(u0 + size, width_ - border);
  const int v_end = std::min(v0 + size, height_ - border);
  if (u_begin >= u_end || v_begin >= v_end) return 0;
  const float threshold = relax * thresholdAt((u_begin + u_end) / 2, (v_begin + v_end) / 2);
  // Lengths rounded down must exceed the threshold: the same condition for squared differences,
  // which are twice the gradient.
  const float limit = std::floor(threshold) + 1;
  const float least = 4 * limit * limit;
  if (most < least) return most;
  const Strongest found =
      strongestIn(image, {u_begin, u_end, v_begin, v_end}, least, direction(u0, v0));
  if (found.projection > 0) pixels_.push_back(found.pixel);
  return found.largest;
}

void PointSelector::pickFromCells(const GrayLevel& image, int border) {
  pixels_.clear();
  constexpr float kRelax = 0.75F;  // for each doubling; as in DSO
  constexpr float kAny = std::numeric_limits<float>::max();
  const int large = 4 * cell_;
  for (int v = 0; v < height_; v += large) {
    for (int u = 0; u < width_; u += large) {
      const std::size_t before = pixels_.size();
      float most = 0;
      for (int j = 0; j < 4; j += 2) {
        for (int i = 0; i < 4; i += 2) {
          const std::size_t before_middle = pixels_.size();
          float most_middle = 0;
          for (int k = 0; k < 4; ++k) {
            const float largest = pickFromCell(image, u + (i + k % 2) * cell_,
                                               v + (j + k / 2) * cell_, cell_, border, 1, kAny);
            most_middle = std::max(most_middle, largest);
          }
          most = std::max(most, most_middle);
          if (pixels_.size() > before_middle) continue;
          pickFromCell(image, u + i * cell_, v + j * cell_, 2 * cell_, border, kRelax, most_middle);
        }
      }
      if (pixels_.size() == before) pickFromCell(image, u, v, large, border, kRelax * kRelax, most);
    }
  }
}

const std::vector<Pixel>& PointSelector::select(const GrayLevel& image, int wanted, int border) {
  measure(image);
  findThresholds();
  if (cell_ == 0) {
    const double area = static_cast<double>(width_) * height_ / std::max(1, wanted);
    cell_ = std::max(2, static_cast<int>(0.7 * std::sqrt(area)));  // a first guess
  }
  for (int attempt = 0; attempt < 3; ++attempt) {  // bounds the time
    pickFromCells(image, border);
    const double ratio = static_cast<double>(pixels_.size()) / wanted;
    if (ratio > 0.8 && ratio < 1.5) break;  // chosen, not tuned
    // The number of pixels is proportional to 1 / (cell + 1)^2.
    const int better = static_cast<int>(std::lround((cell_ + 1) * std::sqrt(ratio))) - 1;
    const int next = std::clamp(better, 2, 64);  // px; chosen, not tuned
    if (next == cell_) break;
    cell_ = next;
    if (attempt > 0) break;  // used from the next keyframe on
  }
  return pixels_;
}

}  // namespace tolman::direct_sparse
