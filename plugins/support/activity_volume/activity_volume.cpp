// SPDX-License-Identifier: BSD-3-Clause
// Separable convolution, fractional shifts and the population vector.
#include "activity_volume.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>

#include "tolman/geometry.hpp"

namespace tolman {
namespace {

int wrapped(int value, int size) { return ((value % size) + size) % size; }

/// A shift in whole cells, and its fraction of a cell.
struct Shift {
  int cells;
  float rest;
};

Shift split(double shift) {
  const double whole = std::floor(shift);
  return {static_cast<int>(whole), static_cast<float>(shift - whole)};
}

double onCircle(double a, double b, int size) {
  const double half = 0.5 * size;
  return std::abs(wrapPeriod(b - a + half, size) - half);
}

/// Population vector of rates at the cells first, first + 1, ... of a circle.
double decoded(const std::vector<double>& rates, int first, int size) {
  const double turn = 2 * std::numbers::pi;
  std::complex<double> sum;
  for (std::size_t i = 0; i < rates.size(); ++i) {
    sum += std::polar(rates[i], turn * (first + static_cast<int>(i)) / size);
  }
  return wrapPeriod(std::arg(sum) / turn * size, size);
}

}  // namespace

std::vector<float> gaussianKernel(int width, double variance) {
  std::vector<float> kernel(static_cast<std::size_t>(width));
  const int centre = width / 2;
  for (int i = 0; i < width; ++i) {
    const double off = i - centre;
    kernel[static_cast<std::size_t>(i)] = static_cast<float>(std::exp(-off * off / (2 * variance)));
  }
  const float sum = std::accumulate(kernel.begin(), kernel.end(), 0.0F);
  for (float& weight : kernel) weight /= sum;
  return kernel;
}

ActivityVolume::ActivityVolume(int columns, int rows, int layers)
    : columns_(columns), rows_(rows), layers_(layers) {
  const auto all_rows = static_cast<std::size_t>(rows) * static_cast<std::size_t>(layers);
  for (Sheet* sheet : {&now_, &next_, &between_}) {
    sheet->values.resize(all_rows * static_cast<std::size_t>(columns));
    sheet->active.resize(all_rows);
  }
}

std::size_t ActivityVolume::rowOf(int y, int theta) const {
  return static_cast<std::size_t>(wrapped(theta, layers_)) * static_cast<std::size_t>(rows_) +
         static_cast<std::size_t>(wrapped(y, rows_));
}

float* ActivityVolume::row(Sheet& sheet, std::size_t index) const {
  return &sheet.values[index * static_cast<std::size_t>(columns_)];
}

float ActivityVolume::at(int x, int y, int theta) const {
  return now_.values[rowOf(y, theta) * static_cast<std::size_t>(columns_) +
                     static_cast<std::size_t>(wrapped(x, columns_))];
}

void ActivityVolume::add(int x, int y, int theta, float activity) {
  const std::size_t index = rowOf(y, theta);
  row(now_, index)[wrapped(x, columns_)] += activity;
  now_.active[index] = 1;
}

float ActivityVolume::total() const {
  float sum = 0;
  for (std::size_t r = 0; r < now_.active.size(); ++r) {
    if (now_.active[r] == 0) continue;
    const auto first = now_.values.begin() + static_cast<std::ptrdiff_t>(r) * columns_;
    sum = std::accumulate(first, first + columns_, sum);
  }
  return sum;
}

float ActivityVolume::around(int x, int y, int theta, int radius) const {
  float sum = 0;
  for (int k = -radius; k <= radius; ++k) {
    for (int j = -radius; j <= radius; ++j) {
      for (int i = -radius; i <= radius; ++i) sum += at(x + i, y + j, theta + k);
    }
  }
  return sum;
}

void ActivityVolume::silence(Sheet& sheet) const {
  for (std::size_t r = 0; r < sheet.active.size(); ++r) {
    if (sheet.active[r] != 0) std::fill_n(row(sheet, r), columns_, 0.0F);
  }
  std::ranges::fill(sheet.active, std::uint8_t{0});
}

void ActivityVolume::addRow(float weight, const float* from, Sheet& to, std::size_t to_row) const {
  float* out = row(to, to_row);
  for (int i = 0; i < columns_; ++i) out[i] += weight * from[i];
  to.active[to_row] = 1;
}

void ActivityVolume::spreadInto(Sheet& spread, std::span<const float> kernel) {
  const int radius = static_cast<int>(kernel.size()) / 2;
  silence(between_);
  silence(spread);
  for (int theta = 0; theta < layers_; ++theta) {
    for (int y = 0; y < rows_; ++y) {
      const std::size_t from = rowOf(y, theta);
      if (now_.active[from] == 0) continue;
      for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
        const int off = static_cast<int>(tap) - radius;
        addRow(kernel[tap], row(now_, from), between_, rowOf(y, theta + off));
      }
    }
  }
  for (int theta = 0; theta < layers_; ++theta) {
    for (int y = 0; y < rows_; ++y) {
      const std::size_t from = rowOf(y, theta);
      if (between_.active[from] == 0) continue;
      for (std::size_t tap = 0; tap < kernel.size(); ++tap) {
        const int off = static_cast<int>(tap) - radius;
        addRow(kernel[tap], row(between_, from), spread, rowOf(y + off, theta));
      }
    }
  }
  alongX(spread, kernel);
}

