// SPDX-License-Identifier: BSD-3-Clause
// The gate decides from the manifest alone whether this host may open a plugin. Libraries that pass
// it are opened, and kept until the process ends.
#pragma once

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "host/manifest.hpp"
#include "tolman/parameters.hpp"
#include "tolman/plugin.hpp"

namespace tolman::host {

/// SDK version and build of a host.
struct HostIdentity {
  int sdk_major;
  int sdk_minor;
  std::string fingerprint;
  std::string opencv;

  static HostIdentity ofThisBuild();
};

/// Refusals, in the order of the checks: plugin/sdk-major, plugin/sdk-minor, plugin/fingerprint,
/// plugin/opencv.
std::optional<Refusal> checkGate(const Manifest& manifest, const HostIdentity& host);

/// Refuses (plugin/bad-schema) names that are declared twice or are the host's, ranges without a
/// value, and defaults that are outside of their range or choices.
void checkSchema(const Manifest& manifest, const Schema& schema);

/// A plugin whose library is open.
struct LoadedPlugin {
  Manifest manifest;
  const PluginDescriptor* descriptor = nullptr;
  Schema schema;
  std::set<std::string> changed{};  ///< by its constructors, see KeptState
};

/// Checks the gate, opens the library (all symbols resolved, none exported to others), calls the
/// entry function and reads the schema. The library stays loaded, because inline statics,
/// thread-local variables and exceptions make unloading C++ code unsafe. Refusals: those of
/// checkGate(), checkSchema(), plugin/load-failed, plugin/library-conflict (one that it is linked
/// with would be another of that name, which is open already), plugin/entry-missing,
/// plugin/entry-failed, plugin/stale-manifest. The manifest of a program gets its role, version and
/// summary; plugin/program if it cannot be opened.
LoadedPlugin loadPlugin(const Manifest& manifest, const HostIdentity& host);

}  // namespace tolman::host
