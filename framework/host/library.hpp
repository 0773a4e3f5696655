// SPDX-License-Identifier: BSD-3-Clause
// The shared libraries that a plugin brings along.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "host/gate.hpp"
#include "host/manifest.hpp"
#include "tolman/plugin.hpp"

namespace tolman::host {

/// Files of the libraries that `library`, which must be open in this process, is linked with,
/// directly or by one of them, sorted. Those in the folders of the system are left out, because
/// packages own them. Libraries that a plugin opens itself by dlopen() are not known.
std::vector<std::string> ownLibraries(const std::filesystem::path& library);

// Opens plugin libraries that passed the gate, and keeps them until the process ends.

/// The remedy of a refusal for lack of memory or of open files.
inline constexpr const char* kLimitsTooLow =
    "the limits of this process are too low for it: see `ulimit -a`";

/// A plugin whose library is open.
struct LoadedPlugin {
  Manifest manifest;
  const PluginDescriptor* descriptor = nullptr;
  Schema schema;
};

/// Checks the gate, opens the library (all symbols resolved, none exported to others), calls the
/// entry function and reads the schema. The library stays loaded, because inline statics,
/// thread-local variables and exceptions make unloading C++ code unsafe. Refusals: those of
/// checkGate(), checkSchema(), plugin/load-failed, plugin/entry-missing,
/// plugin/entry-failed, plugin/stale-manifest. The manifest of a program gets its role, version and
/// summary; plugin/program if it cannot be opened.
OrRefusal<LoadedPlugin> loadPlugin(const Manifest& manifest, const HostIdentity& host);

}  // namespace tolman::host
