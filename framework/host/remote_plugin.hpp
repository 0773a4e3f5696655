// SPDX-License-Identifier: BSD-3-Clause
// A plugin in its own process. If restart is enabled and the process ends, the next call starts a
// new process and restores the plugin: it repeats the initial calls (such as configure), loads the
// state of the last checkpoint and repeats the calls made since. The call during which the process
// ended is not repeated.
#pragma once

#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "host/calls.hpp"
#include "host/manifest.hpp"
#include "host/process_handle.hpp"

namespace tolman::host {

class RemotePlugin {
 public:
  /// Starts a process that loads the plugin. Refusals: those of loadPlugin(), plugin/died if the
  /// process ended while it opened the library, plugin/no-process.
  static host::OrRefusal<std::shared_ptr<RemotePlugin>> start(const host::Manifest& manifest,
                                                              const LaunchOptions& launch);
  /// Constructs the plugin's object, once. Refusals: as Instance::create().
  std::optional<host::Refusal> create();
  /// Records calls from now on, so that they can be repeated. Returns false if the plugin cannot be
  /// restored: sources never can (they would start at their first frame again); place recognition,
  /// cells and maps only if they save their state.
  bool enableRestart();

  const host::Manifest& manifest() const { return manifest_; }
  const Schema& schema() const { return schema_; }
  bool hasArrays() const { return has_arrays_; }
  bool hasState() const { return has_state_; }
  /// Whether the plugin was restarted without its state since the last call of this function.
  bool takeStateLoss() { return std::exchange(state_lost_, false); }
  /// Whether the process still runs after the last call.
  bool alive() const { return !process_->hasEnded(); }

  Status configure(const Context& context);
  template <class... I, class... O>
  Status call(Call call, std::tuple<const I&...> in, std::tuple<O&...> out) {
    return exchange(
        call,
        [&](Encoder& encoder) { std::apply([&](const auto&... v) { encoder.putAll(v...); }, in); },
        [&](Decoder& decoder) { std::apply([&](auto&... v) { decoder.getAll(v...); }, out); });
  }
  /// Destroys the plugin's object. The destructor of this class ends the process.
  Status destroy();

 private:
  struct RecordedCall {
    Call call;
    std::string request;
  };

  RemotePlugin(host::Manifest manifest, LaunchOptions launch)
      : manifest_(std::move(manifest)), launch_(std::move(launch)) {
    launch_.program = manifest_.program.string();
  }
  std::optional<host::Refusal> load();
  host::Refusal diedWhenOpened(const std::string& why) const;
  Status exchange(Call call, const ProcessHandle::Write& write, const ProcessHandle::Read& read);
  bool canRestart() const;
  Status restart();
  Status startAndRestore();
  Status repeat(const std::vector<RecordedCall>& calls);
  void record(Call call);
  void checkpoint();

  host::Manifest manifest_;
  LaunchOptions launch_;
  Schema schema_;
  std::unique_ptr<ProcessHandle> process_;
  bool created_ = false;
  bool has_arrays_ = false;
  bool has_state_ = false;
  Logger* log_ = nullptr;
  FindingCollector* findings_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  bool restart_enabled_ = false;
  int restarts_ = 0;
  bool state_lost_ = false;
  std::vector<RecordedCall> initial_calls_;  ///< configure, artefacts, begin
  std::string checkpoint_;                   ///< saved state; empty for none
  std::vector<RecordedCall> calls_since_checkpoint_;
};

}  // namespace tolman::host