void ActivityVolume::alongX(Sheet& sheet, std::span<const float> kernel) {
  const auto radius = static_cast<std::ptrdiff_t>(kernel.size() / 2);
  padded_.resize(static_cast<std::size_t>(columns_) + kernel.size());
  for (std::size_t r = 0; r < sheet.active.size(); ++r) {
    if (sheet.active[r] == 0) continue;
    float* cells = row(sheet, r);
    std::copy_n(cells, columns_, padded_.begin() + radius);
    std::copy_n(cells + columns_ - radius, radius, padded_.begin());
    std::copy_n(cells, radius, padded_.begin() + radius + columns_);
    std::fill_n(cells, columns_, 0.0F);
    for (std::size_t k = 0; k < kernel.size(); ++k) addRow(kernel[k], &padded_[k], sheet, r);
  }
}

void ActivityVolume::excite(std::span<const float> kernel) {
  spreadInto(next_, kernel);
  std::swap(now_, next_);
}

void ActivityVolume::inhibit(std::span<const float> kernel) {
  spreadInto(next_, kernel);
  for (std::size_t r = 0; r < next_.active.size(); ++r) {
    if (next_.active[r] != 0) addRow(-1, row(next_, r), now_, r);
  }
}

void ActivityVolume::inhibitAll(float amount) {
  for (std::size_t r = 0; r < now_.active.size(); ++r) {
    if (now_.active[r] == 0) continue;
    float* cells = row(now_, r);
    float most = 0;
    for (int i = 0; i < columns_; ++i) {
      cells[i] = std::max(0.0F, cells[i] - amount);
      most = std::max(most, cells[i]);
    }
    now_.active[r] = most > 0 ? 1 : 0;
  }
}

void ActivityVolume::normalise() {
  const float sum = total();
  if (!(sum > 0)) return;
  const float scale = 1 / sum;
  for (std::size_t r = 0; r < now_.active.size(); ++r) {
    if (now_.active[r] == 0) continue;
    float* cells = row(now_, r);
    for (int i = 0; i < columns_; ++i) cells[i] *= scale;
  }
}

