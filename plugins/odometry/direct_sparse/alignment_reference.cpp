// SPDX-License-Identifier: BSD-3-Clause
// Projection into the newest keyframe and the derivatives of each sample.
#include "alignment_reference.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>

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

void AlignmentReference::sampleLevel(const CameraRig& rig, const GrayLevel& image, int l) {
  ReferenceLevel& level = samples_[static_cast<std::size_t>(l)];
  const auto& offsets = l < 2 ? kFine : kCoarse;
  level.makeRoom(projected_.size() * offsets.size());
  std::vector<unsigned char>& taken = taken_[static_cast<std::size_t>(l)];
  taken.assign(image.pixels.size(), 0);
  const float scale = 1.0F / static_cast<float>(1 << l);
  const float fx = static_cast<float>(rig.pinhole.fx) * scale;
  const float fy = static_cast<float>(rig.pinhole.fy) * scale;
  const float cx = toLevel(static_cast<float>(rig.pinhole.cx), l);
  const float cy = toLevel(static_cast<float>(rig.pinhole.cy), l);
  for (const Projected& point : projected_) {
    for (const Offset& offset : offsets) {
      const float u = toLevel(point.u, l) + offset.u;
      const float v = toLevel(point.v, l) + offset.v;
      if (!image.contains(u, v, kReferenceMargin)) continue;
      const auto pixel = static_cast<std::size_t>(static_cast<int>(v + 0.5F) * image.width +
                                                  static_cast<int>(u + 0.5F));
      if (taken[pixel] != 0) continue;
      taken[pixel] = 1;
      const float gx = 0.5F * (image.at(u + 1, v) - image.at(u - 1, v));
      const float gy = 0.5F * (image.at(u, v + 1) - image.at(u, v - 1));
      const float x = (u - cx) / fx;
      const float y = (v - cy) / fy;
      const float gu = fx * gx;
      const float gv = fy * gy;
      const float along = x * gu + y * gv;
      const std::size_t i = level.count++;
      level.x[i] = x;
      level.y[i] = y;
      level.d[i] = point.d;
      level.value[i] = image.at(u, v);
      level.weight[i] = gradientWeight(gx * gx + gy * gy);
      const std::array<float, 6> J = {gu * point.d,    gv * point.d,   -along * point.d,
                                      -gv - y * along, gu + x * along, x * gv - y * gu};
      for (std::size_t k = 0; k < J.size(); ++k) level.by_twist[k][i] = J[k];
    }
  }
  level.pad();
}

void AlignmentReference::build(const CameraRig& rig, const Window& window) {
  project(rig, window);
  const ImagePyramid& pyramid = window.newest().left;
  levels_ = pyramid.levels();
  frame_ = window.newest().frame;
  tbb::parallel_for(0, levels_, [&](int l) { sampleLevel(rig, pyramid.level(l), l); });
}

}  // namespace tolman::direct_sparse
