// SPDX-License-Identifier: BSD-3-Clause
// Notes of a comparison about its runs: factors without effect, and too few samples.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "experiment/run_table.hpp"

namespace tolman::experiment {

/// Factors besides seed and sequence whose levels never changed the results (byte for byte) in runs
/// that are equal in all other factors.
std::vector<std::string> factorsWithoutEffect(const std::vector<RunRow>& rows);

/// A warning about the signed rank test and the bootstrap for few sequences, or few seeds of one
/// sequence: the smallest possible p is 2 / 2^n. Empty if that is below 0.05.
std::string fewSamplesNote(std::size_t sequences, std::size_t seeds);

/// A warning about sequences that have one true path, such as one drive with two settings; empty if
/// all differ. Test and bootstrap take them for independent.
std::string sameTruthNote(const std::vector<RunRow>& rows);

/// A note on levels whose mean and interval weigh the runs differently.
std::string unevenRunsNote(const std::vector<std::string>& levels);

/// Notes on runs that lost tracking, and on runs that cover different shares of their truth.
std::vector<std::string> trackingNotes(const std::vector<RunRow>& rows);

}  // namespace tolman::experiment
