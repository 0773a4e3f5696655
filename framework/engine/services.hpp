// SPDX-License-Identifier: BSD-3-Clause
// The services of a run: its log, a steady clock, cancellation by signals, the findings.
#pragma once

#include <atomic>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/record_rows.hpp"
#include "config/settings.hpp"
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

// The findings of all stages of a run (Context::findings): recorded one by one, printed once per
// kind with their number, and judged by the key `on_findings`.

/// The text with `#` for its numbers, which differ within one kind of warnings.
std::string withoutNumbers(const std::string& text);

/// Callable from any thread.
class Findings {
 public:
  explicit Findings(config::FindingPolicy policy = config::FindingPolicy::Continue)
      : policy_(policy) {}

  void add(const std::string& stage, Finding finding);
  /// After a call at `frame` (-1: configure) that answered `status`: the status, or the first error
  /// that was found since the last call of this function, if errors stop the run.
  Status judge(const Status& status, std::int64_t frame);

  /// One kind of findings: those of one stage that differ in numbers and places alone.
  struct Kind {
    record::RecordedFinding first;
    std::int64_t count = 0;
    std::int64_t printed = 0;  ///< of them, those that a line counted

    LogLevel level() const;
    /// "WHERE: MESSAGE; REMEDY (and N more)".
    std::string text() const;
  };
  /// What to print now: the kinds that were never printed.
  std::vector<Kind> takeNewKinds() { return takeKinds(true); }
  /// What to print at the end: the kinds with more findings than were printed.
  std::vector<Kind> takeGrownKinds() { return takeKinds(false); }
  /// The findings that were not taken yet; during a run only those whose frame is known.
  std::vector<record::RecordedFinding> take(bool at_end = true);

 private:
  std::vector<Kind> takeKinds(bool are_new);
  std::mutex mutex_;
  config::FindingPolicy policy_;
  std::vector<record::RecordedFinding> untaken_;
  std::size_t addressed_ = 0;                 ///< of `untaken_`: their frame is known
  std::vector<Kind> kinds_;                   ///< in the order of their first finding
  std::map<std::string, std::size_t> index_;  ///< of `kinds_`, by stage, severity and text
  std::size_t judged_ = 0;                    ///< of `kinds_`
};

/// The collector of one stage.
class StageFindings : public FindingCollector {
 public:
  StageFindings(Findings& all, std::string stage) : all_(all), stage_(std::move(stage)) {}
  void add(Finding finding) override { all_.add(stage_, std::move(finding)); }

 private:
  Findings& all_;
  std::string stage_;
};

}  // namespace tolman::engine
