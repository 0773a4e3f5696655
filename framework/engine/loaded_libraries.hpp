// SPDX-License-Identifier: BSD-3-Clause
// The shared libraries that may decide the digits of a result.
#pragma once

#include <map>
#include <string>

namespace tolman::run {

/// The files of the libraries that calculate or decode images, without links, by their names
/// ("opencv_core"): of those that this process has loaded by now. Their names have the version.
std::map<std::string, std::string> loadedLibraries();

}  // namespace tolman::run
