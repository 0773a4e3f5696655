// SPDX-License-Identifier: BSD-3-Clause
// Resumes an interrupted or killed run in its own directory. Place recognition, cells and map are
// loaded from the last checkpoint. Source and odometry, which save no state, process the frames up
// to it again; their stamps, true poses and motions must be those of the record.
#pragma once

#include <filesystem>

#include "engine/assembly.hpp"
#include "record/run_reader.hpp"

namespace tolman::engine {

/// Brings a new assembly to the state of the last checkpoint of the run in `directory`, which is
/// only read. Throws Failed (Continuation) for no checkpoint, a damaged one, other plugins or other
/// data. After a cancellation it returns early, and the assembly must not be used.
ResumePoint resumeAt(Assembly& assembly, const std::filesystem::path& directory,
                     const Cancellation& cancellation);

}  // namespace tolman::engine
