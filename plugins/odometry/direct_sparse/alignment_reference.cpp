// SPDX-License-Identifier: BSD-3-Clause
// Projection into the newest keyframe and the derivatives of each sample.
#include <tbb/parallel_for.h>

#include <algorithm>

#include "alignment.hpp"
#include "gradient_samples.hpp"
#include "photometric_residual.hpp"

namespace tolman::direct_sparse {
namespace {

constexpr float kReferenceMargin = 2;  // px, for the central differences

struct Offset {
  float u;
  float v;
};
/// Offsets, px, of the samples of a point, which share its depth: diagonal neighbours on fine
/// levels, direct neighbours on coarse ones. As in DSO (Engel et al.)
constexpr std::array<Offset, 5> kFine = {{{0, 0}, {-1, -1}, {1, -1}, {-1, 1}, {1, 1}}};
constexpr std::array<Offset, 5> kCoarse = {{{0, 0}, {-1, 0}, {1, 0}, {0, -1}, {0, 1}}};

}  // namespace

void ReferenceLevel::makeRoom(std::size_t most) {
  const std::size_t size = (most + kGroup - 1) / kGroup * kGroup;
  for (auto* array : {&x, &y, &d, &value, &weight}) array->resize(std::max(size, array->size()));
  for (auto& array : by_twist) array.resize(std::max(size, array.size()));
  count = 0;
}

void ReferenceLevel::pad() {
  for (std::size_t i = count; i < groups() * kGroup; ++i) {
    x[i] = y[i] = d[i] = value[i] = weight[i] = 0;
    for (auto& array : by_twist) array[i] = 0;
  }
}

void AlignmentReference::project(const CameraRig& rig, const Window& window) {
  projected_.clear();
  const Keyframe& newest = window.newest();
  for (const int host : window.order()) {
    const Keyframe& keyframe = window.keyframe(host);
    if (host == window.newestSlot()) {
      for (const Point& p : keyframe.points) projected_.push_back({p.u, p.v, p.inverse_depth});
      continue;
    }
    const PairGeometry pair = pairGeometry(rig.pinhole, keyframe, newest);
    const auto& m = pair.warp;
    for (const Point& p : keyframe.points) {
      const auto slot = static_cast<std::size_t>(window.newestSlot());
      if (p.temporal[slot] != ResidualState::Good) continue;
      const float z = m[6] * p.u + m[7] * p.v + m[8] + pair.shift[2] * p.inverse_depth;
      if (!(z > 1e-3F)) continue;
      projected_.push_back({(m[0] * p.u + m[1] * p.v + m[2] + pair.shift[0] * p.inverse_depth) / z,
                            (m[3] * p.u + m[4] * p.v + m[5] + pair.shift[1] * p.inverse_depth) / z,
                            p.inverse_depth / z});
    }
  }
}

void AlignmentReference::placeSamples(const GrayLevel& image, int l) {
  ReferenceLevel& level = samples_[static_cast<std::size_t>(l)];
  const auto& offsets = l < 2 ? kFine : kCoarse;
  level.makeRoom(projected_.size() * offsets.size());
  std::vector<unsigned char>& taken = taken_[static_cast<std::size_t>(l)];
  taken.assign(image.pixels.size(), 0);
  for (const Projected& point : projected_) {
    for (const Offset& offset : offsets) {
      const float u = toLevel(point.u, l) + offset.u;
      const float v = toLevel(point.v, l) + offset.v;
      if (!image.contains(u, v, kReferenceMargin)) continue;
      const auto pixel = static_cast<std::size_t>(static_cast<int>(v + 0.5F) * image.width +
                                                  static_cast<int>(u + 0.5F));
      if (taken[pixel] != 0) continue;
      taken[pixel] = 1;
      level.x[level.count] = u;
      level.y[level.count] = v;
      level.d[level.count++] = point.d;
    }
  }
  for (std::size_t i = level.count; i < level.groups() * ReferenceLevel::kGroup; ++i) {
    level.x[i] = level.y[i] = kReferenceMargin;  // within the image; removed by pad()
    level.d[i] = 0;
  }
}

TOLMAN_WIDE_LANES void AlignmentReference::sampleLevel(const CameraRig& rig, const GrayLevel& image,
                                                       int l) {
  ReferenceLevel& level = samples_[static_cast<std::size_t>(l)];
  const float scale = 1.0F / static_cast<float>(1 << l);
  const float fx = static_cast<float>(rig.pinhole.fx) * scale;
  const float fy = static_cast<float>(rig.pinhole.fy) * scale;
  const float cx = toLevel(static_cast<float>(rig.pinhole.cx), l);
  const float cy = toLevel(static_cast<float>(rig.pinhole.cy), l);
  for (std::size_t i = 0; i < level.count; i += ReferenceLevel::kGroup) {
    const Eight u = loadEight(level.x.data() + i);
    const Eight v = loadEight(level.y.data() + i);
    const Eight d = loadEight(level.d.data() + i);
    const Eight gx = 0.5F * (bilinear(image, u + 1.0F, v) - bilinear(image, u - 1.0F, v));
    const Eight gy = 0.5F * (bilinear(image, u, v + 1.0F) - bilinear(image, u, v - 1.0F));
    const Eight x = (u - cx) / fx;
    const Eight y = (v - cy) / fy;
    const Eight gu = fx * gx;
    const Eight gv = fy * gy;
    const Eight along = x * gu + y * gv;
    store(x, level.x.data() + i);
    store(y, level.y.data() + i);
    store(bilinear(image, u, v), level.value.data() + i);
    store(kGradientConstant2 / (kGradientConstant2 + (gx * gx + gy * gy)), level.weight.data() + i);
    store(gu * d, level.by_twist[0].data() + i);
    store(gv * d, level.by_twist[1].data() + i);
    store(-along * d, level.by_twist[2].data() + i);
    store(-gv - y * along, level.by_twist[3].data() + i);
    store(gu + x * along, level.by_twist[4].data() + i);
    store(x * gv - y * gu, level.by_twist[5].data() + i);
  }
  level.pad();
}

void AlignmentReference::build(const CameraRig& rig, const Window& window) {
  project(rig, window);
  const ImagePyramid& pyramid = window.newest().left;
  levels_ = pyramid.levels();
  frame_ = window.newest().frame;
  tbb::parallel_for(0, levels_, [&](int l) {
    placeSamples(pyramid.level(l), l);
    sampleLevel(rig, pyramid.level(l), l);
  });
}

}  // namespace tolman::direct_sparse
