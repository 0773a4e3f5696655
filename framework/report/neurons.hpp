// SPDX-License-Identifier: BSD-3-Clause
// neurons.json: how every measured unit of a run fires, and the rate maps of the drawn ones.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "report/drawn_units.hpp"
#include "report/run_data.hpp"

namespace tolman::report {

/// Angles in degrees, unit indices from 1; `nominal` is what the unit stands for by its
/// description. Null without units.
nlohmann::ordered_json neuronsJson(const RunData& run, const std::vector<DrawnUnit>& drawn);
/// A rate map as rows from its corner to the right, null in bins without visits.
nlohmann::ordered_json toJson(const evaluation::RateMap& map);

}  // namespace tolman::report
