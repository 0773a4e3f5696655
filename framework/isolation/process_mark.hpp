// SPDX-License-Identifier: BSD-3-Clause
// A mark in the environment of a child process, which the processes that it starts inherit: they
// are found by it even where they have left the process group.
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

/// Kills all processes that have the mark, but not this one. A process that was started with an
/// environment of its own has none.
void killMarked(const std::string& mark);

}  // namespace tolman::isolation
