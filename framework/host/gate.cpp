// SPDX-License-Identifier: BSD-3-Clause
#include "host/gate.hpp"

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "config/settings.hpp"
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

namespace {

struct Complaint {
  const char* what = nullptr;  ///< null: none
  const char* remedy = nullptr;
};

bool isWithin(const ParameterInfo& info) {
  const auto fits = [&](double x) { return x >= info.min && x <= info.max; };
  if (const auto* integer = std::get_if<std::int64_t>(&info.default_value)) {
    return fits(static_cast<double>(*integer));
  }
  if (const auto* real = std::get_if<double>(&info.default_value)) return fits(*real);
  if (const auto* list = std::get_if<std::vector<double>>(&info.default_value)) {
    return std::ranges::all_of(*list, fits);
  }
  if (info.type != ParameterType::Choice) return true;
  const auto* choice = std::get_if<std::string>(&info.default_value);
  return choice != nullptr && std::ranges::find(info.choices, *choice) != info.choices.end();
}

Complaint complaintAbout(const ParameterInfo& info, const Schema& reserved) {
  if (std::ranges::find(reserved, info.name, &ParameterInfo::name) != reserved.end()) {
    return {"has a name that is reserved for the host", "rename it"};
  }
  if (!(info.min <= info.max)) return {"has an empty range", "swap the ends of .range()"};
  if (!info.required && !isWithin(info)) {
    return {"has a default outside of its range", "correct the default or the range"};
  }
  return {};
}

Refusal refusal(const Manifest& manifest, const std::string& name, const Complaint& complaint) {
  const auto& file = manifest.program.empty() ? manifest.file : manifest.program;
  return {"plugin/bad-schema",
          file.string() + ": parameter '" + name + "' of '" + manifest.id + "' " + complaint.what,
          complaint.remedy};
}

}  // namespace

std::optional<Refusal> checkSchema(const Manifest& manifest, const Schema& schema) {
  Schema reserved = schemaOf<config::StageSettings>();  // keys that the host reads
  if (!manifest.programs.empty())
    std::ranges::copy(config::programSchema(), std::back_inserter(reserved));
  std::set<std::string_view> seen;
  for (const ParameterInfo& info : schema) {
    const bool is_new = seen.insert(info.name).second;
    const Complaint complaint = is_new ? complaintAbout(info, reserved)
                                       : Complaint{"is declared twice", "remove one declaration"};
    if (complaint.what != nullptr) return refusal(manifest, info.name, complaint);
  }
  return std::nullopt;
}

}  // namespace tolman::host
