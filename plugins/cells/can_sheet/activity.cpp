// SPDX-License-Identifier: BSD-3-Clause
// The named arrays of the sheets, for recorder and viewers.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "can_sheet.hpp"

namespace tolman::can_sheet {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kRingUnits = 36;  // as in bayesian_attractor; only recorded rates depend on it
/// Concentration of the von Mises tuning curve of a head direction unit, log 2 / (1 - cos 45
/// degrees): in the rat it fires above half its peak within 45 degrees of its preferred direction
/// (Taube, Muller, Ranck 1990).
constexpr double kRingTuning = 2.3665;

std::string moduleName(std::size_t module) {
  return (module == 0 ? "grid" : "grid" + std::to_string(module + 1)) + ".activity";
}

}  // namespace

void CanSheet::arrays(std::vector<NamedArray>& arrays) const {
  NamedArray ring{"hd.activity", {kRingUnits}, {}};
  for (int unit = 0; unit < kRingUnits; ++unit) {
    const double off = state_->heading - unit * kTurn / kRingUnits;
    ring.values.push_back(static_cast<float>(std::exp(kRingTuning * (std::cos(off) - 1))));
  }
  arrays.push_back(std::move(ring));
  const int n = parameters_.units;
  for (std::size_t i = 0; i < state_->sheets.size(); ++i) {
    const std::span<const float> activity = state_->sheets[i].activity();
    const float peak = *std::ranges::max_element(activity);
    NamedArray sheet{moduleName(i), {n, n}, {activity.begin(), activity.end()}};
    for (float& rate : sheet.values) rate /= peak;
    arrays.push_back(std::move(sheet));
  }
  arrays.push_back(
      {"position.decoded",
       {3},
       {static_cast<float>(state_->position.x()), static_cast<float>(state_->position.y()),
        static_cast<float>(state_->heading)}});
}

Status CanSheet::describe(std::vector<ArrayInfo>& arrays) const {
  arrays.push_back({"hd.activity",
                    ArrayKind::Activity,
                    "",
                    "rates of head direction units, 1 at the most",
                    "",
                    {{"heading", "rad", 0, kTurn / kRingUnits, kTurn, {}}}});
  for (std::size_t i = 0; i < state_->sheets.size(); ++i) {
    const double period = periodOf(i);
    const auto axis = [&](const char* name) {
      return ArrayAxis{name, "m", 0, period / parameters_.units, period, {}};
    };
    arrays.push_back({moduleName(i),
                      ArrayKind::Activity,
                      "",
                      "activity of the units of one module, 1 at the most; the axes are 60 degrees "
                      "apart",
                      "",
                      {axis("v"), axis("u")}});
  }
  arrays.push_back({"position.decoded",
                    ArrayKind::Values,
                    "m, rad",
                    "position from the start, read from all modules, and heading",
                    "",
                    {{"component", "", 0, 1, 0, {"x", "y", "heading"}}}});
  return Status::ok();
}

}  // namespace tolman::can_sheet
