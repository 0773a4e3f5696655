// SPDX-License-Identifier: BSD-3-Clause
// A block of cells over (x, y, theta) that wraps on all three axes: RatSLAM's continuous attractor,
// and those of NeuroSLAM, whose third axis is a height. Most cells are inactive, so only the rows
// (along x) with activity are processed.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tolman {

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
  /// Cells along each axis; none is active.
  ActivityVolume(int columns, int rows, int layers);

  std::span<const float> values() const { return now_.values; }  ///< theta-major, then y, then x
  float at(int x, int y, int theta) const;
  void add(int x, int y, int theta, float activity);
  float total() const;
  /// Activity of the cells at most `radius` away on each axis.
  float around(int x, int y, int theta, int radius) const;

  /// Convolves the activity with the kernel along each axis.
  void excite(std::span<const float> kernel);
  /// Subtracts the convolution with the kernel. Cells may become negative.
  void inhibit(std::span<const float> kernel);
  /// Subtracts a constant from every cell; negative cells become zero.
  void inhibitAll(float amount);
  /// Scales the total activity to one; an empty volume does not change.
  void normalise();
  /// One step of the attractor: all of these, in this order.
  void attract(std::span<const float> excitation, std::span<const float> inhibition, float global);

  /// Path integration: moves each layer by (forward, left) cells in the axes of its own heading, of
  /// any length; fractions are split between two neighbours.
  void move(double forward, double left);
  void turn(double headings);
  /// Moves all activity by so many cells along each axis.
  void shift(double x, double y, double theta);

  /// Population vector along each axis, over the cells at most `radius` from the strongest one.
  CellPose peak(int radius) const;
  /// Shortest distance in cells, theta included.
  double distance(const CellPose& a, const CellPose& b) const;

 private:
  /// All cells, and which rows have activity.
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

  /// Moves each layer along x and y by what `shift_of` has for it.
  template <class ShiftOf>
  void moveLayers(const ShiftOf& shift_of);

  int columns_;
  int rows_;
  int layers_;
  Sheet now_;
  Sheet next_;
  Sheet between_;
  std::vector<float> padded_;
};

}  // namespace tolman
