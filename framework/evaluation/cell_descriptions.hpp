// SPDX-License-Identifier: BSD-3-Clause
// Descriptions of arrays (ArrayInfo) that the recorded arrays contradict. Such arrays are not
// scored, and the reader is told why.
#pragma once

#include <string>

#include "evaluation/recorded_cells.hpp"

namespace tolman::evaluation {

/// What is wrong with the description of a population's array; empty if nothing is, or if it
/// describes no activity over axes. Asks for the arrays of the whole run.
std::string contradictionOf(const PopulationHistory& population);

}  // namespace tolman::evaluation
