// SPDX-License-Identifier: BSD-3-Clause
#include "shutter_blur.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "image_samples.hpp"

namespace tolman::town {
namespace {

constexpr float kSharp = 0.1F;   ///< px; shorter paths are not blurred; bounds the computing time
constexpr int kMaxSamples = 17;  ///< per pixel; bounds the computing time
constexpr int kTile = 16;        ///< px
constexpr float kNearer = 0.9F;  ///< share of the depth; a surface nearer than this is another one
constexpr float kSameWay = 1;    ///< px; paths that differ by less count as one motion
constexpr float kBreak = 0.5F;   ///< px; neighbours whose paths differ by more are a silhouette

/// What may cover a pixel for a part of the shutter time.
struct Around {
  Path longest;
  bool has_silhouette = false;  ///< two neighbouring pixels move differently
};

/// For each tile, what is in it and in the eight around it.
class Tiles {
 public:
  Tiles(const PixelPaths& paths, int width, int height)
      : columns_((width + kTile - 1) / kTile), rows_((height + kTile - 1) / kTile) {
    std::vector<Around> own(static_cast<std::size_t>(columns_ * rows_));
    oneapi::tbb::parallel_for(0, rows_, [&](int row) {
      for (int r = row * kTile; r < std::min((row + 1) * kTile, height); ++r) {
        const std::size_t first = static_cast<std::size_t>(r) * static_cast<std::size_t>(width);
        const std::size_t below = r + 1 < height ? static_cast<std::size_t>(width) : 0;
        for (int c = 0; c < width; ++c) {
          const std::size_t i = first + static_cast<std::size_t>(c);
          const std::size_t right = c + 1 < width ? 1 : 0;
          addTo(own[tile(c / kTile, row)],
                {paths.at(i), isBreak(paths, i, i + right) || isBreak(paths, i, i + below)});
        }
      }
    });
    around_ = own;
    for (int n = 0; n < 9 * columns_ * rows_; ++n) {
      const int c = n / 9 % columns_;
      const int r = n / 9 / columns_;
      addTo(around_[tile(c, r)], own[tile(std::clamp(c + n % 3 - 1, 0, columns_ - 1),
                                          std::clamp(r + n / 3 % 3 - 1, 0, rows_ - 1))]);
    }
  }
  const Around& at(int column, int row) const { return around_[tile(column / kTile, row / kTile)]; }

 private:
  std::size_t tile(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  static bool isBreak(const PixelPaths& paths, std::size_t a, std::size_t b) {
    return (paths.at(a) - paths.at(b)).square() > kBreak * kBreak;
  }
  static void addTo(Around& sum, const Around& other) {
    if (other.longest.square() > sum.longest.square()) sum.longest = other.longest;
    sum.has_silhouette = sum.has_silhouette || other.has_silhouette;
  }

  int columns_;
  int rows_;
  std::vector<Around> around_;
};

/// Means of an image along the paths of its pixels.
class Gatherer {
 public:
  Gatherer(const RenderCamera& view, const std::vector<float>& sharp, const PixelPaths& paths)
      : samples_{sharp, view.width, view.height}, paths_(paths) {}

  std::size_t index(int column, int row) const { return samples_.index(column, row); }

  /// Mean of samples at the middles of equal intervals of the shutter time.
  float mean(int column, int row, const Around& around) const {
    const std::size_t i = index(column, row);
    const Path own = paths_.at(i);
    const Path& longest = around.longest;
    const bool is_alone = !around.has_silhouette || (longest - own).square() < kSameWay * kSameWay;
    const float square = std::max(own.square(), is_alone ? 0 : longest.square());
    if (square < kSharp * kSharp) return samples_.values[i];
    const float length = std::sqrt(square);
    const int count = std::clamp(2 + static_cast<int>(std::ceil(length)), 3, kMaxSamples);
    const float step = 1 / static_cast<float>(count);
    const Pixel pixel = {static_cast<float>(column), static_cast<float>(row), own, paths_.z[i]};
    const auto sumOf = [&](auto&& at) {
      float sum = 0;
      for (int k = 0; k < count; ++k) sum += at((static_cast<float>(k) + 0.5F) * step - 0.5F);
      return sum * step;
    };
    if (!is_alone) return sumOf([&](float t) { return atTime(pixel, longest, t); });
    const float reach_u = 0.5F * std::abs(own.u);
    const float reach_v = 0.5F * std::abs(own.v);
    const bool is_inside = pixel.column >= reach_u && pixel.row >= reach_v &&
                           pixel.column + reach_u < static_cast<float>(samples_.width - 1) &&
                           pixel.row + reach_v < static_cast<float>(samples_.height - 1);
    if (!is_inside) return sumOf([&](float t) { return along(pixel, own, t); });
    return sumOf(
        [&](float t) { return samples_.inside(pixel.column - t * own.u, pixel.row - t * own.v); });
  }

 private:
  struct Pixel {
    float column;
    float row;
    Path path;
    float z;
  };

  float along(const Pixel& p, const Path& path, float t) const {
    return samples_.at(p.column - t * path.u, p.row - t * path.v);
  }
  std::size_t nearestTo(const Pixel& p, const Path& path, float t) const {
    const float u = std::clamp(p.column - t * path.u, 0.0F, static_cast<float>(samples_.width - 1));
    const float v = std::clamp(p.row - t * path.v, 0.0F, static_cast<float>(samples_.height - 1));
    return index(static_cast<int>(u + 0.5F), static_cast<int>(v + 0.5F));
  }
  /// Whether the surface at pixel `i` is in front of the pixel's own and moves differently.
  bool isInFront(const Pixel& p, std::size_t i, float t) const {
    return paths_.z[i] < kNearer * p.z && t * t * (paths_.at(i) - p.path).square() > 0.25F;
  }
  /// What the pixel shows at time t: a surface in front of its own that moves differently and has
  /// arrived there, or its own. From -0.5 at the beginning to 0.5 at the end of the shutter time.
  float atTime(const Pixel& p, const Path& longest, float t) const {
    const Path front = paths_.at(nearestTo(p, longest, t));
    const std::size_t met = nearestTo(p, front, t);
    if (isInFront(p, met, t) && t * t * (paths_.at(met) - front).square() < kSameWay * kSameWay) {
      return along(p, front, t);
    }
    // Where the pixel's own surface is hidden in the sharp image, the pixel's value replaces it.
    const bool is_hidden = isInFront(p, nearestTo(p, p.path, t), t);
    return is_hidden ? samples_.values[index(static_cast<int>(p.column), static_cast<int>(p.row))]
                     : along(p, p.path, t);
  }

  ImageSamples samples_;
  const PixelPaths& paths_;
};

}  // namespace

std::vector<float> shutterBlur(const RenderCamera& view, const RenderedImage& sharp,
                               const OpenShutter& shutter) {
  const PixelPaths paths = pixelPaths(view, sharp, shutter);
  const Tiles tiles(paths, view.width, view.height);
  const Gatherer gatherer(view, sharp.radiance, paths);
  std::vector<float> blurred(sharp.radiance.size());
  oneapi::tbb::parallel_for(0, view.height, [&](int row) {
    for (int column = 0; column < view.width; ++column) {
      blurred[gatherer.index(column, row)] = gatherer.mean(column, row, tiles.at(column, row));
    }
  });
  return blurred;
}

}  // namespace tolman::town
