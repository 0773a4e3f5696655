// SPDX-License-Identifier: BSD-3-Clause
// Short names that tell run directories apart.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::run {

/// The last part of each path, without parts that end all of them: "a" and "b" for sweeps/a/run and
/// sweeps/b/run. Where two are equal, with as many parts before it as make all differ, joined by
/// '-'; a number tells the same directory given twice.
std::vector<std::string> distinctNames(const std::vector<std::filesystem::path>& runs);

}  // namespace tolman::run
