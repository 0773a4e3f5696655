// SPDX-License-Identifier: BSD-3-Clause
#include "shutter_blur.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "wide_lanes.hpp"

namespace tolman::town {

namespace {

/// Means over the window around each value of the lines from `first` to `end` of an image, rows or
/// columns: `along` floats from one value of a line to the next, `across` from line to line.
/// Several lines at once, because the sums of one wait for each other, and single columns use 4
/// bytes of each line of the cache.
struct SlidingMeans {
  static constexpr int kLines = 16;
  const float* from;
  float* to;
  std::ptrdiff_t along, across;
  int length, radius;

  void operator()(int first, int end) const {
    std::array<double, kLines> sums{};
    const float* source = from + first * across;
    float* target = to + first * across;
    const auto add = [&](int at, double sign) {
      for (int line = 0; line < end - first; ++line) {
        sums[static_cast<std::size_t>(line)] +=
            sign * static_cast<double>(source[at * along + line * across]);
      }
    };
    for (int i = 0; i < std::min(radius, length); ++i) add(i, 1);
    for (int i = 0; i < length; ++i) {
      if (i + radius < length) add(i + radius, 1);
      if (i - radius > 0) add(i - radius - 1, -1);
      const int inside = std::min(i + radius, length - 1) - std::max(i - radius, 0) + 1;
      for (int line = 0; line < end - first; ++line) {
        target[i * along + line * across] =
            static_cast<float>(sums[static_cast<std::size_t>(line)] / inside);
      }
    }
  }
  void ofAll(int lines) const {
    oneapi::tbb::parallel_for(0, (lines + kLines - 1) / kLines, [&](int group) {
      (*this)(group * kLines, std::min((group + 1) * kLines, lines));
    });
  }
};

}  // namespace

std::vector<float> boxBlur(const std::vector<float>& values, int width, int height, int radius) {
  std::vector<float> rows(values.size());
  std::vector<float> result(values.size());
  SlidingMeans{values.data(), rows.data(), 1, width, width, radius}.ofAll(height);
  SlidingMeans{rows.data(), result.data(), width, 1, height, radius}.ofAll(width);
  return result;
}

namespace {

constexpr float kSkyDepth = 1e4F;      ///< m; stands for infinity
constexpr float kNearestDepth = 0.1F;  ///< m in front of the camera; keeps the projection finite

/// A pinhole camera in the middle, at the beginning and at the end of the shutter time.
struct Projections {
  explicit Projections(const Pinhole& pinhole, const ShutterMotion& motion)
      : fx(static_cast<float>(pinhole.fx)),
        fy(static_cast<float>(pinhole.fy)),
        cx(static_cast<float>(pinhole.cx)),
        cy(static_cast<float>(pinhole.cy)),
        begin(rowsOf(motion.T_begin_middle)),
        end(rowsOf(motion.T_end_middle)) {}

  using Rows = std::array<std::array<float, 4>, 3>;
  static Rows rowsOf(const Eigen::Isometry3d& T) {
    Rows rows;
    Eigen::Map<Eigen::Matrix<float, 3, 4, Eigen::RowMajor>>(rows[0].data()) =
        T.matrix().topRows<3>().cast<float>();
    return rows;
  }

  float fx, fy, cx, cy;
  Rows begin, end;
};

/// A part of a row of the image.
struct PartOfRow {
  int row;
  int first;
  int count;
};

/// A plain loop, so that the compiler vectorises it.
TOLMAN_WIDE_LANES
void findPaths(const Projections& p, const PartOfRow& part, float* z, float* u, float* v) {
  const auto [b0, b1, b2] = p.begin;
  const auto [e0, e1, e2] = p.end;
  const float ray_y = (static_cast<float>(part.row) - p.cy) / p.fy;
  for (int i = 0; i < part.count; ++i) {
    const float depth = z[i] > 0 ? z[i] : kSkyDepth;
    const float x = depth * ((static_cast<float>(part.first + i) - p.cx) / p.fx);
    const float y = depth * ray_y;
    const float begin_z = b2[0] * x + b2[1] * y + b2[2] * depth + b2[3];
    const float end_z = e2[0] * x + e2[1] * y + e2[2] * depth + e2[3];
    const float to_begin = 1 / begin_z;
    const float to_end = 1 / end_z;
    const float way_u = p.fx * ((e0[0] * x + e0[1] * y + e0[2] * depth + e0[3]) * to_end -
                                (b0[0] * x + b0[1] * y + b0[2] * depth + b0[3]) * to_begin);
    const float way_v = p.fy * ((e1[0] * x + e1[1] * y + e1[2] * depth + e1[3]) * to_end -
                                (b1[0] * x + b1[1] * y + b1[2] * depth + b1[3]) * to_begin);
    const bool is_behind = begin_z < kNearestDepth || end_z < kNearestDepth;
    const float length = std::sqrt(way_u * way_u + way_v * way_v);
    const float kept = is_behind ? 0.0F : length > kLongestPath ? kLongestPath / length : 1.0F;
    z[i] = depth;
    u[i] = is_behind ? 0.0F : kept * way_u;
    v[i] = is_behind ? 0.0F : kept * way_v;
  }
}

/// Motion of a point of the object in the axes of the camera.
ShutterMotion seenBy(const Eigen::Isometry3d& T_town_camera, const ShutterMotion& camera,
                     const ShutterMotion& object) {
  const Eigen::Isometry3d T_camera_town = T_town_camera.inverse();
  return {camera.T_begin_middle * T_camera_town * object.T_begin_middle * T_town_camera,
          camera.T_end_middle * T_camera_town * object.T_end_middle * T_town_camera};
}

}  // namespace

PixelPaths pixelPaths(const RenderCamera& view, const RenderedImage& picture,
                      const OpenShutter& shutter) {
  const std::size_t pixels = picture.depth.size();
  PixelPaths paths = {std::vector<float>(pixels), std::vector<float>(pixels), picture.depth};
  const Projections fixed(view.pinhole, shutter.camera);
  std::vector<Projections> moving;
  for (const ShutterMotion& object : shutter.objects) {
    moving.emplace_back(view.pinhole, seenBy(view.T_town_camera, shutter.camera, object));
  }
  oneapi::tbb::parallel_for(0, view.height, [&](int row) {
    const auto width = static_cast<std::size_t>(view.width);
    const std::size_t at = static_cast<std::size_t>(row) * width;
    findPaths(fixed, {row, 0, view.width}, &paths.z[at], &paths.u[at], &paths.v[at]);
    for (std::size_t i = 0; i < width && !moving.empty(); ++i) {
      // Wraps around to a large number for instances before the first object.
      const std::uint32_t object = picture.instance[at + i] - shutter.first_object;
      if (object >= moving.size()) continue;
      findPaths(moving[object], {row, static_cast<int>(i), 1}, &paths.z[at + i], &paths.u[at + i],
                &paths.v[at + i]);
    }
  });
  return paths;
}

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
