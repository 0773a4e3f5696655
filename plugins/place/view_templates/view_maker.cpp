// SPDX-License-Identifier: BSD-3-Clause
#include "view_maker.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>

namespace tolman::view_templates {
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
