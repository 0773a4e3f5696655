// SPDX-License-Identifier: BSD-3-Clause
// The one guard that stands around every call into a plugin.
#pragma once

#include <cstdint>
#include <exception>
#include <string>
#include <string_view>
#include <utility>

#include "tolman/status.hpp"

namespace tolman::plugins {

/// Who is called, for what, at which frame.
struct CallSite {
  std::string_view instance;  ///< "odometry"
  std::string_view plugin;    ///< "feature_stereo"
  std::string_view call;      ///< "track"
  std::int64_t frame = -1;    ///< -1: not about a frame
};

/// "odometry (feature_stereo), track, frame 12: "
inline std::string prefix(const CallSite& site) {
  std::string text(site.instance);
  text.append(" (").append(site.plugin).append("), ").append(site.call);
  if (site.frame >= 0) text += ", frame " + std::to_string(site.frame);
  return text + ": ";
}

/// Calls `work` (returning Status). Exceptions end here: their text is copied, the foreign object
/// dies inside the plugin's code.
template <class Work>
Status contained(Work&& work) noexcept {
  try {
    return std::forward<Work>(work)();
  } catch (const std::exception& error) {
    return Status::failed(std::string("threw: ") + error.what());
  } catch (...) {
    return Status::failed("threw something that is no std::exception");
  }
}

/// The same; a failing Status gets the call site before its message.
template <class Work>
Status guarded(const CallSite& site, Work&& work) noexcept {
  const Status status = contained(std::forward<Work>(work));
  if (status.isOk() || status.code() == StatusCode::EndOfStream) return status;
  return {status.code(), prefix(site).append(status.message())};
}

}  // namespace tolman::plugins
