// SPDX-License-Identifier: BSD-3-Clause
// The shared libraries that a plugin brings along.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tolman::host {

/// Files of the libraries that `library`, which must be open in this process, is linked with,
/// directly or by one of them, sorted. Those in the folders of the system are left out, because
/// packages own them. Libraries that a plugin opens itself by dlopen() are not known.
std::vector<std::string> ownLibraries(const std::filesystem::path& library);

}  // namespace tolman::host
