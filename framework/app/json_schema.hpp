// SPDX-License-Identifier: BSD-3-Clause
// JSON Schema (draft 2020-12) of configurations, for editors; from the declarations of the plugins
// and of the host.
#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "host/library.hpp"

namespace tolman::app {

/// One stage that is one of these plugins, complete.
nlohmann::ordered_json stageSchema(const std::vector<host::LoadedPlugin>& plugins);

/// A whole file: the host's sections, and in each stage these plugins of its role, selected by
/// `plugin`. A file that `extends` another needs no complete stages.
nlohmann::ordered_json fileSchema(const std::vector<host::LoadedPlugin>& plugins);

}  // namespace tolman::app
