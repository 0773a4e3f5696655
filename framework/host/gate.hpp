// SPDX-License-Identifier: BSD-3-Clause
// The gate: decides from the manifest alone whether this host may open a plugin.
#pragma once

#include <optional>
#include <string>
#include <variant>

#include "host/manifest.hpp"
#include "host/refusal.hpp"
#include "tolman/parameters.hpp"

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

// Whether a configuration can be checked against the parameters that a plugin declares.

/// Refuses (plugin/bad-schema) names that are declared twice or are the host's, ranges without a
/// value, and defaults that are outside of their range or choices.
std::optional<Refusal> checkSchema(const Manifest& manifest, const Schema& schema);

}  // namespace tolman::host
