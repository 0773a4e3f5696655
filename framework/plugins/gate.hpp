// SPDX-License-Identifier: BSD-3-Clause
// The gate: may this plugin be opened by this host? Decided from the manifest alone.
#pragma once

#include <optional>
#include <string>

#include "plugins/manifest.hpp"

namespace tolman::plugins {

/// What a host offers; the default is this build.
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

}  // namespace tolman::plugins
