// SPDX-License-Identifier: BSD-3-Clause
// A plugin in another process, as an instance like any other: each role's calls, passed on.
#pragma once

#include <memory>
#include <string>

#include "isolation/remote.hpp"
#include "plugins/instance.hpp"

namespace tolman::isolation {

/// Makes the plugin's object in its process. Refusals: those of Remote::create().
plugins::OrRefusal<std::unique_ptr<plugins::Instance>> instantiate(std::shared_ptr<Remote> remote,
                                                                   const std::string& name);

/// The folder of the run, from which the process makes the artefact writer of its plugin.
Status openArtefacts(Remote& remote, const std::string& run_directory);

}  // namespace tolman::isolation
