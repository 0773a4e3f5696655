// SPDX-License-Identifier: BSD-3-Clause
// Vertical errors of the rectification: their estimate, and images without them.
//
// Resamples an image whose rows a smooth field displaces by fractions of a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "disparity_field.hpp"
#include "pyramid.hpp"

namespace tolman::direct_sparse {

class RowShift {
 public:
  /// Displacement down the columns, px, for images of this size.
  void set(const SmoothField& field, int width, int height);
  /// Images are left as they are.
  void setNone() { steps_.clear(); }
  /// image(u, v) becomes image(u, v + field(u, v)), by Catmull-Rom; beyond the first and the last
  /// row the outermost one is repeated.
  void apply(GrayLevel& image);
  /// px, the field as it is applied: constant in blocks, in steps of 1/32 px.
  double at(double u, double v) const;

 private:
  int width_ = 0;
  int height_ = 0;
  int across_ = 0;                   ///< blocks in a row
  std::vector<std::int16_t> steps_;  ///< of 1/32 px, a block each, row by row; empty: none
  std::vector<std::uint8_t> buffer_;
};

// The costs of a row search: sums of absolute differences of a patch at each pixel of a row.

/// Size, px; columns -4 ... 3 and rows -2 ... 2 around the pixel. Chosen, not tuned.
inline constexpr int kPatchWidth = 8;
inline constexpr int kPatchHeight = 5;

using StereoPatch = std::array<std::uint8_t, kPatchWidth * kPatchHeight>;

/// Further costs that rowCosts() may write behind the last one; `costs` must have room for them.
inline constexpr int kMoreCosts = 8;

/// The cost of each pixel (u, v) with `u_begin` <= u < `u_end`, beginning with that of `u_begin`.
/// At each of these pixels the patch must lie within the image, and three more rows below it.
void rowCosts(const StereoPatch& patch, const GrayLevel& image, int u_begin, int u_end, int v,
              std::uint16_t* costs);

// Estimates by how many rows the right image of a point lies below its left one (SmoothField) while
// driving. Each keyframe gives the vertical errors of some hundred matched corners; the
// coefficients are their least squares fit with a prior, kept in information form, so that what
// images do not show stays at zero.

/// A corner of the left image at a whole pixel and its match in the right image.
struct RowCorner {
  int u = 0;
  int v = 0;
  float disparity = 0;  ///< px
};

class RowAlignment {
 public:
  /// `sigma`: px, standard deviation of the errors that are expected; 0: nothing is estimated.
  void configure(int width, int height, double sigma);
  /// Forgets what was estimated.
  void reset();
  bool isOn() const { return sigma_ > 0; }

  /// Moves the rows of a right image such that they match those of the left one. The image stays as
  /// it is unless the field exceeds 0.1 px and three of its standard deviations somewhere.
  void correct(GrayLevel& right) { shift_.apply(right); }
  /// Learns from the matches of a keyframe, whose right image was corrected last. `gain`: of grey
  /// levels, right to left.
  void observe(const GrayLevel& left, const GrayLevel& right, const std::vector<RowCorner>& corners,
               float gain);

  /// Whether images are corrected at present.
  bool isCorrecting() const { return isOn() && isSignificant(); }
  const SmoothField& field() const { return field_; }
  /// Standard deviation of the field at a pixel, px.
  double sigmaAt(double u, double v) const;

 private:
  using Information = Eigen::Matrix<double, SmoothField::kTerms, SmoothField::kTerms>;
  struct Measurement {
    double below = 0;  ///< px, without correction
    SmoothField::Terms terms;
  };
  Information prior() const;
  void learn(const std::vector<Measurement>& measurements);
  bool isSignificant() const;

  int width_ = 0;
  int height_ = 0;
  double sigma_ = 0;
  SmoothField field_;
  Information information_ = Information::Zero();
  SmoothField::Terms information_vector_ = SmoothField::Terms::Zero();
  RowShift shift_;
  std::vector<std::optional<float>> errors_;
};

}  // namespace tolman::direct_sparse
