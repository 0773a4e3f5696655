// SPDX-License-Identifier: BSD-3-Clause
#include "engine/services.hpp"

#include <fmt/format.h>
#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <csignal>
#include <cstdio>
#include <iterator>
#include <mutex>
#include <utility>

#include "base/progress_display.hpp"
#include "config/text.hpp"

namespace tolman::engine {

namespace {

spdlog::level::level_enum levelOf(LogLevel level) {
  constexpr std::array kLevels = {spdlog::level::debug, spdlog::level::info, spdlog::level::warn,
                                  spdlog::level::err};
  return kLevels.at(static_cast<std::size_t>(level));
}

/// Signals that ask a process to end, and do so at once where it does nothing about them. Batch
/// systems send SIGUSR1, SIGUSR2 or SIGXCPU before they kill a job at its limit of time.
constexpr std::array kEndSignals = {SIGINT,  SIGTERM, SIGHUP,    SIGUSR1,
                                    SIGUSR2, SIGALRM, SIGVTALRM, SIGXCPU};

bool endsAtSecond(int signal) { return signal == SIGINT || signal == SIGTERM; }

sigset_t interruptSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : kEndSignals) {
    struct sigaction now {};
    ::sigaction(signal, nullptr, &now);
    if (endsAtSecond(signal) || now.sa_handler != SIG_IGN) sigaddset(&signals, signal);
  }
  return signals;
}

}  // namespace

std::string wipedLine() {
  if (::isatty(STDERR_FILENO) != 1) return {};
  return "\r" + std::string(static_cast<std::size_t>(terminalWidth() - 1), ' ') + "\r";
}

struct RunLog::Implementation {
  struct Line {
    LogLevel level;
    std::string text;
  };

  /// Writes a line on the terminal over a progress line, if there is one. The lock of stderr keeps
  /// both parts together: std::cerr, which other code uses, takes it as well.
  void show(spdlog::level::level_enum level, const std::string& text) {
    if (!terminal.should_log(level)) return;
    ::flockfile(stderr);
    std::fputs(wipedLine().c_str(), stderr);
    terminal.log(level, text);
    ::funlockfile(stderr);
  }

  std::mutex mutex;
  spdlog::logger terminal{"tolman", std::make_shared<spdlog::sinks::stderr_color_sink_mt>()};
  std::unique_ptr<spdlog::logger> file;
  std::vector<Line> backlog;  // lines before the file is opened
  Status status;              // of the file
};

RunLog::RunLog(bool quiet) : implementation_(std::make_unique<Implementation>()) {
  implementation_->terminal.set_level(quiet ? spdlog::level::err : spdlog::level::warn);
  implementation_->terminal.set_pattern("%^%l%$: %v");
}

RunLog::~RunLog() = default;

void RunLog::write(LogLevel level, std::string_view source, std::string_view message,
                   bool on_terminal) {
  const std::lock_guard lock(implementation_->mutex);
  constexpr std::size_t kLongest = 10'000;
  std::string text =
      std::string(source) + ": " + config::printable(message.substr(0, kLongest), "?");
  if (message.size() > kLongest) text += "...";
  if (on_terminal) implementation_->show(levelOf(level), text);
  if (implementation_->file) {
    implementation_->file->log(levelOf(level), text);
  } else {
    implementation_->backlog.push_back({level, std::move(text)});
  }
}

Status RunLog::openFile(const std::filesystem::path& file, Open open) {
  const std::lock_guard lock(implementation_->mutex);
  std::unique_ptr<spdlog::logger> logger;
  try {
    logger = std::make_unique<spdlog::logger>(
        "run",
        std::make_shared<spdlog::sinks::basic_file_sink_mt>(file.string(), open == Open::Fresh));
  } catch (const spdlog::spdlog_ex& error) {
    return implementation_->status = Status::failed(error.what());
  }
  logger->set_error_handler([this](const std::string& message) {  // with the mutex held
    implementation_->status = Status::failed(message + "; look for a full disk");
  });
  logger->set_level(spdlog::level::debug);
  logger->set_pattern("%Y-%m-%dT%H:%M:%S.%e %l %v");
  logger->flush_on(spdlog::level::info);
  for (const auto& line : implementation_->backlog) logger->log(levelOf(line.level), line.text);
  implementation_->backlog.clear();
  implementation_->file = std::move(logger);
  return implementation_->status;
}

std::vector<std::string> RunLog::keptWarnings() const {
  const std::lock_guard lock(implementation_->mutex);
  std::vector<std::string> texts;
  for (const auto& line : implementation_->backlog) {
    if (line.level >= LogLevel::Warning) texts.push_back(line.text);
  }
  return texts;
}

