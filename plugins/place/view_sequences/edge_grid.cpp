// SPDX-License-Identifier: BSD-3-Clause
#include "edge_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "edge_map.hpp"
#include "tolman/image_cv.hpp"
#include "wide_lanes.hpp"

namespace tolman::view_sequences {

namespace {

constexpr int kCell = 12;  // px of the reduced image; chosen, not tuned
constexpr int kWidth = kColumns * kCell;
constexpr int kHeight = kRows * kCell;
// Gradients below this over two pixels are treated as noise. Chosen, not tuned.
constexpr float kNoise = 0.01F;
// A view whose mean gradient over two pixels is smaller, in grey levels, is blank or dark. Chosen,
// not tuned.
constexpr double kBlank = 1;

cv::Mat reduced(const Image& image) {
  cv::Mat whole = asMat(image);
  // Halves first, which takes little time; the last step is by a factor of two or more across. The
  // result is nearly that of one step: it differs where the border of a reduced pixel divides a
  // halved one.
  while (whole.cols >= 4 * kWidth && whole.rows >= 2 * kHeight) {
    cv::Mat half;
    cv::resize(whole, half, cv::Size(whole.cols / 2, whole.rows / 2), 0, 0, cv::INTER_AREA);
    whole = half;
  }
  cv::Mat small;
  cv::resize(whole, small, cv::Size(kWidth, kHeight), 0, 0, cv::INTER_AREA);
  if (image.format() != PixelFormat::Gray8) cv::cvtColor(small, small, cv::COLOR_BGR2GRAY);
  return small;
}

bool isBlank(const cv::Mat& gray) {
  double sum = 0;
  for (int y = 1; y < gray.rows - 1; ++y) {
    const std::uint8_t* above = gray.ptr<std::uint8_t>(y - 1);
    const std::uint8_t* row = gray.ptr<std::uint8_t>(y);
    const std::uint8_t* below = gray.ptr<std::uint8_t>(y + 1);
    for (int x = 1; x < gray.cols - 1; ++x) {
      const auto across = static_cast<float>(row[x + 1] - row[x - 1]);
      const auto down = static_cast<float>(below[x] - above[x]);
      sum += static_cast<double>(std::sqrt(across * across + down * down));
    }
  }
  return sum < kBlank * static_cast<double>(gray.total());
}

/// Logarithm of an image, so that edges in the dark and in the light have equal strength. With it
/// the right place was ranked first for 0.90 of the views of a second pass by night (town, route
/// 05), without it for 0.81. 8, 16 and 32 for kDarkLevel are equally good there and on campus
/// walks.
cv::Mat lightOf(const cv::Mat& gray) {
  constexpr float kMiddle = 100;  // grey level at which the slope is that of level / 255
  cv::Mat light;
  gray.convertTo(light, CV_32F, 1, landmarks::kDarkLevel);
  cv::log(light, light);
  return light * ((kMiddle + landmarks::kDarkLevel) / 255);
}

/// The two cells nearest to a pixel along one axis, and the weight of the second.
struct Shares {
  int cell;  ///< the first; -1 before the first cell
  float second;
};

/// Of the pixels of one axis, and the sums of the weights of the cells.
template <int kPixels>
struct Axis {
  std::array<Shares, kPixels> shares;
  std::array<float, kPixels / kCell> weights{};

