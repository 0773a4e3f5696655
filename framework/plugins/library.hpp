// SPDX-License-Identifier: BSD-3-Clause
// Opens plugin libraries that passed the gate, and keeps them until the process ends.
#pragma once

#include <string>

#include "plugins/gate.hpp"
#include "plugins/manifest.hpp"
#include "tolman/plugin.hpp"

namespace tolman::plugins {

/// A plugin whose code is in the process.
struct LoadedPlugin {
  Manifest manifest;
  const PluginDescriptor* descriptor = nullptr;
  Schema schema;
};

/// Gate, open (all symbols resolved, none shared), entry function, schema. The library is pinned:
/// unloading C++ code safely is impossible to promise (inline statics, thread-locals, exceptions in
/// flight). Refusals: those of checkGate(), plugin/load-failed, plugin/entry-missing,
/// plugin/entry-failed, plugin/stale-manifest.
OrRefusal<LoadedPlugin> loadPlugin(const Manifest& manifest, const HostIdentity& host);

}  // namespace tolman::plugins
