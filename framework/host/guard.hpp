// SPDX-License-Identifier: BSD-3-Clause
// The guard of every call into a plugin: exceptions become a Status, and a failure names plugin,
// call and frame.
#pragma once

#include <cstdint>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <utility>

#include "host/kept_state.hpp"
#include "tolman/status.hpp"

namespace tolman::host {

/// The stage, plugin, call and frame of a call.
struct CallSite {
  std::string_view instance;  ///< "odometry"
  std::string_view plugin;    ///< "feature_stereo"
  std::string_view call;      ///< "track"
  std::int64_t frame = -1;    ///< -1: not for a frame
};

/// "odometry (feature_stereo), track, frame 12: "
inline std::string prefix(const CallSite& site) {
  std::string text(site.instance);
  text.append(" (").append(site.plugin).append("), ").append(site.call);
  if (site.frame >= 0) text += ", frame " + std::to_string(site.frame);
  return text + ": ";
}

/// A failure with this text. If memory is short, the text is "out of memory", which std::string
/// stores without an allocation.
inline Status thrown(const char* begin, const char* what) noexcept {
  try {
    return Status::failed(std::string(begin) + what);
  } catch (const std::exception&) {
    return Status::failed("out of memory");
  }
}

/// Whether a call failed because this process, not a limit of its own, had no memory left. It says
/// nothing of the plugin or its data. OpenCV has an exception of its own for it, and oneTBB one for
/// a thread that cannot be started.
inline bool isOutOfMemory(const Status& status) {
  const std::string& text = status.message();
  const auto has = [&](std::string_view part) { return text.find(part) != std::string::npos; };
  const bool is_short = has("threw: std::bad_alloc") || has("error: (-4:Insufficient memory)") ||
                        has("pthread_create has failed") || text.ends_with("out of memory");
  return !status.isOk() && is_short && !has("isolation.memory_limit");
}

/// Calls `work`, which returns a Status, and converts an exception to a failure. The text of the
/// exception is copied, because its object belongs to the plugin's library. What the call changes
/// in the process, by KeptState, is restored.
template <class Work>
Status contained(Work&& work) noexcept {
  try {
    const KeptState kept;
    return std::forward<Work>(work)();
  } catch (const std::bad_alloc&) {
    return thrown("threw: std::bad_alloc", " (out of memory: `ulimit -v`, or that of the machine)");
  } catch (const std::exception& error) {
    // An isolated plugin's exception comes with its text already.
    return thrown(std::string_view(error.what()).starts_with("threw") ? "" : "threw: ",
                  error.what());
  } catch (...) {
    return thrown("threw something that is not a std::exception", "");
  }
}

/// As contained(), with the call site before the message of a failure, if memory suffices.
template <class Work>
Status guarded(const CallSite& site, Work&& work) noexcept {
  Status status = contained(std::forward<Work>(work));
  if (status.isOk() || status.code() == StatusCode::EndOfStream) return status;
  try {
    constexpr std::size_t kLongest = 10'000;
    const std::string text = status.message().empty() ? "failed, without a message" : "";
    return {status.code(), prefix(site).append(text).append(status.message(), 0, kLongest)};
  } catch (const std::exception&) {
    return status;
  }
}

}  // namespace tolman::host
