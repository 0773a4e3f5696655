// SPDX-License-Identifier: BSD-3-Clause
#include "matcher.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tolman::view_templates {
namespace {

/// Written so that the compiler makes it 8 cells wide with SSE2: the larger minus the smaller stays
/// in 16 bits, which a plain abs() does not.
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

/// OpenRatSLAM's margin on the quick reject.
constexpr double kMeanMargin = 0.005;

}  // namespace

Matcher::Matcher(const MatchSettings& settings, int columns, int rows)
    : settings_(settings),
      columns_(columns),
      rows_(rows),
      compared_columns_(settings.panoramic ? columns : columns - 2 * settings.shift),
      shifts_((settings.panoramic ? columns - 1 : 2 * settings.shift) / settings.step + 1),
      query_stride_(settings.panoramic ? 2 * columns : columns),
      query_(static_cast<std::size_t>(query_stride_ * rows)) {
  if (compared_columns_ < 1) throw std::invalid_argument("the shifts leave nothing to compare");
}

void Matcher::setQuery(const View& view) {
  const int copies = query_stride_ / columns_;
  auto cell = query_.begin();
  for (int r = 0; r < rows_; ++r) {
    const auto row = view.cells.begin() + r * columns_;
    for (int copy = 0; copy < copies; ++copy) {
      cell = std::transform(row, row + columns_, cell, toFixed);
    }
  }
}

Matcher::Shift Matcher::shiftAt(int index) const {
  const int offset = index * settings_.step;
  if (settings_.panoramic) return {offset, 0};
  return {settings_.shift, offset};
}

std::int64_t Matcher::difference(const FixedCell* stored, Shift shift, std::int64_t limit) const {
  const FixedCell* seen = query_.data() + shift.view_column;
  stored += shift.template_column;
  std::int64_t sum = 0;
  for (int r = 0; r < rows_ && sum < limit; ++r) {
    sum += rowDifference(seen, stored, compared_columns_);
    seen += query_stride_;
    stored += columns_;
  }
  return sum;
}

/// Absolute differences rise like a V on both sides of the true shift: the tip of a V with equal
/// slopes through the three costs around the best.
double Matcher::interpolated(const FixedCell* stored, int best) const {
  constexpr std::int64_t kNoLimit = std::numeric_limits<std::int64_t>::max();
  int before = best - 1;
  int after = best + 1;
  if (settings_.panoramic && settings_.step == 1) {
    before = (best + shifts_ - 1) % shifts_;
    after = (best + 1) % shifts_;
  }
  if (before < 0 || after >= shifts_) return 0;
  const auto c0 = static_cast<double>(difference(stored, shiftAt(best), kNoLimit));
  const auto c1 = static_cast<double>(difference(stored, shiftAt(before), kNoLimit));
  const auto c2 = static_cast<double>(difference(stored, shiftAt(after), kNoLimit));
  const double rise = std::max(c1, c2) - c0;
  return rise > 0 ? 0.5 * (c1 - c2) / rise : 0.0;
}

Match Matcher::nearest(const View& view, const TemplateBank& bank) {
  setQuery(view);
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  Match match;
  int best = 0;
  for (std::int64_t id = 0; id < bank.size(); ++id) {
    if (std::abs(view.mean - bank.mean(id)) > settings_.threshold + kMeanMargin) continue;
    const FixedCell* const stored = bank.cells(id).data();
    for (int index = 0; index < shifts_; ++index) {
      const std::int64_t sum = difference(stored, shiftAt(index), least);
      if (sum >= least) continue;
      least = sum;
      match.id = id;
      best = index;
    }
  }
  if (match.id < 0) return match;
  match.distance =
      static_cast<double>(least) / (static_cast<double>(kOne) * compared_columns_ * rows_);
  const Shift shift = shiftAt(best);
  match.moved_right = shift.view_column - shift.template_column +
                      interpolated(bank.cells(match.id).data(), best) * settings_.step *
                          (settings_.panoramic ? 1 : -1);
  return match;
}

}  // namespace tolman::view_templates
