// SPDX-License-Identifier: BSD-3-Clause
// The services of a run: its log, a steady clock, cancellation by signals or by the run itself.
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "engine/failure.hpp"
#include "tolman/context.hpp"

namespace tolman::engine {

/// Text to write before a line on stderr, so that it replaces a progress line: on a terminal blanks
/// over the present line (they work on every terminal), elsewhere nothing.
std::string wipedLine();

/// The log of one run: warnings and errors go to stderr (with `quiet` errors only), all lines go to
/// log.txt. Lines from before the file is opened are kept until then.
class RunLog {
 public:
  explicit RunLog(bool quiet = false);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;
  void write(LogLevel level, std::string_view source, std::string_view message,
             bool on_terminal = true);
  enum class Open : bool { Fresh, Append };
  Status openFile(const std::filesystem::path& file, Open open = Open::Fresh);
  /// The warnings and errors from before the file is opened, as "STAGE: text".
  std::vector<std::string> keptWarnings() const;
  /// Fails if the file could not be opened or does not have all lines.
  Status status() const;

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// The logger of one plugin: writes to the run's log under the name of the stage.
class StageLogger : public Logger {
 public:
  StageLogger(RunLog& log, std::string source) : log_(log), source_(std::move(source)) {}
  void write(LogLevel level, std::string_view message) override {
    log_.write(level, source_, message);
  }

 private:
  RunLog& log_;
  std::string source_;
};

class SteadyClock : public Clock {
 public:
  std::int64_t steadyNs() const override;
};

/// Cancellation by SIGINT and SIGTERM, and by SIGHUP and the signals that batch systems send,
/// unless they are ignored, as SIGHUP by nohup. The first signal requests cancellation, a second
/// SIGINT or SIGTERM ends the process. The others never end it: a closed terminal may send SIGHUP
/// several times, and the kernel sends SIGXCPU every second. A separate thread waits for the
/// signals. Create this object before any other thread, so that all threads inherit the signal
/// mask.
class Interrupts : public Cancellation {
 public:
  Interrupts();
  ~Interrupts() override;
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
  bool requested() const override { return requested_; }

 private:
  void listen(const std::stop_token& stop);
  std::atomic<bool> requested_ = false;
  std::jthread thread_;
};

/// Cancellation by the caller of a run, or by the run itself with a reason.
class StopRequest : public Cancellation {
 public:
  explicit StopRequest(const Cancellation& caller) : caller_(caller) {}
  bool requested() const override { return stopped_ || caller_.requested(); }

  /// Stops the run. If it is called again, the first reason is kept.
  void stop(Failure reason) {
    const std::lock_guard lock(mutex_);
    if (!reason_) reason_ = std::move(reason);
    stopped_ = true;
  }
  /// Why the run stopped itself; none if it was not stopped, or cancelled by the caller.
  std::optional<Failure> reason() const {
    const std::lock_guard lock(mutex_);
    return reason_;
  }

 private:
  const Cancellation& caller_;
  std::atomic<bool> stopped_ = false;
  mutable std::mutex mutex_;  // guards the reason
  std::optional<Failure> reason_;
};

}  // namespace tolman::engine
