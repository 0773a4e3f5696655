// SPDX-License-Identifier: BSD-3-Clause
#include "view_maker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <string>

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

namespace {

double meanOf(const std::vector<float>& cells) {
  return std::accumulate(cells.begin(), cells.end(), 0.0) / static_cast<double>(cells.size());
}

int pixelOf(double fraction, int size) { return static_cast<int>(std::lround(fraction * size)); }

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

std::int64_t sumOf(const std::uint8_t* bytes, int count) {
  std::int64_t sum = 0;
  for (int i = 0; i < count; ++i) sum += bytes[i];
  return sum;
}

}  // namespace

void averageBlocks(const Image& image, int x0, int y0, int block_width, int block_height,
                   int columns, int rows, std::vector<float>& cells) {
  const int bytes = bytesPerPixel(image.format());
  const double scale = 1.0 / (255.0 * bytes * block_width * block_height);
  std::vector<std::int64_t> sums(static_cast<std::size_t>(columns));
  cells.clear();
  for (int r = 0; r < rows; ++r) {
    std::fill(sums.begin(), sums.end(), 0);
    for (int y = 0; y < block_height; ++y) {
      const std::uint8_t* pixel = image.row(y0 + r * block_height + y) + x0 * bytes;
      for (std::int64_t& sum : sums) {
        sum += sumOf(pixel, block_width * bytes);
        pixel += block_width * bytes;
      }
    }
    for (const std::int64_t sum : sums) {
      cells.push_back(static_cast<float>(static_cast<double>(sum) * scale));
    }
  }
}

void normaliseMean(double target, std::vector<float>& cells) {
  const double mean = meanOf(cells);
  if (!(mean > 0)) return;
  const double factor = target / mean;
  for (float& cell : cells) cell = static_cast<float>(std::clamp(cell * factor, 0.0, 1.0));
}

namespace {

struct Moments {
  double mean = 0;
  double deviation = 0;
};

Moments momentsOfWindow(const std::vector<float>& source, int columns, int column, int row,
                        int radius) {
  const int rows = static_cast<int>(source.size()) / columns;
  double sum = 0;
  double squares = 0;
  for (int y = row - radius; y <= row + radius; ++y) {
    const int start = std::clamp(y, 0, rows - 1) * columns;
    for (int x = column - radius; x <= column + radius; ++x) {
      const double value = source[static_cast<std::size_t>(start + std::clamp(x, 0, columns - 1))];
      sum += value;
      squares += value * value;
    }
  }
  const double count = (2.0 * radius + 1) * (2.0 * radius + 1);
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(0.0, squares / count - mean * mean))};
}

}  // namespace

void normalisePatches(int columns, int radius, const std::vector<float>& source,
                      std::vector<float>& cells) {
  // A smaller deviation is the rounding error of a window of equal cells.
  constexpr double kFlat = 1e-6;
  cells.resize(source.size());
  for (std::size_t i = 0; i < source.size(); ++i) {
    const int at = static_cast<int>(i);
    const Moments window = momentsOfWindow(source, columns, at % columns, at / columns, radius);
    const bool flat = window.deviation < kFlat;
    const double z = flat ? 0 : (source[i] - window.mean) / window.deviation;
    cells[i] = static_cast<float>(std::clamp((z + 3) / 6, 0.0, 1.0));
  }
}

Result<Crop> ViewMaker::cropOf(int image_width, int image_height) const {
  const LocalViewSettings& s = settings_;
  const int x0 = pixelOf(s.crop_x_min, image_width);
  const int y0 = pixelOf(s.crop_y_min, image_height);
  const Crop crop{x0, y0, pixelOf(s.crop_x_max, image_width) - x0,
                  pixelOf(s.crop_y_max, image_height) - y0};
  const int finest = s.kind == CellKind::Gradients ? kSamplesPerCell : 1;
  if (crop.width >= s.columns * finest && crop.height >= s.rows * finest) return crop;
  return Status::invalidParameter(
      "the crop of the " + sizeText(image_width, image_height) + " image has " +
      sizeText(crop.width, crop.height) + " pixels, too few for a template of " +
      sizeText(s.columns, s.rows) + " cells" +
      (finest > 1 ? " of " + sizeText(finest, finest) + " pixels" : "") +
      "; make `columns` and `rows` smaller or the crop larger");
}

Status ViewMaker::checkSize(int image_width, int image_height) const {
  return cropOf(image_width, image_height).status();
}

Status ViewMaker::make(const Image& image, LocalView& view) {
  const LocalViewSettings& s = settings_;
  const Result<Crop> crop = cropOf(image.width(), image.height());
  if (!crop.isOk()) return crop.status();
  if (s.kind == CellKind::Gradients) {
    averageCrop(image, crop.value(), s.columns * kSamplesPerCell, s.rows * kSamplesPerCell,
                scratch_);
    gradientCells(scratch_, s.columns, s.rows, view.cells);
    view.cell_width_px = static_cast<double>(crop.value().width) / s.columns;
  } else {
    makeGrey(image, crop.value(), view);
  }
  view.mean = meanOf(view.cells);
  return Status::ok();
}

void ViewMaker::makeGrey(const Image& image, const Crop& crop, LocalView& view) {
  const LocalViewSettings& s = settings_;
  // The remainder on the right and below is ignored.
  const int width = crop.width / s.columns;
  const int height = crop.height / s.rows;
  averageBlocks(image, crop.x0, crop.y0, width, height, s.columns, s.rows, view.cells);
  if (s.normalisation > 0) normaliseMean(s.normalisation, view.cells);
  if (s.patch_radius > 0) {
    scratch_.swap(view.cells);
    normalisePatches(s.columns, s.patch_radius, scratch_, view.cells);
  }
  view.cell_width_px = width;
}

}  // namespace tolman::view_templates
