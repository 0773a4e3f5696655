// SPDX-License-Identifier: BSD-3-Clause
// A plugin in its own process, as the host sees it: started, called, killed at its deadline, and
// restarted.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/codec.hpp"
#include "host/child_process.hpp"
#include "host/instance.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

/// How the process of a plugin is started, and its limits.
struct LaunchOptions {
  std::vector<std::string> command;  ///< calls runPluginProcess(); the descriptor is appended
  double deadline_s = 60;            ///< for one call; 0 for none
  std::uint64_t memory_mib = 4096;   ///< for its data; 0 for no limit
  std::int64_t threads = 0;          ///< 0 for one per processor
};

/// The process of one plugin: makes calls, and enforces the deadline and the limit of the reply.
class ProcessHandle {
 public:
  using Write = std::function<void(Encoder&)>;
  using Read = std::function<void(Decoder&)>;

  /// Starts the process. Throws std::exception.
  explicit ProcessHandle(LaunchOptions launch);
  /// From now on passes log lines and findings on, and cancellation to the process. All may be
  /// null.
  void connect(Logger* log, FindingCollector* findings, const Cancellation* cancellation);

  /// Makes one call. Returns the status of the plugin, or a failure if the process ended; `read`
  /// gets the results when it is Ok.
  Status call(Call call, const Write& write, const Read& read);
  /// From now on keeps the request of each call until the next call.
  void recordRequests() { record_requests_ = true; }
  const std::string& lastRequest() const { return recorded_request_; }

  /// Kills the process. Returns the failure "its process " + reason.
  Status end(const std::string& reason);
  bool hasEnded() const { return !exit_reason_.empty(); }
  /// Why the process ended, such as "died of SIGSEGV (Segmentation fault)"; empty while it runs.
  const std::string& exitReason() const { return exit_reason_; }

 private:
  ReceiveResult waitForMessage(SocketMessage& message, std::chrono::steady_clock::time_point begin);
  Status readExit();
  Status readReply(const std::string& reply, const Read& read);

  LaunchOptions launch_;
  Socket socket_;
  std::unique_ptr<ChildProcess> process_;
  Logger* log_ = nullptr;
  FindingCollector* findings_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  bool cancel_sent_ = false;
  std::uint32_t call_number_ = 0;
  bool record_requests_ = false;
  std::string recorded_request_;
  std::string exit_reason_;
};

/// If restart is enabled and the process ends, the next call starts a new process and restores the
/// plugin: it repeats the initial calls (such as configure), loads the state of the last checkpoint
/// and repeats the calls made since. The call during which the process ended is not repeated.
class RemotePlugin {
 public:
  /// Starts a process that loads the plugin. Refusals: those of loadPlugin(), plugin/died if the
  /// process ended while it opened the library, plugin/no-process.
  static std::shared_ptr<RemotePlugin> start(const Manifest& manifest, const LaunchOptions& launch);
  /// Constructs the plugin's object, once. Refusals: as Instance::create().
  void create();
  /// Records calls from now on, so that they can be repeated. Returns false if the plugin cannot be
  /// restored: sources never can (they would start at their first frame again); place recognition,
  /// cells and maps only if they save their state.
  bool enableRestart();

  const Manifest& manifest() const { return manifest_; }
  const Schema& schema() const { return schema_; }
  bool hasArrays() const { return has_arrays_; }
  bool hasState() const { return has_state_; }
  /// Whether the plugin was restarted without its state since the last call of this function.
  bool takeStateLoss() { return std::exchange(state_lost_, false); }

  Status configure(const Context& context);
  /// Sends the values that are const, and receives the others.
  template <class... T>
  Status call(Call call, T&... values) {
    const auto put = [](Encoder& encoder, const auto& value, bool is_sent) {
      if (is_sent) encoder.put(value);
    };
    const auto get = []<class V>(Decoder& decoder, V& value) {
      if constexpr (!std::is_const_v<V>) decoder.get(value);
    };
    return exchange(
        call, [&](Encoder& encoder) { (put(encoder, values, std::is_const_v<T>), ...); },
        [&](Decoder& decoder) { (get(decoder, values), ...); });
  }
  /// Destroys the plugin's object. The destructor of this class ends the process.
  Status destroy();

 private:
  struct RecordedCall {
    Call call;
    std::string request;  ///< of Call::Restore: the state
  };

  RemotePlugin(Manifest manifest, LaunchOptions launch)
      : manifest_(std::move(manifest)), launch_(std::move(launch)) {}
  void load();
  Refusal diedWhenOpened(const std::string& why) const;
  Status exchange(Call call, const ProcessHandle::Write& write, const ProcessHandle::Read& read);
  bool canRestart() const;
  Status restart();
  Status startAndRestore();
  void record(Call call);

  Manifest manifest_;
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
  /// Configure, artefacts and begin; the last checkpoint, if there is one; and the calls since.
  std::vector<RecordedCall> history_;
};

/// Adapts a RemotePlugin to the role interfaces, so that the host uses it like any other instance:
/// constructs the plugin's object in its process. Refusals: those of RemotePlugin::create().
std::unique_ptr<Instance> instantiate(std::shared_ptr<RemotePlugin> remote,
                                      const std::string& name);

/// Sends the folder of the run to the process, which creates the plugin's artefact writer there.
Status openArtefacts(RemotePlugin& remote, const std::string& run_directory);

}  // namespace tolman::host
