// SPDX-License-Identifier: BSD-3-Clause
#include "renderer.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "ray_packet.hpp"
#include "wide_lanes.hpp"

namespace tolman::town {
namespace {

/// Contrast below the noise of the camera, which is not smoothed: relative, and absolute radiance.
constexpr float kFaint = 0.04F;
constexpr float kDim = 0.012F;

/// A row, with pointers to each pixel's neighbours in one direction: before, here, after.
struct Neighbours {
  const float* radiance[3];
  const float* depth[3];
  const std::uint32_t* seen[3];
};

[[gnu::always_inline]] inline float inverseOf(float depth) { return depth > 0 ? 1 / depth : 0.0F; }

/// Whether a neighbour differs in radiance and belongs to another object, light or plane. Without
/// branches, so that loops over it are vectorised.
[[gnu::always_inline]] inline std::uint32_t differs(const Neighbours& of, int before, int here,
                                                    int after) {
  const float radiance = of.radiance[1][here];
  const float contrast = std::max(std::abs(of.radiance[0][before] - radiance),
                                  std::abs(of.radiance[2][after] - radiance));
  const std::uint32_t seen = of.seen[1][here];
  const std::uint32_t change = (of.seen[0][before] ^ seen) | (of.seen[2][after] ^ seen);
  // Inverse depth is linear over the image of a plane, so its second difference shows edges.
  const float inverse = inverseOf(of.depth[1][here]);
  const float bend = inverseOf(of.depth[0][before]) - 2 * inverse + inverseOf(of.depth[2][after]);
  const std::uint32_t bends = std::abs(bend) > 0.02F * inverse ? 1 : 0;
  const std::uint32_t has_faces = (seen & kFoliage) != 0 ? 0 : 1;
  const std::uint32_t is_visible = contrast < std::max(kDim, kFaint * radiance) ? 0 : 1;
  return is_visible & ((change != 0 ? 1U : 0U) | (bends & has_faces));
}

/// Sets `edges` of the pixels of a row: 1 where they need more rays than one.
TOLMAN_WIDE_LANES
void findEdges(const Neighbours& beside, const Neighbours& above, int width, std::uint32_t* edges) {
  const Neighbours b = beside;
  const Neighbours a = above;
  for (int c = 1; c < width - 1; ++c) {
    edges[c] = differs(b, c - 1, c, c + 1) | differs(a, c, c, c);
  }
  for (const int c : {0, width - 1}) {
    edges[c] = differs(b, std::max(c - 1, 0), c, std::min(c + 1, width - 1)) | differs(a, c, c, c);
  }
}

/// Positions within a pixel of the extra rays of edges, in pairs about its centre.
constexpr std::array<std::array<float, 2>, 8> kWithinPixel = {{{-0.25F, -0.33F},
                                                               {0.25F, 0.33F},
                                                               {0.4F, -0.12F},
                                                               {-0.4F, 0.12F},
                                                               {-0.12F, 0.25F},
                                                               {0.12F, -0.25F},
                                                               {-0.4F, -0.4F},
                                                               {0.4F, 0.4F}}};

}  // namespace

/// Rays of a view, whose directions have a component of 1 along the optical axis.
class Renderer::Rays {
 public:
  Rays(const Renderer& renderer, const RenderCamera& view)
      : width(view.width),
        warp_(view.warp != nullptr && !view.warp->isEmpty() ? view.warp : nullptr),
        cx_(static_cast<float>(view.pinhole.cx)),
        cy_(static_cast<float>(view.pinhole.cy)) {
    const Row middle = rowFrom(view.T_town_camera, view.pinhole);
    const Light& light = renderer.light_;
    const StreetLamps* lamps = light.lamps > 0 ? &renderer.scene_->lamps() : nullptr;
    around = {renderer.scene_, renderer.plan_, &light, lamps, middle.pixel_x, middle.pixel_y};
    if (view.T_town_rows.empty()) rows_.assign(1, middle);
    for (const Eigen::Isometry3d& T_town_row : view.T_town_rows) {
      rows_.push_back(rowFrom(T_town_row, view.pinhole));
    }
  }
  /// Adds a ray through a point of the pixel; (0, 0) is its centre.
  void add(RayPacket& packet, int column, int row, float x, float y) const {
    const Row& from = rows_[rows_.size() > 1 ? static_cast<std::size_t>(row) : 0];
    float u = static_cast<float>(column) + x;
    float v = static_cast<float>(row) + y;
    if (warp_ != nullptr) {
      u += warp_->x[index(column, row)];
      v += warp_->y[index(column, row)];
    }
    packet.add(from.origin, from.axis + from.pixel_x * (u - cx_) + from.pixel_y * (v - cy_));
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  int width;
  Surroundings around;

 private:
  struct Row {
    Vec3 origin, axis, pixel_x, pixel_y;
  };
  static Row rowFrom(const Eigen::Isometry3d& T_town_camera, const Pinhole& pinhole) {
    const Eigen::Matrix3d R = T_town_camera.linear();
    return {toVec3(T_town_camera.translation()), toVec3(R.col(2)), toVec3(R.col(0) / pinhole.fx),
            toVec3(R.col(1) / pinhole.fy)};
  }

  const PixelWarp* warp_;
  float cx_;
  float cy_;
  std::vector<Row> rows_;  // one, or one for each row of the image
};

/// In packets of 4 x 4 pixels, whose rays are closer together than those of rows of 16.
void Renderer::firstPass(const Rays& rays, int first_row, int end_row, RenderedImage& picture) {
  constexpr int kSide = 4;
  static_assert(kSide * kSide == kRaysPerPacket);
  RayPacket packet(rays.around);
  std::array<std::size_t, kRaysPerPacket> pixels{};
  for (int row = first_row; row < end_row; row += kSide) {
    for (int column = 0; column < rays.width; column += kSide) {
      for (int r = row; r < std::min(row + kSide, end_row); ++r) {
        for (int c = column; c < std::min(column + kSide, rays.width); ++c) {
          pixels[static_cast<std::size_t>(packet.size())] = rays.index(c, r);
          rays.add(packet, c, r, 0, 0);
        }
      }
      const auto count = static_cast<std::size_t>(packet.size());
      const auto shaded = packet.shade();
      for (std::size_t i = 0; i < count; ++i) {
        picture.radiance[pixels[i]] = shaded[i].radiance;
        picture.depth[pixels[i]] = shaded[i].depth;
        picture.instance[pixels[i]] = shaded[i].instance;
        seen_[pixels[i]] = shaded[i].seen;
      }
    }
  }
}

/// Column by column within the strip, so that the rays of a packet follow upright edges.
void Renderer::smoothEdges(const Rays& rays, int first_row, int end_row, RenderedImage& picture) {
  RayPacket packet(rays.around);
  std::array<std::size_t, kRaysPerPacket> pixels{};
  const float share = 1 / static_cast<float>(edge_samples_ + 1);  // with the ray of the centre
  const auto flush = [&] {
    const auto count = static_cast<std::size_t>(packet.size());
    const auto shaded = packet.shade();
    for (std::size_t i = 0; i < count; ++i) {
      picture.radiance[pixels[i]] += share * shaded[i].radiance;
    }
  };
  for (int column = 0; column < rays.width; ++column) {
    for (int row = first_row; row < end_row; ++row) {
      const std::size_t at = rays.index(column, row);
      if (edges_[at] == 0) continue;
      picture.radiance[at] *= share;
      for (int i = 0; i < edge_samples_; ++i) {
        const auto& [x, y] = kWithinPixel[static_cast<std::size_t>(i)];
        pixels[static_cast<std::size_t>(packet.size())] = at;
        rays.add(packet, column, row, x, y);
        if (packet.isFull()) flush();
      }
    }
  }
  flush();
}

void Renderer::render(const RenderCamera& view, RenderedImage& picture) {
  const auto pixels = static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height);
  picture.radiance.resize(pixels);
  picture.depth.resize(pixels);
  picture.instance.resize(pixels);
  seen_.resize(pixels);
  const Rays rays(*this, view);
  // Strips of equal height, so that packets do not depend on the number of threads.
  constexpr int kStrip = 8;
  const auto everyStrip = [&](auto&& body) {
    oneapi::tbb::parallel_for(0, (view.height + kStrip - 1) / kStrip, [&](int strip) {
      body(strip * kStrip, std::min((strip + 1) * kStrip, view.height));
    });
  };
  everyStrip([&](int first, int end) { firstPass(rays, first, end, picture); });
  if (edge_samples_ == 0) return;
  edges_.resize(pixels);
  // For all strips before any pixel is changed.
  everyStrip([&](int first, int end) {
    for (int row = first; row < end; ++row) {
      const auto around = [&](int reach) {
        Neighbours of = {};
        for (int i = 0; i < 3; ++i) {
          const std::size_t at =
              rays.index(0, std::clamp(row + reach * (i - 1), 0, view.height - 1));
          of.radiance[i] = picture.radiance.data() + at;
          of.depth[i] = picture.depth.data() + at;
          of.seen[i] = seen_.data() + at;
        }
        return of;
      };
      findEdges(around(0), around(1), view.width, edges_.data() + rays.index(0, row));
    }
  });
  everyStrip([&](int first, int end) { smoothEdges(rays, first, end, picture); });
}

}  // namespace tolman::town
