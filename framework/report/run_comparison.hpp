// SPDX-License-Identifier: BSD-3-Clause
// The first part of a page about several runs: a table with a column for each, and their maps.
#pragma once

#include <string>
#include <vector>

#include "report/page.hpp"

namespace tolman::report {

/// Settings in which the runs differ, and their metrics; empty for a single run.
std::string comparisonTable(const std::vector<RunPage>& runs);

/// The maps of all runs with the same axes; empty for a single run.
std::string comparisonMaps(const std::vector<RunPage>& runs);

}  // namespace tolman::report
