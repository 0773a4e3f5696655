// SPDX-License-Identifier: BSD-3-Clause
#include "matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tolman::view_templates {

namespace {

/// Vectorises to 8 cells with SSE2, because the larger minus the smaller cell fits 16 bits; the
/// argument of abs() would not.
std::int32_t rowDifference(const FixedCell* a, const FixedCell* b, int count) {
  std::int32_t sum = 0;
  for (int i = 0; i < count; ++i) {
    const FixedCell x = a[i];
    const FixedCell y = b[i];
    const FixedCell larger = x > y ? x : y;
    const FixedCell smaller = x > y ? y : x;
    sum += static_cast<FixedCell>(larger - smaller);
  }
  return sum;
}

/// Tolerance of the rejection by the mean, as in OpenRatSLAM.
constexpr double kMeanMargin = 0.005;

}  // namespace

Matcher::Matcher(const MatchSettings& settings, int columns, int rows)
    : settings_(settings),
      columns_(columns),
      rows_(rows),
      first_row_(settings.vertical_shift),
      compared_rows_(rows - 2 * settings.vertical_shift),
      compared_columns_(settings.panoramic ? columns : columns - 2 * settings.shift),
      shifts_((settings.panoramic ? columns - 1 : 2 * settings.shift) / settings.step + 1),
      query_stride_(settings.panoramic ? 2 * columns : columns),
      query_(static_cast<std::size_t>(query_stride_ * rows * settings.layers)) {
  if (compared_columns_ < 1 || compared_rows_ < 1)
    throw std::invalid_argument("the shifts leave nothing to compare");
}

void Matcher::setQuery(const LocalView& view) {
  const int copies = query_stride_ / columns_;
  auto cell = query_.begin();
  for (int r = 0; r < rows_ * settings_.layers; ++r) {
    const auto row = view.cells.begin() + r * columns_;
    for (int copy = 0; copy < copies; ++copy) {
      cell = std::transform(row, row + columns_, cell, toFixed);
    }
  }
}

Matcher::TemplateShift Matcher::shiftAt(int index) const {
  const int offset = index % shifts_ * settings_.step;
  const int down = index / shifts_ - settings_.vertical_shift;
  if (settings_.panoramic) return {offset, 0, down};
  return {settings_.shift, offset, down};
}

std::int64_t Matcher::difference(const FixedCell* stored, TemplateShift shift,
                                 std::int64_t limit) const {
  std::int64_t sum = 0;
  for (int layer = 0; layer < settings_.layers; ++layer) {
    const int row = layer * rows_ + first_row_;
    const FixedCell* seen = query_.data() + row * query_stride_ + shift.view_column;
    const FixedCell* kept = stored + (row + shift.down) * columns_ + shift.template_column;
    for (int r = 0; r < compared_rows_ && sum < limit; ++r) {
      sum += rowDifference(seen, kept, compared_columns_);
      seen += query_stride_;
      kept += columns_;
    }
  }
  return sum;
}

/// Sub-cell shift: the tip of a V with equal slopes through the three costs around the best,
/// because sums of absolute differences rise linearly on both sides of the true shift.
double Matcher::interpolated(const FixedCell* stored, int best) const {
  constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
  const int level = best - best % shifts_;  // the first index of the same vertical shift
  int before = best % shifts_ - 1;
  int after = best % shifts_ + 1;
  if (settings_.panoramic && settings_.step == 1) {
    before = (before + shifts_) % shifts_;
    after %= shifts_;
  }
  if (before < 0 || after >= shifts_) return 0;
  const auto c0 = static_cast<double>(difference(stored, shiftAt(best), kNoLimit));
  const auto c1 = static_cast<double>(difference(stored, shiftAt(level + before), kNoLimit));
  const auto c2 = static_cast<double>(difference(stored, shiftAt(level + after), kNoLimit));
  const double rise = std::max(c1, c2) - c0;
  return rise > 0 ? 0.5 * (c1 - c2) / rise : 0.0;
}

TemplateMatch Matcher::nearest(const LocalView& view, const TemplateBank& bank) {
  setQuery(view);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  TemplateMatch match;
  int best = 0;
  const int tried = shifts_ * (2 * settings_.vertical_shift + 1);
  for (std::int64_t id = 0; id < bank.size(); ++id) {
    if (std::abs(view.mean - bank.mean(id)) > settings_.threshold + kMeanMargin) continue;
    const FixedCell* const stored = bank.cells(id).data();
    for (int index = 0; index < tried; ++index) {
      const std::int64_t sum = difference(stored, shiftAt(index), least);
      if (sum >= least) continue;
      least = sum;
      match.id = id;
      best = index;
    }
  }
  if (match.id < 0) return match;
  const double compared = compared_columns_ * compared_rows_ * settings_.layers;
  match.distance = static_cast<double>(least) / (kOne * compared);
  const TemplateShift shift = shiftAt(best);
  match.moved_right = shift.view_column - shift.template_column +
                      interpolated(bank.cells(match.id).data(), best) * settings_.step *
                          (settings_.panoramic ? 1 : -1);
  return match;
}

}  // namespace tolman::view_templates
