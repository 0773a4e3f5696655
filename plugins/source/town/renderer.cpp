// SPDX-License-Identifier: BSD-3-Clause
#include "renderer.hpp"

#include <oneapi/tbb/parallel_for.h>

#include <array>
#include <cmath>

#include "edges.hpp"
#include "ray_packet.hpp"

namespace tolman::town {
namespace {

/// Positions within a pixel of the extra rays of edges, in pairs about its centre.
constexpr std::array<std::array<float, 2>, 8> kWithinPixel = {{{-0.25F, -0.33F},
                                                               {0.25F, 0.33F},
                                                               {0.4F, -0.12F},
                                                               {-0.4F, 0.12F},
                                                               {-0.12F, 0.25F},
                                                               {0.12F, -0.25F},
                                                               {-0.4F, -0.4F},
                                                               {0.4F, 0.4F}}};

Vec3 toVec3(const Eigen::Vector3d& v) {
  return {static_cast<float>(v.x()), static_cast<float>(v.y()), static_cast<float>(v.z())};
}

}  // namespace

/// Rays of a view, whose directions have a component of 1 along the optical axis.
class Renderer::Rays {
 public:
  Rays(const Renderer& renderer, const RenderCamera& view)
      : width(view.width),
        height(view.height),
        warp_(view.warp != nullptr && !view.warp->isEmpty() ? view.warp : nullptr),
        cx_(static_cast<float>(view.pinhole.cx)),
        cy_(static_cast<float>(view.pinhole.cy)) {
    around.scene = renderer.scene_;
    around.plan = renderer.plan_;
    around.light = &renderer.light_;
    around.lamps = renderer.light_.lamps > 0 ? &renderer.scene_->lamps() : nullptr;
    const Row middle = rowFrom(view.T_town_camera, view.pinhole);
    around.pixel_x = middle.pixel_x;
    around.pixel_y = middle.pixel_y;
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
      const std::size_t at = index(column, row);
      u += warp_->x[at];
      v += warp_->y[at];
    }
    packet.add(from.origin, from.axis + from.pixel_x * (u - cx_) + from.pixel_y * (v - cy_));
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
           static_cast<std::size_t>(column);
  }

  int width;
  int height;
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
  everyStrip([&](int first, int end) {  // for all strips before any pixel is changed
    const FirstLook look = {picture.radiance, picture.depth, seen_, view.width, view.height};
    for (int row = first; row < end; ++row) {
      findEdges(look, row, edges_.data() + rays.index(0, row));
    }
  });
  everyStrip([&](int first, int end) { smoothEdges(rays, first, end, picture); });
}

}  // namespace tolman::town
