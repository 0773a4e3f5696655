// SPDX-License-Identifier: BSD-3-Clause
#include "gradient_cells.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace tolman::view_templates {
namespace {

/// First pixel of block `index`, of `count` blocks that fill `size` pixels.
int edgeOf(int index, int count, int size) {
  return static_cast<int>((static_cast<std::int64_t>(index) * size + count / 2) / count);
}

std::size_t indexOf(int column, int row, int columns) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
         static_cast<std::size_t>(column);
}

/// Adds the gradients of one cell's samples to the sums of the two nearest directions (linear
/// interpolation).
void addGradients(const std::vector<float>& samples, int columns, int rows, int column, int row,
                  float (&sums)[kDirections]) {
  const int width = columns * kSamplesPerCell;
  const int height = rows * kSamplesPerCell;
  const int first_x = std::max(1, column * kSamplesPerCell);
  const int last_x = std::min(width - 1, (column + 1) * kSamplesPerCell);
  const int first_y = std::max(1, row * kSamplesPerCell);
  const int last_y = std::min(height - 1, (row + 1) * kSamplesPerCell);
  for (int y = first_y; y < last_y; ++y) {
    for (int x = first_x; x < last_x; ++x) {
      const float right = samples[indexOf(x + 1, y, width)] - samples[indexOf(x - 1, y, width)];
      const float down = samples[indexOf(x, y + 1, width)] - samples[indexOf(x, y - 1, width)];
      const float strength = std::sqrt(right * right + down * down);
      const float angle = std::atan2(down, right) / std::numbers::pi_v<float>;  // in [-1, 1]
      const float place = (angle + 1) * kDirections - 0.5F;
      const float before = std::floor(place);
      const float share = place - before;
      const int bin = static_cast<int>(before) + kDirections;
      sums[bin % kDirections] += strength * (1 - share);
      sums[(bin + 1) % kDirections] += strength * share;
    }
  }
}

/// Root mean square of the edges of the cells around, over all directions.
float strengthAround(const std::vector<float>& sums, int columns, int rows, int column, int row) {
  float squares = 0;
  int count = 0;
  for (int y = std::max(0, row - 1); y <= std::min(rows - 1, row + 1); ++y) {
    for (int x = std::max(0, column - 1); x <= std::min(columns - 1, column + 1); ++x) {
      ++count;
      for (int k = 0; k < kDirections; ++k) {
        const float value = sums[indexOf(x, k * rows + y, columns)];
        squares += value * value;
      }
    }
  }
  return std::sqrt(squares / static_cast<float>(count));
}

}  // namespace

void averageCrop(const Image& image, const Crop& crop, int columns, int rows,
                 std::vector<float>& samples) {
  const int bytes = bytesPerPixel(image.format());
  std::vector<std::int64_t> sums(static_cast<std::size_t>(columns));
  samples.clear();
  for (int r = 0; r < rows; ++r) {
    const int top = edgeOf(r, rows, crop.height);
    const int bottom = edgeOf(r + 1, rows, crop.height);
    std::fill(sums.begin(), sums.end(), 0);
    for (int y = top; y < bottom; ++y) {
      const std::uint8_t* const row = image.row(crop.y0 + y) + crop.x0 * bytes;
      for (int c = 0; c < columns; ++c) {
        const int right = edgeOf(c + 1, columns, crop.width) * bytes;
        std::int64_t& sum = sums[static_cast<std::size_t>(c)];
        for (int i = edgeOf(c, columns, crop.width) * bytes; i < right; ++i) sum += row[i];
      }
    }
    for (int c = 0; c < columns; ++c) {
      const int width = edgeOf(c + 1, columns, crop.width) - edgeOf(c, columns, crop.width);
      const double count = 255.0 * bytes * width * (bottom - top);
      samples.push_back(
          static_cast<float>(static_cast<double>(sums[static_cast<std::size_t>(c)]) / count));
    }
  }
}

void gradientCells(const std::vector<float>& samples, int columns, int rows,
                   std::vector<float>& cells) {
  // Mean gradient of noise, in grey levels of 0 to 1 over two samples. Chosen, not tuned.
  constexpr float kNoise = 0.01F;
  constexpr float kSamples = kSamplesPerCell * kSamplesPerCell;
  std::vector<float> sums(indexOf(0, rows * kDirections, columns));
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      float directions[kDirections] = {};
      addGradients(samples, columns, rows, c, r, directions);
      for (int k = 0; k < kDirections; ++k) {
        sums[indexOf(c, k * rows + r, columns)] = directions[k] / kSamples;
      }
    }
  }
  cells.resize(sums.size());
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      const float around = strengthAround(sums, columns, rows, c, r) + kNoise;
      for (int k = 0; k < kDirections; ++k) {
        const std::size_t i = indexOf(c, k * rows + r, columns);
        // The root amplifies weak edges near strong ones.
        cells[i] = std::sqrt(std::min(1.0F, sums[i] / around));
      }
    }
  }
}

}  // namespace tolman::view_templates
