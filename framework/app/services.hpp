// SPDX-License-Identifier: BSD-3-Clause
// What the host hands to plugins: logger, clock, cancellation, artefacts.
#pragma once

#include <atomic>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <thread>

#include "tolman/context.hpp"

namespace tolman::app {

/// The log of one run: warnings and errors to the terminal, everything to log.txt as soon as there
/// is a run directory; what came before is kept for it.
class RunLog {
 public:
  explicit RunLog(bool quiet);
  ~RunLog();
  RunLog(const RunLog&) = delete;
  RunLog& operator=(const RunLog&) = delete;
  void write(LogLevel level, std::string_view source, std::string_view message,
             bool on_terminal = true);
  void openFile(const std::filesystem::path& file);

 private:
  struct Implementation;
  std::unique_ptr<Implementation> implementation_;
};

/// A plugin's own view of the run's log.
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

/// Hears SIGINT and SIGTERM on a thread of its own while it lives: the first asks the run to end,
/// the second ends the process. Make it before any other thread, so that all of them block both.
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

/// Artefacts of one stage. The run directory comes into being after configure(), when all checks
/// have passed; before that writing fails.
class StageArtefacts : public ArtefactWriter {
 public:
  explicit StageArtefacts(std::string instance) : instance_(std::move(instance)) {}
  void open(const std::filesystem::path& run_directory);
  Status write(std::string_view name, std::span<const std::byte> bytes) override;

 private:
  std::string instance_;
  std::unique_ptr<ArtefactWriter> folder_;
};

}  // namespace tolman::app