template <class ShiftOf>
void ActivityVolume::moveLayers(const ShiftOf& shift_of) {
  silence(next_);
  padded_.resize(static_cast<std::size_t>(columns_) + 1);
  for (int theta = 0; theta < layers_; ++theta) {
    const auto [x_shift, y_shift] = shift_of(theta);
    const Shift right = split(x_shift);
    const Shift up = split(y_shift);
    for (int y = 0; y < rows_; ++y) {
      const std::size_t from = rowOf(y, theta);
      if (now_.active[from] == 0) continue;
      const float* cells = row(now_, from);
      int source = wrapped(-right.cells - 1, columns_);  // one cell further than the whole shift
      for (int x = 0; x < columns_; ++x) {
        const float before = cells[source];
        source = source + 1 == columns_ ? 0 : source + 1;
        padded_[static_cast<std::size_t>(x)] =
            (1 - right.rest) * cells[source] + right.rest * before;
      }
      addRow(1 - up.rest, padded_.data(), next_, rowOf(y + up.cells, theta));
      addRow(up.rest, padded_.data(), next_, rowOf(y + up.cells + 1, theta));
    }
  }
  std::swap(now_, next_);
}

void ActivityVolume::move(double forward, double left) {
  moveLayers([&](int theta) {
    const double heading = 2 * std::numbers::pi * theta / layers_;
    return std::pair(std::cos(heading) * forward - std::sin(heading) * left,
                     std::sin(heading) * forward + std::cos(heading) * left);
  });
}

void ActivityVolume::shift(double x, double y, double theta) {
  moveLayers([&](int) { return std::pair(x, y); });
  turn(theta);
}

void ActivityVolume::attract(std::span<const float> excitation, std::span<const float> inhibition,
                             float global) {
  excite(excitation);
  inhibit(inhibition);
  inhibitAll(global);
  normalise();
}

void ActivityVolume::turn(double headings) {
  const Shift shift = split(headings);
  silence(next_);
  for (int theta = 0; theta < layers_; ++theta) {
    for (int y = 0; y < rows_; ++y) {
      const std::size_t from = rowOf(y, theta);
      if (now_.active[from] == 0) continue;
      addRow(1 - shift.rest, row(now_, from), next_, rowOf(y, theta + shift.cells));
      addRow(shift.rest, row(now_, from), next_, rowOf(y, theta + shift.cells + 1));
    }
  }
  std::swap(now_, next_);
}

CellPose ActivityVolume::peak(int radius) const {
  const auto best = static_cast<int>(std::ranges::max_element(now_.values) - now_.values.begin());
  const int x = best % columns_;
  const int y = best / columns_ % rows_;
  const int theta = best / (columns_ * rows_);
  const auto reach = [&](int size) { return std::min(radius, (size - 1) / 2); };
  const int reach_x = reach(columns_);
  const int reach_y = reach(rows_);
  const int reach_theta = reach(layers_);
  const auto along = [](int far) {
    return std::vector<double>(2 * static_cast<std::size_t>(far) + 1);
  };
  std::vector<double> along_x = along(reach_x);
  std::vector<double> along_y = along(reach_y);
  std::vector<double> along_theta = along(reach_theta);
  for (int k = -reach_theta; k <= reach_theta; ++k) {
    for (int j = -reach_y; j <= reach_y; ++j) {
      for (int i = -reach_x; i <= reach_x; ++i) {
        const auto rate = static_cast<double>(at(x + i, y + j, theta + k));
        along_x[static_cast<std::size_t>(i + reach_x)] += rate;
        along_y[static_cast<std::size_t>(j + reach_y)] += rate;
        along_theta[static_cast<std::size_t>(k + reach_theta)] += rate;
      }
    }
  }
  return {decoded(along_x, x - reach_x, columns_), decoded(along_y, y - reach_y, rows_),
          decoded(along_theta, theta - reach_theta, layers_)};
}

double ActivityVolume::distance(const CellPose& a, const CellPose& b) const {
  return std::hypot(onCircle(a.x, b.x, columns_), onCircle(a.y, b.y, rows_),
                    onCircle(a.theta, b.theta, layers_));
}

}  // namespace tolman
