// SPDX-License-Identifier: BSD-3-Clause
#include "row_alignment.hpp"

#include <tbb/parallel_for.h>

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <utility>

#include "feature_guess.hpp"
#include "wide_lanes.hpp"

#if defined(__x86_64__)
#include <smmintrin.h>
#endif

namespace tolman::direct_sparse {

namespace {

constexpr int kSteps = 32;    // of a pixel
constexpr int kColumns = 16;  // px, width of a block
constexpr int kRows = 8;      // px, height of a block
constexpr int kScale = 64;    // sum of the weights
// Weights are at most 64, and negative ones at least -5, so that sums fit into 16 bits.
static_assert(kSteps == 1 << 5 && kScale == 1 << 6 && kColumns <= int{GrayLevel::kPadding});
constexpr int kMost = 8;  // px, largest displacement; fields are far below it

using Weights = std::array<std::int16_t, 4>;

constexpr int rounded(double value) { return static_cast<int>(value + (value < 0 ? -0.5 : 0.5)); }

/// Catmull-Rom between the second and the third of four rows, at f / kSteps below the second.
constexpr Weights weightsOf(int f) {
  const double t = static_cast<double>(f) / kSteps;
  const int first = rounded(kScale * 0.5 * t * (-1 + t * (2 - t)));
  const int third = rounded(kScale * 0.5 * t * (1 + t * (4 - 3 * t)));
  const int fourth = rounded(kScale * 0.5 * t * t * (t - 1));
  const int second = kScale - first - third - fourth;
  return {static_cast<std::int16_t>(first), static_cast<std::int16_t>(second),
          static_cast<std::int16_t>(third), static_cast<std::int16_t>(fourth)};
}

constexpr std::array<Weights, kSteps> allWeights() {
  std::array<Weights, kSteps> weights{};
  for (int f = 0; f < kSteps; ++f) weights[static_cast<std::size_t>(f)] = weightsOf(f);
  return weights;
}

using Bytes = std::uint8_t __attribute__((vector_size(kColumns)));
using Shorts = std::int16_t __attribute__((vector_size(2 * kColumns)));

TOLMAN_INLINE Shorts loadShorts(const std::uint8_t* p) {
  Bytes bytes;
  std::memcpy(&bytes, p, sizeof bytes);
  return __builtin_convertvector(bytes, Shorts);
}

/// Pixels of the rows from v on, in column u; the outermost row for rows outside of the image.
TOLMAN_INLINE std::array<const std::uint8_t*, 4> fourRows(const GrayLevel& image, int u, int v) {
  if (v >= 0 && v + 3 < image.height) {
    const std::uint8_t* p = image.row(v) + u;
    const std::ptrdiff_t width = image.width;
    return {p, p + width, p + 2 * width, p + 3 * width};
  }
  const auto row = [&](int at) { return image.row(std::clamp(at, 0, image.height - 1)) + u; };
  return {row(v), row(v + 1), row(v + 2), row(v + 3)};
}

/// One row of the result, displaced by `steps` (one a block). Writes whole blocks, up to
/// GrayLevel::kPadding bytes too many.
TOLMAN_WIDE_LANES void mixRows(const GrayLevel& image, const std::int16_t* steps, int v,
                               std::uint8_t* out) {
  constexpr std::array<Weights, kSteps> kWeights = allWeights();
  for (int u = 0; u < image.width; u += kColumns, ++steps, out += kColumns) {
    const int whole = *steps >> 5;  // rounded down
    const Weights& w = kWeights[static_cast<std::size_t>(*steps & (kSteps - 1))];
    const auto [a, b, c, d] = fourRows(image, u, v + whole - 1);
    const Shorts sum =
        w[0] * loadShorts(a) + w[1] * loadShorts(b) + w[2] * loadShorts(c) + w[3] * loadShorts(d);
    const Shorts mixed = (sum + kScale / 2) >> 6;
    constexpr Shorts kBlack{};
    constexpr Shorts kWhite = kBlack + 255;
    const Shorts bounded = mixed < kBlack ? kBlack : mixed > kWhite ? kWhite : mixed;
    const Bytes bytes = __builtin_convertvector(bounded, Bytes);
    std::memcpy(out, &bytes, sizeof bytes);
  }
}

}  // namespace

void RowShift::set(const SmoothField& field, int width, int height) {
  width_ = width;
  height_ = height;
  across_ = (width + kColumns - 1) / kColumns;
  const int blocks = across_ * ((height + kRows - 1) / kRows);
  steps_.resize(static_cast<std::size_t>(blocks));
  for (int i = 0; i < blocks; ++i) {
    const int column = i % across_;
    const int row = i / across_;
    const double u = (column + 0.5) * kColumns - 0.5;
    const double v = (row + 0.5) * kRows - 0.5;
    const double shift = std::clamp(field.at(u, v, width, height), -1.0 * kMost, 1.0 * kMost);
    steps_[static_cast<std::size_t>(i)] = static_cast<std::int16_t>(std::lround(kSteps * shift));
  }
}

double RowShift::at(double u, double v) const {
  if (steps_.empty()) return 0;
  const int x = std::clamp(static_cast<int>(u + 0.5), 0, width_ - 1) / kColumns;
  const int y = std::clamp(static_cast<int>(v + 0.5), 0, height_ - 1) / kRows;
  return static_cast<double>(steps_[static_cast<std::size_t>(y * across_ + x)]) / kSteps;
}

void RowShift::apply(GrayLevel& image) {
  if (steps_.empty()) return;
  buffer_.resize(image.pixels.size());
  for (int v = 0; v < height_; ++v) {
    mixRows(image, steps_.data() + static_cast<std::ptrdiff_t>(v / kRows) * across_, v,
            buffer_.data() + static_cast<std::ptrdiff_t>(v) * width_);
  }
  std::fill(buffer_.begin() + static_cast<std::ptrdiff_t>(width_) * height_, buffer_.end(), 0);
  std::swap(image.pixels, buffer_);
}

// Eight pixels at once where the processor has SSE4.1, one after the other otherwise. Both give
// the same whole numbers.

namespace {

const std::uint8_t* cornerAt(const GrayLevel& image, int u, int v) {
  return image.row(v - kPatchHeight / 2) + u - kPatchWidth / 2;
}

void costsOneByOne(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
                   std::uint16_t* costs) {
  for (int u = u_begin; u < u_end; ++u) {
    int sum = 0;
    for (int y = 0; y < kPatchHeight; ++y) {
      const std::uint8_t* row = cornerAt(image, u, v) + y * image.width;
      for (int x = 0; x < kPatchWidth; ++x) {
        sum += std::abs(row[x] - patch[static_cast<std::size_t>(y * kPatchWidth + x)]);
      }
    }
    *costs++ = static_cast<std::uint16_t>(sum);
  }
}

#if defined(__x86_64__)
[[gnu::target("sse4.1")]] void costsByEight(const StereoPatch& patch, const GrayLevel& image,
                                            int u_begin, int u_end, int v, std::uint16_t* costs) {
  __m128i rows[kPatchHeight];  // NOLINT: std::array ignores attributes of its type
  for (std::size_t y = 0; y < kPatchHeight; ++y) {
    rows[y] = _mm_loadl_epi64(
        reinterpret_cast<const __m128i*>(patch.data() + y * std::size_t{kPatchWidth}));
  }
  for (int u = u_begin; u < u_end; u += 8, costs += 8) {
    const std::uint8_t* p = cornerAt(image, u, v);
    __m128i sum = _mm_setzero_si128();
    for (const __m128i& row : rows) {
      const __m128i pixels = _mm_loadu_si128(reinterpret_cast<const __m128i*>(p));
      // Four columns of the patch at eight places: columns 0 to 3, then 4 to 7.
      sum = _mm_add_epi16(sum, _mm_mpsadbw_epu8(pixels, row, 0b000));
      sum = _mm_add_epi16(sum, _mm_mpsadbw_epu8(pixels, row, 0b101));
      p += image.width;
    }
    _mm_storeu_si128(reinterpret_cast<__m128i*>(costs), sum);
  }
}
#endif

}  // namespace

void rowCosts(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
              std::uint16_t* costs) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("sse4.1")) {
    return costsByEight(patch, image, u_begin, u_end, v, costs);
  }
