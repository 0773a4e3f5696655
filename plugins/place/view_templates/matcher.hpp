// SPDX-License-Identifier: BSD-3-Clause
// Comparison of a view with the templates, shifted, and the yaw that follows from the shift.
//
// Yaw (rad) from a horizontal image shift. OpenRatSLAM does not use the shift of ordinary cameras.
#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "template_bank.hpp"
#include "tolman/geometry.hpp"
#include "view_maker.hpp"

namespace tolman::view_templates {

/// Focal length (px) of a pinhole that sees `field_of_view` (rad) over `width` pixels.
inline double focalOfFieldOfView(double field_of_view, int width) {
  return 0.5 * width / std::tan(0.5 * field_of_view);
}

/// Yaw (rad, positive to the left) of a pinhole camera whose scene moved `right_px` to the right:
/// when the camera turns left, the scene moves right in the image.
inline double yawOfPinholeShift(double right_px, double focal_px) {
  return std::atan(right_px / focal_px);
}

/// The same for a panorama of `columns` cells over the full turn.
inline double yawOfPanoramicShift(double right_cells, int columns) {
  return wrapAngle(2 * std::numbers::pi * right_cells / columns);
}

// Finds the stored template nearest to a view: sum of absolute differences over all horizontal (and
// vertical) shifts, as OpenRatSLAM (Ball et al. 2013). Templates whose mean differs too much are
// skipped, and a sum stops once it exceeds the smallest so far.

struct MatchSettings {
  int shift = 5;             ///< largest horizontal shift, cells; not used by panoramas
  int step = 1;              ///< between the shifts that are tried, cells
  double threshold = 0.085;  ///< largest mean absolute difference of a match
  bool panoramic = false;    ///< 360 degree view: all cyclic shifts are tried
  int vertical_shift = 0;    ///< largest vertical shift, cells; all between are tried
  int layers = 1;            ///< number of blocks of rows that a view consists of
};

struct TemplateMatch {
  std::int64_t id = -1;  ///< nearest template; -1 when every one was rejected by its mean
  double distance = 1;   ///< mean absolute difference of the compared cells
  /// Shift of the scene to the right since the template was made, in cells, interpolated between
  /// the tried shifts.
  double moved_right = 0;
};

class Matcher {
 public:
  /// The shifts must leave at least one cell of a layer of columns x rows to compare.
  Matcher(const MatchSettings& settings, int columns, int rows);

  /// Ties go to the older template, then to the shift that was tried first.
  TemplateMatch nearest(const LocalView& view, const TemplateBank& bank);

 private:
  /// One tried shift: the first compared column of view and of template, and how many rows lower
  /// the template is read.
  struct TemplateShift {
    int view_column;
    int template_column;
    int down;
  };

  void setQuery(const LocalView& view);
  TemplateShift shiftAt(int index) const;
  std::int64_t difference(const FixedCell* stored, TemplateShift shift, std::int64_t limit) const;
  double interpolated(const FixedCell* stored, int best) const;

  MatchSettings settings_;
  int columns_;
  int rows_;  ///< of a layer
  int first_row_;
  int compared_rows_;
  int compared_columns_;
  int shifts_;  ///< horizontal ones
  int query_stride_;
  std::vector<FixedCell> query_;  ///< rows of the view; twice side by side for panoramas
};

}  // namespace tolman::view_templates
