// SPDX-License-Identifier: BSD-3-Clause
// Kernels are products of Gaussians, so each axis is convolved by itself.
#include "activity_torus.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman::neuroslam_cells {
namespace {

int wrapped(int value, int size) { return ((value % size) + size) % size; }

}  // namespace

std::vector<float> gaussianKernel(int width, double sigma) {
  const int middle = width / 2;
  std::vector<double> weights;
  for (int k = 0; k < width; ++k) {
    const double off = (k - middle) / sigma;
    weights.push_back(std::exp(-0.5 * off * off));
  }
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  std::vector<float> kernel;
  kernel.reserve(weights.size());
  for (const double weight : weights) kernel.push_back(static_cast<float>(weight / sum));
  return kernel;
}

ActivityTorus::ActivityTorus(const std::array<int, 3>& sizes) : sizes_(sizes) {
  std::size_t cells = 1;
  for (const int size : sizes) cells *= static_cast<std::size_t>(size);
  now_.resize(cells);
}

std::size_t ActivityTorus::indexOf(const std::array<int, 3>& cell) const {
  std::size_t index = 0;
  for (std::size_t axis = 3; axis-- > 0;) {
    index = index * static_cast<std::size_t>(sizes_[axis]) +
            static_cast<std::size_t>(wrapped(cell[axis], sizes_[axis]));
  }
  return index;
}

void ActivityTorus::add(const CellPlace& place, float activity) {
  std::array<int, 3> cell;
  for (std::size_t axis = 0; axis < 3; ++axis)
    cell[axis] = static_cast<int>(std::lround(place[axis]));
  now_[indexOf(cell)] += activity;
}

float ActivityTorus::total() const { return std::accumulate(now_.begin(), now_.end(), 0.0F); }

/// Neighbours along the axis are `stride` elements apart in memory.
void ActivityTorus::addShifted(const std::vector<float>& from, std::size_t axis, int cells,
                               float weight, std::vector<float>& out) const {
  std::size_t stride = 1;
  for (std::size_t faster = 0; faster < axis; ++faster) {
    stride *= static_cast<std::size_t>(sizes_[faster]);
  }
  const auto size = static_cast<std::size_t>(sizes_[axis]);
  const std::size_t moved = static_cast<std::size_t>(wrapped(cells, sizes_[axis])) * stride;
  const std::size_t round = size * stride;
  for (std::size_t begin = 0; begin < from.size(); begin += round) {
    const float* in = &from[begin];
    float* to = &out[begin];
    for (std::size_t k = 0; k < round - moved; ++k) to[k + moved] += weight * in[k];
    for (std::size_t k = round - moved; k < round; ++k) to[k + moved - round] += weight * in[k];
  }
}

std::vector<float> ActivityTorus::spread(std::span<const float> kernel) const {
  std::vector<float> result = now_;
  const auto radius = static_cast<int>(kernel.size() / 2);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sizes_[axis] == 1) continue;
    const std::vector<float> before = std::exchange(result, std::vector<float>(now_.size()));
    for (int k = -radius; k <= radius; ++k) {
      addShifted(before, axis, k, kernel[static_cast<std::size_t>(k + radius)], result);
    }
  }
  return result;
}

void ActivityTorus::attract(std::span<const float> excitation, std::span<const float> inhibition,
                            float global) {
  now_ = spread(excitation);
  const std::vector<float> lost = spread(inhibition);
  for (std::size_t k = 0; k < now_.size(); ++k) {
    now_[k] = std::max(0.0F, now_[k] - lost[k] - global);
  }
  const float sum = total();
  if (!(sum > 0)) return;
  for (float& value : now_) value /= sum;
}

void ActivityTorus::shift(const CellPlace& cells) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cells[axis] == 0 || sizes_[axis] == 1) continue;
    const double whole = std::floor(cells[axis]);
    const auto rest = static_cast<float>(cells[axis] - whole);
    const auto step = static_cast<int>(std::fmod(whole, sizes_[axis]));
    const std::vector<float> before = std::exchange(now_, std::vector<float>(now_.size()));
    addShifted(before, axis, step, 1 - rest, now_);
    addShifted(before, axis, step + 1, rest, now_);
  }
}

CellPlace ActivityTorus::peak(int radius) const {
  auto best = static_cast<int>(std::ranges::max_element(now_) - now_.begin());
  std::array<int, 3> strongest;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    strongest[axis] = best % sizes_[axis];
    best /= sizes_[axis];
  }
  std::array<std::complex<double>, 3> sum;
  std::array<int, 3> off;
  const auto reach = [&](std::size_t axis) { return std::min(radius, (sizes_[axis] - 1) / 2); };
  for (off[2] = -reach(2); off[2] <= reach(2); ++off[2]) {
    for (off[1] = -reach(1); off[1] <= reach(1); ++off[1]) {
      for (off[0] = -reach(0); off[0] <= reach(0); ++off[0]) {
        const auto rate = static_cast<double>(
            at({strongest[0] + off[0], strongest[1] + off[1], strongest[2] + off[2]}));
        for (std::size_t axis = 0; axis < 3; ++axis) {
          sum[axis] += std::polar(rate, 2 * std::numbers::pi * off[axis] / sizes_[axis]);
        }
      }
    }
  }
  CellPlace place;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double mean = std::arg(sum[axis]) / (2 * std::numbers::pi) * sizes_[axis];
    place[axis] = wrapPeriod(strongest[axis] + mean, sizes_[axis]);
  }
  return place;
}

double ActivityTorus::away(std::size_t axis, double from, double to) const {
  const double half = 0.5 * sizes_[axis];
  return wrapPeriod(to - from + half, sizes_[axis]) - half;
}

}  // namespace tolman::neuroslam_cells