#endif
  costsOneByOne(patch, image, u_begin, u_end, v, costs);
}

namespace {

constexpr int kRowPatchRadius = 3;     // px; chosen, not tuned
constexpr double kCornerSigma = 0.25;  // px, of one corner; chosen, not tuned
/// Share of a corner's information that is new: the same corner is seen by several keyframes.
/// Chosen, not tuned.
constexpr double kNewShare = 0.3;
/// Keyframes after which what was learnt has lost most of its weight, because a rig changes with
/// temperature. Chosen, not tuned.
constexpr double kMemory = 1000;

}  // namespace

void RowAlignment::configure(int width, int height, double sigma) {
  width_ = width;
  height_ = height;
  sigma_ = sigma;
  reset();
}

void RowAlignment::reset() {
  field_ = SmoothField();
  information_ = isOn() ? prior() : Information::Zero();
  information_vector_.setZero();
  shift_.setNone();
}

/// Higher terms are expected to be smaller, by their degree.
RowAlignment::Information RowAlignment::prior() const {
  Information prior = Information::Zero();
  for (int k = 0; k < SmoothField::kTerms; ++k) {
    const double sigma = sigma_ / (1 + SmoothField::kDegrees[static_cast<std::size_t>(k)]);
    prior(k, k) = 1 / (sigma * sigma);
  }
  return prior;
}

