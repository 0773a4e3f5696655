// SPDX-License-Identifier: BSD-3-Clause
// The process of one plugin, as seen from the host: starts it, makes calls, and enforces the
// deadline and the limit of the reply's size.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "host/calls.hpp"
#include "host/channel.hpp"
#include "host/child_process.hpp"
#include "host/codec.hpp"
#include "tolman/context.hpp"

namespace tolman::host {

/// How the process of a plugin is started, and its limits.
struct LaunchOptions {
  std::vector<std::string> command;  ///< calls runPluginProcess(); five descriptors are appended
  double deadline_s = 60;            ///< for one call; 0 for none
  std::uint64_t memory_mib = 4096;   ///< for its data; 0 for no limit
  std::int64_t threads = 0;          ///< 0 for one per processor
  /// What the plugin interprets; empty for none. After a call that does not return, the failure
  /// names the line at which it was.
  std::string program = {};
};

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
  /// The code with which the process ended by itself; none while it runs, and if it was killed.
  std::optional<int> exitCode() const { return exit_code_; }

 private:
  ReceiveResult waitForMessage(SocketMessage& message, std::chrono::steady_clock::time_point begin);
  Status readExit();
  Status endAtDeadline();
  Status readReply(const SocketMessage& reply, const Read& read);

  LaunchOptions launch_;
  SharedBuffer request_;
  SharedBuffer response_;
  SharedBuffer control_memory_;
  ControlBlock* control_;
  Socket socket_;
  StackReport stack_;
  std::unique_ptr<ChildProcess> process_;
  Logger* log_ = nullptr;
  FindingCollector* findings_ = nullptr;
  const Cancellation* cancellation_ = nullptr;
  std::uint32_t call_number_ = 0;
  bool record_requests_ = false;
  std::string recorded_request_;
  std::string exit_reason_;
  std::optional<int> exit_code_;
};

}  // namespace tolman::host
