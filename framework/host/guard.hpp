// SPDX-License-Identifier: BSD-3-Clause
// The guard of every call into a plugin: exceptions become a Status, and a failure names plugin,
// call and frame.
#pragma once

#include <cfenv>
#include <csignal>
#include <cstdint>
#include <exception>
#include <locale>
#include <map>
#include <new>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "tolman/status.hpp"

namespace tolman::host {

/// What a library may change in the thread or process of the host by being opened or called, and
/// the host or other plugins would notice: restored at the end of the scope.
class KeptState {
 public:
  /// `handlers`: also those of the signals that end a run, or that the host ignores or waits for,
  /// which takes a dozen system calls. `changed` gets what was changed, by name; may be null.
  KeptState(bool handlers, std::set<std::string>* changed);
  ~KeptState();
  KeptState(const KeptState&) = delete;
  KeptState& operator=(const KeptState&) = delete;

 private:
  std::set<std::string>* changed_;
  unsigned mxcsr_;
  /// Rounding, traps, and subnormal numbers (-ffast-math flushes them to 0).
  std::fenv_t floats_{};
  std::string c_locale_;
  std::locale locale_;
  std::map<int, struct sigaction> handlers_;
};

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
/// exception is copied, because its object belongs to the plugin's library.
template <class Work>
Status contained(Work&& work) noexcept {
  try {
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

/// As contained(), with the call site before the message of a failure, if memory suffices, and with
/// KeptState: handlers of signals only where the call is not for a frame.
template <class Work>
Status guarded(const CallSite& site, Work&& work,
               std::set<std::string>* changed = nullptr) noexcept {
  Status status = contained([&] {
    const KeptState kept(site.frame < 0, changed);
    return std::forward<Work>(work)();
  });
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