void RowAlignment::observe(const GrayLevel& left, const GrayLevel& right,
                           const std::vector<RowCorner>& corners, float gain) {
  if (!isOn()) return;
  errors_.assign(corners.size(), std::nullopt);
  tbb::parallel_for(std::size_t{0}, corners.size(), [&](std::size_t i) {
    const RowCorner& corner = corners[i];
    const auto v = static_cast<float>(corner.v);
    const auto match =
        matchPatch(left, corner.u, corner.v, right,
                   {static_cast<float>(corner.u) - corner.disparity, v}, gain, kRowPatchRadius);
    if (match) errors_[i] = match->y() - v;
  });
  std::vector<Measurement> measurements;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    if (!errors_[i]) continue;
    Measurement m;
    const double u = static_cast<double>(corners[i].u) - static_cast<double>(corners[i].disparity);
    m.terms = SmoothField::termsAt(u, corners[i].v, width_, height_);
    m.below = shift_.at(u, corners[i].v) + static_cast<double>(*errors_[i]);
    measurements.push_back(m);
  }
  learn(measurements);
  if (isSignificant()) {
    shift_.set(field_, width_, height_);
  } else {
    shift_.setNone();
  }
}

/// Somewhere the field is larger than 0.1 px and three standard deviations; chosen, not tuned.
bool RowAlignment::isSignificant() const {
  constexpr int kGrid = 5;  // places each way
  for (int i = 0; i < kGrid * kGrid; ++i) {
    const int column = i % kGrid;
    const int row = i / kGrid;
    const double u = column * (width_ - 1.0) / (kGrid - 1);
    const double v = row * (height_ - 1.0) / (kGrid - 1);
    const double shift = std::fabs(field_.at(u, v, width_, height_));
    if (shift > 0.1 && shift > 3 * sigmaAt(u, v)) return true;
  }
  return false;
}

void RowAlignment::learn(const std::vector<Measurement>& measurements) {
  const Information before = prior() + (1 - 1 / kMemory) * (information_ - prior());
  const SmoothField::Terms vector_before = (1 - 1 / kMemory) * information_vector_;
  // Weights depend on the fit and the fit on weights; three rounds are chosen, not tuned.
  for (int round = 0; round < 3; ++round) {
    information_ = before;
    information_vector_ = vector_before;
    for (const Measurement& m : measurements) {
      const double error = std::fabs(m.below - field_.coefficients.dot(m.terms));
      const double limit = 1.5 * kCornerSigma;  // Huber's, chosen, not tuned
      const double weight =
          kNewShare / (kCornerSigma * kCornerSigma) * std::min(1.0, limit / error);
      information_.noalias() += weight * m.terms * m.terms.transpose();
      information_vector_ += weight * m.below * m.terms;
    }
    field_.coefficients = information_.ldlt().solve(information_vector_);
  }
}

double RowAlignment::sigmaAt(double u, double v) const {
  if (!isOn()) return 0;
  const SmoothField::Terms terms = SmoothField::termsAt(u, v, width_, height_);
  return std::sqrt(std::max(0.0, terms.dot(information_.ldlt().solve(terms))));
}

}  // namespace tolman::direct_sparse