  Axis() {
    constexpr int kCells = kPixels / kCell;
    for (int at = 0; at < kPixels; ++at) {
      const float place = (static_cast<float>(at) + 0.5F) / kCell - 0.5F;
      const float cell = std::floor(place);
      const Shares share{static_cast<int>(cell), place - cell};
      shares[static_cast<std::size_t>(at)] = share;
      if (at == 0 || at == kPixels - 1) continue;  // has no edge
      if (share.cell >= 0) weights[static_cast<std::size_t>(share.cell)] += 1 - share.second;
      if (share.cell + 1 < kCells)
        weights[static_cast<std::size_t>(share.cell + 1)] += share.second;
    }
  }
};

/// Edges of a row of pixels: strength, and direction from 0 to kDirections, which is half a turn.
struct RowOfEdges {
  std::array<float, kWidth> strength{};
  std::array<float, kWidth> direction{};
};

/// The first and the last pixel have no edge. The arctangent is the polynomial of Abramowitz and
/// Stegun, equation 4.4.49, whose relative error of 2e-8 is below the rounding of float: std::atan2
/// takes half of the time of the whole grid.
TOLMAN_WIDE_LANES void edgesOfRow(const float* above, const float* row, const float* below,
                                  float* strength, float* direction) {
  constexpr float kHalfTurn = std::numbers::pi_v<float>;
  constexpr float kTerms[] = {0.0028662257F,  -0.0161657367F, 0.0429096138F,
                              -0.0752896400F, 0.1065626393F,  -0.1420889944F,
                              0.1999355085F,  -0.3333314528F, 1};
  for (int x = 1; x < kWidth - 1; ++x) {
    const float across = row[x + 1] - row[x - 1];
    const float down = below[x] - above[x];
    const float wide = std::abs(across);
    const float high = std::abs(down);
    const float larger = wide > high ? wide : high;
    const float ratio = (wide > high ? high : wide) / (larger > 0 ? larger : 1);
    const float square = ratio * ratio;
    float series = 0;
    for (const float term : kTerms) series = series * square + term;
    const float acute = ratio * series;
    const float upright = wide > high ? acute : kHalfTurn / 2 - acute;
    const float angle = across * down < 0 ? kHalfTurn - upright : upright;
    direction[x] = angle * (kDirections / kHalfTurn);
    strength[x] = std::sqrt(across * across + down * down);
  }
}

/// Sums of a row of pixels in each column of cells and direction; the first and the last column are
/// outside the image.
using RowSums = std::array<std::array<float, kDirections>, kColumns + 2>;

/// Distributes each edge over the two nearest columns and directions (linear interpolation).
RowSums sumsOf(const RowOfEdges& edges, const Axis<kWidth>& columns) {
  RowSums sums{};
  for (std::size_t x = 1; x < kWidth - 1; ++x) {
    const float place = edges.direction[x] + (kDirections - 0.5F);
    const int before = static_cast<int>(place);
    const int first = before < kDirections ? before : before - kDirections;
    const int second = first + 1 < kDirections ? first + 1 : 0;
    const float to_second = (place - static_cast<float>(before)) * edges.strength[x];
    const float to_first = edges.strength[x] - to_second;
    const Shares& shares = columns.shares[x];
    for (int i = 0; i < 2; ++i) {
      auto& sum = sums[static_cast<std::size_t>(shares.cell + 1 + i)];
      const float weight = i == 0 ? 1 - shares.second : shares.second;
      sum[static_cast<std::size_t>(first)] += weight * to_first;
      sum[static_cast<std::size_t>(second)] += weight * to_second;
    }
  }
  return sums;
}

std::size_t indexOf(int column, int row, int direction) {
  return static_cast<std::size_t>((column * kRows + row) * kDirections + direction);
}

void addRow(const RowSums& row, int cell_row, float weight, EdgeValues& sums) {
  if (cell_row < 0 || cell_row >= kRows) return;
  for (int c = 0; c < kColumns; ++c) {
    const auto& of_column = row[static_cast<std::size_t>(c + 1)];
    float* sum = &sums[indexOf(c, cell_row, 0)];
    for (const float of_direction : of_column) *sum++ += weight * of_direction;
  }
}

/// Mean strength for each cell and direction.
EdgeValues edgesOf(const cv::Mat& image) {
  const Axis<kWidth> columns;
  const Axis<kHeight> rows;
  EdgeValues values{};
  RowOfEdges edges;
  for (int y = 1; y < kHeight - 1; ++y) {
    edgesOfRow(image.ptr<float>(y - 1), image.ptr<float>(y), image.ptr<float>(y + 1),
               edges.strength.data(), edges.direction.data());
    const RowSums sums = sumsOf(edges, columns);
    const Shares& shares = rows.shares[static_cast<std::size_t>(y)];
    addRow(sums, shares.cell, 1 - shares.second, values);
    addRow(sums, shares.cell + 1, shares.second, values);
  }
  for (std::size_t c = 0; c < kColumns; ++c) {
    for (std::size_t r = 0; r < kRows; ++r) {
      const float weight = columns.weights[c] * rows.weights[r];
      for (std::size_t k = 0; k < kDirections; ++k) {
        values[(c * kRows + r) * kDirections + k] /= weight;
      }
    }
  }
  return values;
}

float energyOf(const EdgeValues& edges, int column, int row) {
  const float* cell = &edges[indexOf(column, row, 0)];
  float energy = 0;
  for (int k = 0; k < kDirections; ++k) energy += cell[k] * cell[k];
  return energy;
}

/// Root mean square of the edges of the 3 x 3 cells around.
float strengthAround(const EdgeValues& edges, int column, int row) {
  float energy = 0;
  int cells = 0;
  for (int c = std::max(0, column - 1); c <= std::min(kColumns - 1, column + 1); ++c) {
    for (int r = std::max(0, row - 1); r <= std::min(kRows - 1, row + 1); ++r) {
      energy += energyOf(edges, c, r);
      ++cells;
    }
  }
  return std::sqrt(energy / static_cast<float>(cells));
}

}  // namespace

bool edgeGrid(const Image& image, EdgeValues& values) {
  const cv::Mat gray = reduced(image);
  if (isBlank(gray)) return false;
  const EdgeValues edges = edgesOf(lightOf(gray));
  for (int c = 0; c < kColumns; ++c) {
    for (int r = 0; r < kRows; ++r) {
      const float around = strengthAround(edges, c, r) + kNoise;
      for (int k = 0; k < kDirections; ++k) {
        const std::size_t i = indexOf(c, r, k);
        values[i] = std::sqrt(edges[i] / around);  // the root amplifies weak edges near strong ones
      }
    }
  }
  return true;
}

PackedView packed(const EdgeValues& values) {
  const auto level = [&](int i) {
    const float value = values[static_cast<std::size_t>(i)] * kLevelsPerUnit;
    return static_cast<unsigned>(std::clamp(std::lround(value), 0L, 15L));
  };
  constexpr int kHalf = kColumnValues / 2;
  PackedView view;
  for (int c = 0; c < kColumns; ++c) {
    for (int i = 0; i < kHalf; ++i) {
      const int first = c * kColumnValues + i;
      view[static_cast<std::size_t>(c * kHalf + i)] =
          static_cast<std::uint8_t>(level(first) | level(first + kHalf) << 4U);
    }
  }
  return view;
}

void unpack(std::span<const std::uint8_t> view, std::span<std::int16_t, kValues> levels) {
  constexpr int kHalf = kColumnValues / 2;
  const std::uint8_t* byte = view.data();
  std::int16_t* level = levels.data();
  for (int c = 0; c < kColumns; ++c, byte += kHalf, level += kColumnValues) {
    for (int i = 0; i < kHalf; ++i) {
      level[i] = static_cast<std::int16_t>(byte[i] & 15U);
      level[kHalf + i] = static_cast<std::int16_t>(byte[i] >> 4U);
    }
  }
}

}  // namespace tolman::view_sequences
