// SPDX-License-Identifier: BSD-3-Clause
#include "engine/image_mask.hpp"

#include <algorithm>
#include <cmath>

namespace tolman::engine {
namespace {

/// Calls visit(x, y, index of the pixel) for the pixels of the finer level that (x, y) covers.
template <class Visit>
void forCovered(int x, int y, int width, int height, Visit&& visit) {
  for (int v = 2 * y; v < std::min(2 * y + 2, height); ++v) {
    for (int u = 2 * x; u < std::min(2 * x + 2, width); ++u) {
      visit(static_cast<std::size_t>(v) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(u));
    }
  }
}

}  // namespace

Result<ImageMask> ImageMask::create(const CameraRig& rig, const std::vector<double>& rectangles) {
  ImageMask mask;
  if (rectangles.empty()) return mask;
  Level level{rig.width, rig.height, {}};
  const auto pixels = static_cast<std::size_t>(rig.width) * static_cast<std::size_t>(rig.height);
  level.known.assign(pixels, 1);
  for (std::size_t i = 0; i + 4 <= rectangles.size(); i += 4) {
    const double right = rectangles[i] + rectangles[i + 2];
    const double bottom = rectangles[i + 1] + rectangles[i + 3];
    if (right > rig.width || bottom > rig.height) {
      return Status::invalidParameter("images.mask has a rectangle outside of the images of " +
                                      std::to_string(rig.width) + "x" + std::to_string(rig.height) +
                                      " px; correct it");
    }
    for (auto y = static_cast<int>(rectangles[i + 1]); y < bottom; ++y) {
      const auto row = static_cast<std::ptrdiff_t>(y) * rig.width;
      std::fill(level.known.begin() + row + static_cast<int>(rectangles[i]),
                level.known.begin() + row + static_cast<int>(std::ceil(right)), char{0});
    }
  }
  if (rectangles.size() % 4 != 0 || std::ranges::count(level.known, 1) == 0) {
    return Status::invalidParameter(
        "images.mask is not a list of left, top, width, height of rectangles that leave a part of "
        "the images; correct it");
  }
  mask.levels_.push_back(std::move(level));
  while (std::ranges::count(mask.levels_.back().known, 0) > 0) {
    const Level& fine = mask.levels_.back();
    Level coarse{(fine.width + 1) / 2, (fine.height + 1) / 2, {}};
    for (int y = 0; y < coarse.height; ++y) {
      for (int x = 0; x < coarse.width; ++x) {
        char known = 0;
        forCovered(x, y, fine.width, fine.height, [&](std::size_t i) { known |= fine.known[i]; });
        coarse.known.push_back(known);
      }
    }
    mask.levels_.push_back(std::move(coarse));
  }
  return mask;
}

/// Means of the known pixels of the level above, by its levels.
std::vector<float> ImageMask::halved(const std::vector<float>& pixels, std::size_t level) const {
  const Level& fine = levels_[level];
  const Level& coarse = levels_[level + 1];
  std::vector<float> means;
  means.reserve(coarse.known.size());
  for (int y = 0; y < coarse.height; ++y) {
    for (int x = 0; x < coarse.width; ++x) {
      float sum = 0;
      float count = 0;
      forCovered(x, y, fine.width, fine.height, [&](std::size_t i) {
        if (fine.known[i] == 0) return;
        sum += pixels[i];
        count += 1;
      });
      means.push_back(count > 0 ? sum / count : 0);
    }
  }
  return means;
}

/// Fills the unknown pixels of a level from those of the next, bilinear.
void ImageMask::fill(std::vector<float>& pixels, std::size_t level) const {
  if (level + 1 == levels_.size()) return;
  std::vector<float> means = halved(pixels, level);
  fill(means, level + 1);
  const Level& coarse = levels_[level + 1];
  const auto at = [&](int x, int y) {
    return means[static_cast<std::size_t>(std::min(y, coarse.height - 1)) *
                     static_cast<std::size_t>(coarse.width) +
                 static_cast<std::size_t>(std::min(x, coarse.width - 1))];
  };
  std::size_t i = 0;
  for (int y = 0; y < levels_[level].height; ++y) {
    const float v = std::max((static_cast<float>(y) - 0.5F) / 2, 0.0F);
    const int j = static_cast<int>(v);
    for (int x = 0; x < levels_[level].width; ++x, ++i) {
      if (levels_[level].known[i] != 0) continue;
      const float u = std::max((static_cast<float>(x) - 0.5F) / 2, 0.0F);
      const int k = static_cast<int>(u);
      const float across = u - static_cast<float>(k);
      pixels[i] =
          std::lerp(std::lerp(at(k, j), at(k + 1, j), across),
                    std::lerp(at(k, j + 1), at(k + 1, j + 1), across), v - static_cast<float>(j));
    }
  }
}

Image ImageMask::apply(const Image& image) const {
  if (isEmpty() || image.width() != levels_[0].width || image.height() != levels_[0].height) {
    return image;
  }
  const auto channels = static_cast<std::size_t>(bytesPerPixel(image.format()));
  return Image::create(image.width(), image.height(), image.format(), [&](std::uint8_t* out) {
    const std::size_t row = static_cast<std::size_t>(image.width()) * channels;
    for (int y = 0; y < image.height(); ++y) {
      std::copy_n(image.row(y), row, out + static_cast<std::size_t>(y) * row);
    }
    std::vector<float> pixels(levels_[0].known.size());
    for (std::size_t channel = 0; channel < channels; ++channel) {
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        pixels[i] = static_cast<float>(out[i * channels + channel]);
      }
      fill(pixels, 0);
      for (std::size_t i = 0; i < pixels.size(); ++i) {
        out[i * channels + channel] = static_cast<std::uint8_t>(std::lround(pixels[i]));
      }
    }
  });
}

bool Alternation::add(const Image& image) {
  constexpr std::size_t kJudged = 24;  // images; by chance one in eight million alternates so long
  constexpr double kLeast = 0.02;      // of the texture; chosen
  constexpr int kEvery = 4;            // rows
  if (image.empty() || textures_.size() >= kJudged) return false;
  const int channels = bytesPerPixel(image.format());
  double sum = 0;
  for (int y = 0; y < image.height(); y += kEvery) {
    const std::uint8_t* row = image.row(y);
    for (int x = channels; x < image.width() * channels; ++x) {
      sum += std::abs(row[x] - row[x - channels]);
    }
  }
  textures_.push_back(sum);
  if (textures_.size() < kJudged) return false;
  double less = 0;  // of the odd images, in sum
  double all = 0;
  for (std::size_t i = 1; i + 1 < kJudged; ++i) {
    const double around = (textures_[i - 1] + textures_[i + 1]) / 2;
    const double step = (i % 2 == 1 ? 1 : -1) * (around - textures_[i]);
    if (less * step < 0) return false;
    less += step;
    all += textures_[i];
  }
  first_ = less > 0 ? 1 : 0;
  return std::abs(less) > kLeast * all;
}

}  // namespace tolman::engine
