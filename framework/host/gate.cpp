// SPDX-License-Identifier: BSD-3-Clause
#include "host/gate.hpp"

#include "tolman/version.hpp"

namespace tolman::host {
namespace {

std::string subject(const Manifest& manifest) {
  return "plugin '" + manifest.id + "' (" + manifest.file.string() + ")";
}

std::string version(int major, int minor) {
  return std::to_string(major) + "." + std::to_string(minor);
}

std::string fingerprintRemedy(const Manifest& manifest, const HostIdentity& host) {
  const auto differs = [&](const std::string& word) {
    return host.fingerprint.find(word) != std::string::npos &&
           manifest.fingerprint.find(word) == std::string::npos;
  };
  if (differs(" align16")) {
    return "rebuild the plugin without -march, -mavx or -mavx2 (Eigen's alignment follows them), "
           "or rebuild Tolman with -DTOLMAN_MARCH_V3=ON";
  }
  if (differs("sanitizer-")) return "build plugin and host with the same -fsanitize options";
  return "rebuild the plugin with the compiler, flags and Eigen that this Tolman was built with";
}

}  // namespace

HostIdentity HostIdentity::ofThisBuild() {
  return {TOLMAN_SDK_MAJOR, TOLMAN_SDK_MINOR, TOLMAN_FINGERPRINT, TOLMAN_HOST_OPENCV};
}

std::optional<Refusal> checkGate(const Manifest& manifest, const HostIdentity& host) {
  const std::string built = " was built for SDK " +
                            version(manifest.sdk_major, manifest.sdk_minor) +
                            "; this host has SDK " + version(host.sdk_major, host.sdk_minor);
  if (manifest.sdk_major != host.sdk_major) {
    return Refusal{"plugin/sdk-major", subject(manifest) + built,
                   "rebuild the plugin against this SDK; docs/stability.md lists what changed"};
  }
  const bool is_unreleased = host.sdk_major == 0;  // its minor versions may break
  if (manifest.sdk_minor > host.sdk_minor ||
      (is_unreleased && manifest.sdk_minor != host.sdk_minor)) {
    return Refusal{"plugin/sdk-minor", subject(manifest) + built,
                   "rebuild the plugin against this SDK, or use the Tolman that it was built for"};
  }
  if (manifest.fingerprint != host.fingerprint) {
    return Refusal{"plugin/fingerprint",
                   subject(manifest) + " has another build fingerprint:\n    plugin: " +
                       manifest.fingerprint + "\n    host:   " + host.fingerprint,
                   fingerprintRemedy(manifest, host)};
  }
  if (!manifest.opencv.empty() && manifest.opencv != host.opencv) {
    return Refusal{"plugin/opencv",
                   subject(manifest) + " uses OpenCV " + manifest.opencv +
                       "; the plugins of this host use OpenCV " + host.opencv,
                   "build the plugin against OpenCV " + host.opencv};
  }
  return std::nullopt;
}

}  // namespace tolman::host
