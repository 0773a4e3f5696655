// SPDX-License-Identifier: BSD-3-Clause
// The gate: decides from the manifest alone whether this host may open a plugin.
#pragma once

#include <optional>
#include <string>

#include "host/manifest.hpp"

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

}  // namespace tolman::host
