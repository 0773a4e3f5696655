// SPDX-License-Identifier: BSD-3-Clause
#include "engine/services.hpp"

#include <spdlog/sinks/basic_file_sink.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <mutex>

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

}  // namespace tolman::engine
