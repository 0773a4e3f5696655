// SPDX-License-Identifier: BSD-3-Clause
// A limit of open files (`ulimit -n`) as the cause of a failure of a record.
#pragma once

#include "base/open_files.hpp"

namespace tolman::record {

using file_opening::areDescriptorsShort;
using file_opening::isDescriptorLimit;
using file_opening::kMoreDescriptors;

inline constexpr int kFilesOfDatabase = 4;  ///< itself, its log, the index of the log, its folder

}  // namespace tolman::record
