// SPDX-License-Identifier: BSD-3-Clause
// Adapts a RemotePlugin to the role interfaces, so that the host uses it like any other instance.
#pragma once

#include <memory>
#include <string>

#include "host/instance.hpp"
#include "host/remote_plugin.hpp"

namespace tolman::host {

/// Constructs the plugin's object in its process. Refusals: those of RemotePlugin::create().
host::OrRefusal<std::unique_ptr<host::Instance>> instantiate(std::shared_ptr<RemotePlugin> remote,
                                                             const std::string& name);

/// Sends the folder of the run to the process, which creates the plugin's artefact writer there.
Status openArtefacts(RemotePlugin& remote, const std::string& run_directory);

}  // namespace tolman::host
