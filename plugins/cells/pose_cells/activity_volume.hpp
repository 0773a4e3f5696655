// SPDX-License-Identifier: BSD-3-Clause
// A block of cells over (x, y, theta) that wraps on all three axes: RatSLAM's continuous attractor.
// Most of it is silent most of the time, so work is done row by row (along x) where there is any.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tolman::pose_cells {

/// A place in the volume, in cells, each axis in [0, size).
struct CellPose {
  double x = 0;
  double y = 0;
  double theta = 0;
};

/// A Gaussian of odd width, its weights adding up to one.
std::vector<float> gaussianKernel(int width, double variance);

class ActivityVolume {
 public:
  /// `side` cells in x and y, `headings` in theta; all silent.
  ActivityVolume(int side, int headings);

  int side() const { return side_; }
  int headings() const { return headings_; }
  std::span<const float> values() const { return now_.values; }  ///< theta-major, then y, then x
  float at(int x, int y, int theta) const;
  void add(int x, int y, int theta, float activity);
  float total() const;
  /// Activity of the cells at most `radius` away on each axis.
  float around(int x, int y, int theta, int radius) const;

  /// Every cell spreads its activity: a product of three kernels, so one axis after the other.
  void excite(std::span<const float> kernel);
  /// The same spread is taken away. May leave negative cells.
  void inhibit(std::span<const float> kernel);
  /// Takes a constant from every cell, stopping at zero.
  void inhibitAll(float amount);
  /// Total activity one; an empty volume stays empty.
  void normalise();

  /// Path integration: each layer moves by (forward, left) cells seen along its own heading, then
  /// all layers turn. Any length; what falls between cells is split.
  void move(double forward, double left);
  void turn(double headings);

  /// The activity round the strongest cell, each axis as a population vector.
  CellPose peak(int radius) const;
  /// Length of the short way, theta included.
  double distance(const CellPose& a, const CellPose& b) const;

 private:
  /// All cells, and which rows are not silent.
  struct Sheet {
    std::vector<float> values;
    std::vector<std::uint8_t> active;
  };
  std::size_t rowOf(int y, int theta) const;
  float* row(Sheet& sheet, std::size_t index) const;
  void silence(Sheet& sheet) const;
  /// to += weight * from, for one row of the sheets.
  void addRow(float weight, const float* from, Sheet& to, std::size_t to_row) const;
  /// `spread` = the activity spread by the kernel.
  void spreadInto(Sheet& spread, std::span<const float> kernel);
  void alongX(Sheet& sheet, std::span<const float> kernel);

  int side_;
  int headings_;
  Sheet now_;
  Sheet next_;
  Sheet between_;
  std::vector<float> padded_;
};

}  // namespace tolman::pose_cells
