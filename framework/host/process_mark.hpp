// SPDX-License-Identifier: BSD-3-Clause
// A mark in the environment of a child process. Processes that it starts inherit the mark, so they
// can be found even if they have left the process group.
#pragma once

#include <string>
#include <vector>

namespace tolman::isolation {

/// A new mark for a child of this process; it contains the mark of this process.
std::string newMark();

/// The mark of this process; empty where it has none.
std::string ownMark();

/// The environment of this process with another mark.
std::vector<std::string> environmentWith(const std::string& mark);

/// Kills all processes that have the mark, except this one. A process that was started with another
/// environment has no mark and is not found.
void killMarked(const std::string& mark);

}  // namespace tolman::isolation
