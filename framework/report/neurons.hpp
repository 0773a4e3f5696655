// SPDX-License-Identifier: BSD-3-Clause
// neurons.json: the firing of every measured unit of a run, and the rate maps of the drawn ones.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "report/drawn_units.hpp"
#include "report/run_data.hpp"

namespace tolman::report {

/// Angles in degrees, unit indices from 1; `nominal` is the value of the unit by the description of
/// its axis. Null without units.
nlohmann::ordered_json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn);
/// A rate map as rows from its corner to the right, null in bins without visits.
nlohmann::ordered_json toJson(const evaluation::RateMap& map);

}  // namespace tolman::report
