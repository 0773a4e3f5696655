// SPDX-License-Identifier: BSD-3-Clause
// The services of a run: its log, a steady clock, cancellation by signals, artefacts of plugins.
#pragma once

#include <array>
#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "tolman/context.hpp"

namespace tolman::run {

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

/// The logger of one plugin: writes to the run's log under the name of the stage. After kMaxBytes
/// of messages it writes one warning and no further messages, so that a plugin cannot fill the
/// disk.
class StageLogger : public Logger {
 public:
  static constexpr std::size_t kMaxBytes = 16 << 20;

  StageLogger(RunLog& log, std::string source) : log_(log), source_(std::move(source)) {}
  void write(LogLevel level, std::string_view message) override;

 private:
  RunLog& log_;
  std::string source_;
  std::atomic<std::size_t> bytes_ = 0;  ///< size of the messages so far
};

class SteadyClock : public Clock {
 public:
  std::int64_t steadyNs() const override;
};

/// Signals that ask a process to end, and do so at once where it does nothing about them. Batch
/// systems send SIGUSR1, SIGUSR2 or SIGXCPU before they kill a job at its limit of time.
inline constexpr std::array kEndSignals = {SIGINT,  SIGTERM, SIGHUP,    SIGUSR1,
                                           SIGUSR2, SIGALRM, SIGVTALRM, SIGXCPU};

/// Cancellation by SIGINT and SIGTERM, and by the others of kEndSignals unless they are ignored, as
/// SIGHUP by nohup. The first signal requests cancellation, a second SIGINT or SIGTERM ends the
/// process. The others never end it: a closed terminal may send SIGHUP several times, and the
/// kernel sends SIGXCPU every second. A separate thread waits for the signals. Create this object
/// before any other thread, so that all threads inherit the signal mask.
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

}  // namespace tolman::run