Status RunLog::status() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->status;
}

std::int64_t SteadyClock::steadyNs() const {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration_cast<std::chrono::nanoseconds>(now).count();
}

Interrupts::Interrupts() {
  const sigset_t signals = interruptSignals();
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);  // later threads inherit this
  thread_ = std::jthread([this](const std::stop_token& stop) { listen(stop); });
}

Interrupts::~Interrupts() {
  thread_.request_stop();
  thread_.join();
  const sigset_t signals = interruptSignals();
  pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

void Interrupts::listen(const std::stop_token& stop) {
  const sigset_t signals = interruptSignals();
  const timespec timeout = {0, 50'000'000};
  while (!stop.stop_requested()) {
    const int signal = sigtimedwait(&signals, nullptr, &timeout);
    if (signal < 0) continue;
    if (!requested_.exchange(true) || !endsAtSecond(signal)) continue;
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // the second signal ends the process
    ::raise(signal);
  }
}

namespace {

std::string textOf(const Finding& finding) {
  std::string text = finding.where + (finding.where.empty() ? "" : ": ") + finding.message;
  return finding.remedy.empty() ? text : text + "; " + finding.remedy;
}

}  // namespace

std::string withoutNumbers(const std::string& text) {
  std::string kept;
  for (const char c : text) {
    const bool is_digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    if (!is_digit) kept += c;
    if (is_digit && !kept.ends_with('#')) kept += '#';
  }
  return kept;
}

LogLevel Findings::Kind::level() const {
  return first.severity == Finding::Severity::Note ? LogLevel::Info : LogLevel::Warning;
}

std::string Findings::Kind::text() const {
  const std::int64_t more = count - printed - (printed == 0 ? 1 : 0);
  if (printed > 0) return fmt::format("{} more as this one: {}", more, textOf(first));
  return textOf(first) + (more > 0 ? fmt::format(" (and {} more)", more) : "");
}

void Findings::add(const std::string& stage, Finding finding) {
  const std::lock_guard lock(mutex_);
  const std::string key = fmt::format("{}\n{}\n{}\n{}", stage, enumName(finding.severity),
                                      enumName(finding.kind), withoutNumbers(finding.message));
  const auto [kind, is_new] = index_.try_emplace(key, kinds_.size());
  untaken_.push_back({std::move(finding), -1, stage});
  if (is_new) kinds_.push_back({untaken_.back(), 0, 0});
  ++kinds_[kind->second].count;
}

Status Findings::judge(const Status& status, std::int64_t frame) {
  const std::lock_guard lock(mutex_);
  for (; addressed_ < untaken_.size(); ++addressed_) untaken_[addressed_].frame = frame;
  const std::size_t begin = std::exchange(judged_, kinds_.size());
  if (policy_ == config::FindingPolicy::Continue && status.isOk()) return status;
  std::int64_t errors = 0;
  const Kind* first = nullptr;
  for (std::size_t i = begin; i < kinds_.size(); ++i) {
    Kind& kind = kinds_[i];
    if (kind.first.severity != Finding::Severity::Error) continue;
    if (first == nullptr) first = &kind;
    errors += kind.count;
    kind.printed = kind.count;  // by the failure that follows
  }
  if (first == nullptr || !status.isOk()) return status;
  const std::string more =
      errors > 1 ? fmt::format(" (and {} more; `tolman dataset check` lists all)", errors - 1) : "";
  return Status::invalidInput(textOf(first->first) + more +
                              "; to go on without what is wrong, set on_findings: continue");
}

std::vector<Findings::Kind> Findings::takeKinds(bool are_new) {
  const std::lock_guard lock(mutex_);
  std::vector<Kind> taken;
  for (Kind& kind : kinds_) {
    if (kind.printed == kind.count || (are_new && kind.printed > 0)) continue;
    taken.push_back(kind);
    kind.printed = kind.count;
  }
  return taken;
}

std::vector<record::RecordedFinding> Findings::take(bool at_end) {
  const std::lock_guard lock(mutex_);
  const auto end =
      untaken_.begin() + static_cast<std::ptrdiff_t>(at_end ? untaken_.size() : addressed_);
  std::vector<record::RecordedFinding> taken(std::make_move_iterator(untaken_.begin()),
                                             std::make_move_iterator(end));
  untaken_.erase(untaken_.begin(), end);
  addressed_ = 0;
  return taken;
}

}  // namespace tolman::engine
